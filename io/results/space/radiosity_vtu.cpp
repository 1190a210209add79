#include "io/results/space/radiosity_vtu.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/scene_names.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/unit_of_length.h"
#include "io/results/temperature_files.h"
#include "kernel/rational.h"
#include "kernel/written_double.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel {
namespace {

using Sink = std::function<void(std::string_view)>;

// The polygons of the grid.
using Cells = std::vector<const ElementTable3::Part*>;
Cells cells_of(const ElementTable3& table) {
  Cells cells;
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

// Points and polygons.
void write_shape(const Vertices3& vertices, const Cells& cells, const Sink& sink) {
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
  sink("      </Cells>\n");
}

// The characters of a text as numbers, and 0 at its end: a value of an array of type String.
std::string characters(const std::string& text) {
  std::string result;
  for (const char c : text) result += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
  return result + "0";
}

// Writes the arrays that have a value for each cell.
class CellData {
 public:
  CellData(const Cells& cells, const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
           const Sink& sink)
      : cells_(cells), scene_(scene), matrix_(matrix), solution_(solution), sink_(sink) {
    for (std::uint32_t i = 0, rows = 0; i < matrix.size(); ++i) id_.push_back(matrix.has_row(i) ? rows++ : rows);
  }

  void write_channels() const {
    for (const Quantity& quantity : kQuantities)
      write_components(quantity.first, solution_.channel_names, [&](std::uint32_t label) {
        std::vector<double> values;
        for (const ChannelSolution& channel : solution_.channels)
          values.push_back(quantity.second(channel.elements[label]));
        return values;
      });
    if (!has_known_unit(scene_)) return;
    std::vector<std::string> names = solution_.channel_names;
    if (scene_.has_bands) names.emplace_back("total");
    write_components("net_flux", names, [&](std::uint32_t label) {
      std::vector<double> values;
      for (const ChannelSolution& channel : solution_.channels)
        values.push_back(channel.elements[label].net() * area(label));
      if (scene_.has_bands) values.push_back(values[kSolarBand] + values[kThermalBand]);
      return values;
    });
  }

  void write_temperatures() const {
    if (!has_temperatures(scene_)) return;
    const ElementTemperatures temperatures(scene_.materials);
    const std::size_t first = scene_.has_bands ? kThermalBand : 0;
    const auto found = [&](std::uint32_t label, std::size_t channel) {
      return temperatures.of(*matrix_.elements()[label].material, solution_, channel, label);
    };
    write_components(
        "temperature",
        {solution_.channel_names.begin() + static_cast<std::ptrdiff_t>(first), solution_.channel_names.end()},
        [&](std::uint32_t label) {
          std::vector<double> values;
          for (std::size_t c = first; c < solution_.channels.size(); ++c) {
            const auto temperature = found(label, c);
            values.push_back(temperature ? temperature->value : 0);
          }
          return values;
        });
    write_integers("has_temperature", [&](std::uint32_t label) { return found(label, first) ? 1U : 0U; });
  }

  void write_elements() const {
    write_components("area", {}, [&](std::uint32_t label) { return std::vector{area(label)}; });
    write_components("sky_view_factor", {},
                     [&](std::uint32_t label) { return std::vector{matrix_.factor(label, matrix_.sky()).value}; });
    write_integers("id", [&](std::uint32_t label) { return id_[label]; });
    write_integers("surface", [&](std::uint32_t label) { return element(label).surface; });
    write_integers("is_back", [&](std::uint32_t label) { return element(label).is_back ? 1U : 0U; });
    write_integers("element", [&](std::uint32_t label) { return element(label).part; });
  }

  void write_texts() const {
    write_strings("name", [&](const Element& its) { return its.name; });
    write_strings("face", [&](const Element& its) { return face_name(scene_, {its.surface, its.is_back}); });
    write_strings("group", [&](const Element& its) { return scene_.groups[scene_.surfaces[its.surface].group].name; });
    write_strings("material", [&](const Element& its) { return scene_.materials[*its.material].name; });
  }

 private:
  const Element& element(std::uint32_t label) const { return matrix_.elements()[label]; }
  double area(std::uint32_t label) const { return element(label).area.value; }

  // A number for each name; without names one.
  template <class Values>
  void write_components(const char* name, const std::vector<std::string>& components, const Values& values) const {
    std::string attributes = std::string("type=\"Float64\" Name=\"") + name + "\" NumberOfComponents=\"" +
                             std::to_string(std::max<std::size_t>(1, components.size())) + "\"";
    for (std::size_t c = 0; c < components.size(); ++c)
      attributes += " ComponentName" + std::to_string(c) + "=\"" + components[c] + "\"";
    write_array(
        attributes, cells_.size(),
        [&](std::size_t k) {
          std::string text;
          for (const double value : values(cells_[k]->label)) text += (text.empty() ? "" : " ") + shortest(value);
          return text;
        },
        sink_);
  }
  template <class Value>
  void write_integers(const char* name, const Value& value) const {
    write_array(
        std::string("type=\"Int32\" Name=\"") + name + "\"", cells_.size(),
        [&](std::size_t k) { return std::to_string(value(cells_[k]->label)); }, sink_);
  }
  template <class Text>
  void write_strings(const char* name, const Text& text) const {
    write_array(
        std::string("type=\"String\" Name=\"") + name + "\"", cells_.size(),
        [&](std::size_t k) { return characters(text(element(cells_[k]->label))); }, sink_);
  }

  const Cells& cells_;
  const SceneTable& scene_;
  const ExchangeMatrix& matrix_;
  const RadiositySolution& solution_;
  const Sink& sink_;
  std::vector<std::uint32_t> id_;  // by element
};

}  // namespace

void write_radiosity_vtu(const PreparedScene3& prepared, Granularity granularity, const ExchangeMatrix& matrix,
                         const RadiositySolution& solution, const Sink& sink) {
  const ElementTable3& table = *prepared.elements(granularity);
  const Cells cells = cells_of(table);
  write_shape(prepared.occluders().vertices(), cells, sink);
  sink("      <CellData Scalars=\"radiosity\">\n");
  const CellData data(cells, prepared.scene, matrix, solution, sink);
  data.write_channels();
  data.write_temperatures();
  data.write_elements();
  data.write_texts();
  sink("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace hottel
