#include "io/results/space/radiosity_vtu.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/element_table.h"
#include "kernel/rational.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Sink = std::function<void(std::string_view)>;

// The polygons of the grid.
std::vector<const ElementTable3::Part*> cells_of(const ElementTable3& table) {
  std::vector<const ElementTable3::Part*> cells;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    if (!table.has_row(label)) continue;
    for (const ElementTable3::Part& part : table.free_parts(label)) cells.push_back(&part);
  }
  return cells;
}

template <class Text>
void write_array(const std::string& attributes, std::size_t count, const Text& text, const Sink& sink) {
  sink("        <DataArray " + attributes + " format=\"ascii\">\n");
  for (std::size_t k = 0; k < count; ++k) sink("          " + text(k) + "\n");
  sink("        </DataArray>\n");
}

std::string number(const Rational& coordinate) {
  const double written = written_double(coordinate);
  require_double(written, "a coordinate of a corner in radiosity.vtu");
  return shortest(written);
}

using Quantity = std::pair<const char*, double (*)(const ElementRadiosity&)>;
constexpr std::array<Quantity, 7> kQuantities{
    {{"radiosity", [](const ElementRadiosity& e) { return e.radiosity; }},
     {"lower", [](const ElementRadiosity& e) { return e.lower; }},
     {"upper", [](const ElementRadiosity& e) { return e.upper; }},
     {"irradiance", [](const ElementRadiosity& e) { return e.irradiance; }},
     {"net", [](const ElementRadiosity& e) { return e.net(); }},
     {"emission", [](const ElementRadiosity& e) { return e.emission; }},
     {"reflectivity", [](const ElementRadiosity& e) { return e.reflectivity; }}}};

}  // namespace

void write_radiosity_vtu(const PreparedScene3& prepared, Granularity granularity, const ExchangeMatrix& matrix,
                         const RadiositySolution& solution, const Sink& sink) {
  const Vertices3& vertices = prepared.blockers().vertices();
  const ElementTable3 table(prepared.scene, prepared.arrangement(), prepared.blockers(), granularity);
  const std::vector<const ElementTable3::Part*> cells = cells_of(table);
  std::vector<Point3> points;
  std::vector<std::size_t> ends;
  for (const ElementTable3::Part* cell : cells) {
    for (Point3& corner : corners_of(vertices, cell->patch)) points.push_back(std::move(corner));
    ends.push_back(points.size());
  }
  sink(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" +
      std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(cells.size()) + "\">\n      <Points>\n");
  write_array(
      "type=\"Float64\" NumberOfComponents=\"3\"", points.size(),
      [&](std::size_t k) {
        const Point3& p = points[k];
        return number(p.x) + " " + number(p.y) + " " + number(p.z);
      },
      sink);
  sink("      </Points>\n      <Cells>\n");
  write_array(
      "type=\"Int64\" Name=\"connectivity\"", points.size(), [](std::size_t k) { return std::to_string(k); }, sink);
  write_array(
      "type=\"Int64\" Name=\"offsets\"", cells.size(), [&](std::size_t k) { return std::to_string(ends[k]); }, sink);
  write_array(
      "type=\"UInt8\" Name=\"types\"", cells.size(), [](std::size_t) { return std::string("7"); }, sink);
  sink("      </Cells>\n      <CellData Scalars=\"radiosity\">\n");
  for (const Quantity& quantity : kQuantities)
    write_array(
        "type=\"Float64\" Name=\"" + std::string(quantity.first) + "\" NumberOfComponents=\"" +
            std::to_string(solution.channels.size()) + "\"",
        cells.size(),
        [&](std::size_t k) {
          std::string text;
          for (const ChannelSolution& channel : solution.channels)
            text += (text.empty() ? "" : " ") + shortest(quantity.second(channel.elements[cells[k]->label]));
          return text;
        },
        sink);
  const auto element = [&](std::size_t k) -> const Element& { return matrix.elements()[cells[k]->label]; };
  write_array(
      "type=\"Int32\" Name=\"surface\"", cells.size(),
      [&](std::size_t k) { return std::to_string(element(k).surface); }, sink);
  write_array(
      "type=\"Int32\" Name=\"is_back\"", cells.size(),
      [&](std::size_t k) { return std::string(element(k).is_back ? "1" : "0"); }, sink);
  write_array(
      "type=\"Int32\" Name=\"element\"", cells.size(), [&](std::size_t k) { return std::to_string(element(k).part); },
      sink);
  sink("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace hottel
