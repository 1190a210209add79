#include "python/bindings/light_request.h"

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/grid_names.h"
#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "solver/plane/light/light_values.h"

namespace hottel::python {
namespace {

std::uint32_t count_of(const py::object& number, std::uint32_t most) {
  if (py::isinstance<py::bool_>(number) || PyIndex_Check(number.ptr()) == 0)
    throw py::type_error("cells are two whole numbers, (nx, ny)");
  const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
  if (!whole) throw py::error_already_set();
  int is_beyond = 0;
  const long long value = PyLong_AsLongLongAndOverflow(whole.ptr(), &is_beyond);
  if (is_beyond != 0 || value < 1 || value > most)
    throw UsageError("cells are numbers from 1 to " + std::to_string(most));
  return static_cast<std::uint32_t>(value);
}

// So many of them as a grid has directions.
std::optional<std::vector<std::uint32_t>> cells_of(const py::object& cells, std::size_t directions,
                                                   std::uint32_t most) {
  if (cells.is_none()) return std::nullopt;
  if (!py::isinstance<py::sequence>(cells) || py::isinstance<py::str>(cells))
    throw py::type_error("cells are two whole numbers, (nx, ny)");
  const auto given = py::reinterpret_borrow<py::sequence>(cells);
  if (given.size() != directions)
    throw UsageError(std::string(directions == 2 ? "cells are two whole numbers, (nx, ny)"
                                                 : "cells of a volume are three whole numbers, (nu, nv, nw)") +
                     ", not " + std::to_string(given.size()));
  std::vector<std::uint32_t> counts;
  for (std::size_t k = 0; k < directions; ++k) counts.push_back(count_of(given[k], most));
  return counts;
}

// A grid by itself is read as that of a scene of one surface.
ValidScene scene_with_grid(const py::object& over, bool is_plane) {
  if (!py::isinstance<py::dict>(over)) throw py::type_error("over is a dict, a grid as a scene file has it");
  py::dict surface, materials, table;
  surface["name"] = "surface";
  surface["material"] = "material";
  surface["points"] =
      py::module_::import("json").attr("loads")(is_plane ? "[[0, 0], [1, 0]]" : "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]");
  materials["material"] = py::dict();
  table["dimension"] = is_plane ? 2 : 3;
  table["materials"] = materials;
  table[is_plane ? "edges" : "polygons"] = py::make_tuple(surface);
  table["grid"] = over;
  return scene_of(table).scene();
}

void require_room(std::uint64_t cells, int channels, std::optional<std::int64_t> memory) {
  const std::uint64_t bytes = cells * static_cast<std::uint64_t>(channels) * sizeof(double);
  const std::uint64_t allowed = memory_allowed(static_cast<std::uint64_t>(memory.value_or(0)));
  if (bytes > allowed)
    throw RequestError("light on " + std::to_string(cells) + " cells takes " + std::to_string(bytes) +
                       " bytes of memory; allowed are " + std::to_string(allowed));
}

// The grid that `over` is or names, without it the only one of the scene; nothing where there is none.
template <class AnyScene>
auto grids_over(const AnyScene& scene, const py::object& over) -> decltype(AnyScene::grids) {
  if (py::isinstance<py::str>(over)) {
    const auto name = over.cast<std::string>();
    if (const auto* const found = grid_called(scene.grids, name)) return {*found};
    throw UsageError("there is no grid called " + quoted_name(name) +
                     (scene.grids.empty() ? "; the scene has none" : ", only: " + names_of_grids(scene.grids)));
  }
  constexpr bool kIsPlane = std::is_same_v<AnyScene, Scene2>;
  using AnyValidScene = std::conditional_t<kIsPlane, ValidScene2, ValidScene3>;
  if (!over.is_none()) return std::get<AnyValidScene>(scene_with_grid(over, kIsPlane))->grids;
  if (scene.grids.size() > 1)
    throw UsageError("the scene has several grids, of which over='NAME' is one: " + names_of_grids(scene.grids));
  return scene.grids;
}

AnySimulation in_plane(const PythonSimulation& simulation, const GridKeywords& keywords) {
  const Simulation2& before = simulation.in_the_plane();
  const auto kind = light_kind_2(keywords.illumination);
  if (!kind)
    throw UsageError("illumination is one of 'point', 'average', 'inverse-square', not '" + keywords.illumination +
                     "'");
  SimulationRequest2 request = before.request();
  request.light = *kind;
  const std::vector<Grid2> given = grids_over(before.scene(), keywords.over);
  request.grid = given.empty() ? default_grid(before.scene()) : given.front();
  if (const auto cells = cells_of(keywords.cells, 2, kMaxGridCells)) {
    if (given.empty()) request.grid = grid_over(before.scene(), (*cells)[0], (*cells)[1]);
    request.grid->nx = (*cells)[0];
    request.grid->ny = (*cells)[1];
  }
  require_room(request.grid->cells(), channel_count(before.scene()), simulation.options().memory);
  return before.with_request(std::move(request));
}

Grid3 grid_over(const Scene3& scene, const py::object& over) {
  if (const std::vector<Grid3> grids = grids_over(scene, over); !grids.empty()) return grids.front();
  throw UsageError(
      "a scene in space has light on a grid where it says so, and this one does not: over={\"origin\": [x, y, z], "
      "\"u\": [x, y, z], \"v\": [x, y, z], \"cells\": [N, N]}");
}

AnySimulation in_space(const PythonSimulation& simulation, const GridKeywords& keywords) {
  if (keywords.illumination != "point" && keywords.illumination != "average")
    throw UsageError("illumination in space is 'point' or 'average', not '" + keywords.illumination + "'");
  const Simulation3& before = simulation.in_space();
  SimulationRequest3 request = before.request();
  request.light.grid = grid_over(before.scene(), keywords.over);
  request.light.is_average = keywords.illumination == "average";
  Grid3& grid = *request.light.grid;
  if (const auto cells = cells_of(keywords.cells, grid.is_volume() ? 3 : 2, kMaxGridCells3)) {
    grid.nu = (*cells)[0];
    grid.nv = (*cells)[1];
    if (grid.is_volume()) grid.nw = (*cells)[2];
  }
  require_room(grid.cells(), channel_count(before.scene()), simulation.options().memory);
  return before.with_request(request);
}

}  // namespace

void require_planar_grid(const PythonSimulation& simulation, const py::object& over, const std::string& what) {
  if (!simulation.is_plane() && grid_over(simulation.in_space().scene(), over).is_volume())
    throw UsageError(what + " is of light on planar grids, and this one is a volume");
}

std::shared_ptr<const AnySimulation> gridded(const PythonSimulation& simulation, const GridKeywords& keywords) {
  return std::make_shared<const AnySimulation>(simulation.is_plane() ? in_plane(simulation, keywords)
                                                                     : in_space(simulation, keywords));
}

Shown shown_of(const SceneTable& scene, const std::string& show, const std::optional<std::string>& channel,
               const std::optional<std::string>& bar) {
  Shown shown = shown_by(show);
  if (bar) shown.scale = scale_by(*bar);
  if (channel) choose_channel(shown, *channel);
  require_shown(shown, scene);
  return shown;
}

}  // namespace hottel::python
