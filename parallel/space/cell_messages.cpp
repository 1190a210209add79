#include "parallel/space/cell_messages.h"

#include <cstdint>
#include <vector>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

void put_vector(const Rational& x, const Rational& y, const Rational& z, MessageWriter& writer) {
  for (const Rational* number : {&x, &y, &z}) writer.put_text(number->get_str());
}
template <class Vector>
Vector take_vector(MessageReader& reader) {
  Vector result;
  for (Rational* number : {&result.x, &result.y, &result.z}) *number = Rational(std::string(reader.take_text()));
  return result;
}

void put_grid(const Grid3& grid, MessageWriter& writer) {
  put_vector(grid.origin.x, grid.origin.y, grid.origin.z, writer);
  put_vector(grid.u.x, grid.u.y, grid.u.z, writer);
  put_vector(grid.v.x, grid.v.y, grid.v.z, writer);
  writer.put(grid.nu, grid.nv, grid.nw, grid.is_volume());
  if (grid.w) put_vector(grid.w->x, grid.w->y, grid.w->z, writer);
}
Grid3 take_grid(MessageReader& reader) {
  Grid3 grid;
  grid.origin = take_vector<Point3>(reader);
  grid.u = take_vector<Vector3>(reader);
  grid.v = take_vector<Vector3>(reader);
  bool is_volume = false;
  reader.take_into(grid.nu, grid.nv, grid.nw, is_volume);
  if (is_volume) grid.w = take_vector<Vector3>(reader);
  return grid;
}

}  // namespace

std::string cell_job_message_3(const CellJob3& job) {
  MessageWriter writer;
  put_elements_3(job.prepared, job.granularity, writer);
  put_grid(job.grid, writer);
  writer.put(std::uint64_t{job.solution.channels.size()});
  for (const ChannelSolution& channel : job.solution.channels) {
    std::vector<double> radiosities;
    for (const ElementRadiosity& element : channel.elements) radiosities.push_back(element.radiosity);
    writer.put_all(radiosities);
  }
  return writer.bytes();
}

ReceivedCellJob3::ReceivedCellJob3(std::string_view bytes, KeptScene3& kept) {
  MessageReader reader(bytes);
  elements = take_elements_3(reader, kept);
  const Grid3 grid = take_grid(reader);
  solution.channels.resize(reader.take<std::uint64_t>());
  for (ChannelSolution& channel : solution.channels)
    for (const double radiosity : reader.take_all<double>()) channel.elements.push_back({.radiosity = radiosity});
  HOTTEL_REQUIRE(reader.is_at_end());
  light.emplace(*elements.prepared, elements.granularity, solution, grid);
}

std::string lit_message_3(const LitCells3& lit) {
  MessageWriter writer;
  writer.put(std::uint64_t{lit.tasks.begin}, std::uint64_t{lit.tasks.end});
  writer.put_all(lit.values);
  return writer.bytes();
}

LitCells3 read_lit_3(std::string_view bytes) {
  MessageReader reader(bytes);
  LitCells3 lit;
  reader.take_into(lit.tasks.begin, lit.tasks.end);
  lit.values = reader.take_all<double>();
  HOTTEL_REQUIRE(reader.is_at_end());
  return lit;
}

}  // namespace hottel
