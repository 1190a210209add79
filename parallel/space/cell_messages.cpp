#include "parallel/space/cell_messages.h"

#include "kernel/support/failure.h"
#include "parallel/grid_message.h"
#include "parallel/radiosity_message.h"

namespace hottel {
namespace {

void put_grid(const Grid3& grid, MessageWriter& writer) {
  put_place(writer, grid.origin.x, grid.origin.y, grid.origin.z);
  put_place(writer, grid.u.x, grid.u.y, grid.u.z);
  put_place(writer, grid.v.x, grid.v.y, grid.v.z);
  writer.put(grid.nu, grid.nv, grid.nw, grid.is_volume());
  if (grid.w) put_place(writer, grid.w->x, grid.w->y, grid.w->z);
}
Grid3 take_grid(MessageReader& reader) {
  Grid3 grid;
  take_place(reader, grid.origin.x, grid.origin.y, grid.origin.z);
  take_place(reader, grid.u.x, grid.u.y, grid.u.z);
  take_place(reader, grid.v.x, grid.v.y, grid.v.z);
  bool is_volume = false;
  reader.take_into(grid.nu, grid.nv, grid.nw, is_volume);
  if (!is_volume) return grid;
  Vector3& w = grid.w.emplace();
  take_place(reader, w.x, w.y, w.z);
  return grid;
}

}  // namespace

std::string cell_job_message_3(const CellJob3& job) {
  MessageWriter writer;
  put_elements_3(job.prepared, job.granularity, *job.prepared.elements(job.granularity), writer);
  put_grid(job.grid, writer);
  put_radiosities(job.solution, writer);
  return writer.bytes();
}

ReceivedCellJob3::ReceivedCellJob3(std::string_view bytes, KeptScene3& kept) {
  MessageReader reader(bytes);
  elements = take_elements_3(reader, kept);
  const Grid3 grid = take_grid(reader);
  solution = take_radiosities(reader);
  HOTTEL_REQUIRE(reader.is_at_end());
  light.emplace(*elements.prepared, elements.granularity, solution, grid);
}

}  // namespace hottel
