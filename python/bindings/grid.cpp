#include "python/bindings/grid.h"

#include <memory>
#include <utility>

#include "io/results/space/light_region.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "solver/plane/light/oriented_lights.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/space/light/oriented_lights.h"

namespace hottel::python {
namespace {

// What came of it, with nothing of Python.
struct FoundLight {
  std::variant<Grid2, Grid3> cells;
  std::vector<double> values{};
  std::vector<std::string> channels{};
  std::optional<ShownValues> shown{};
  std::optional<double> max_error{};
};

FoundLight found(const Simulation2& simulation, const std::optional<Shown>& shown, const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const auto light = simulation.light(progress);
  FoundLight result{.cells = light->grid.grid, .channels = solution->channel_names, .max_error = light->max_error};
  if (!shown) {
    result.values = light->grid.values;
    return result;
  }
  const auto lights = lights_around_cells(*simulation.prepared(), light->grid, telling("light on the grid", progress));
  result.shown = shown_at_points(*shown, lights, solution->channel_names);
  return result;
}

FoundLight found(const Simulation3& simulation, const std::optional<Shown>& shown, const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  FoundLight result{.cells = *simulation.grid(), .channels = solution->channel_names};
  if (!shown) {
    const auto light = simulation.light(progress);
    result.values = light->values;
    result.max_error = light->max_error();
    return result;
  }
  if (simulation.grid()->is_volume()) {
    if (needs_a_side(*shown)) throw UsageError("a volume shows 'temperature' alone: areas in it look no way");
    result.shown = shown_at_points(*shown, lights_around(*simulation.light(progress)), solution->channel_names);
    return result;
  }
  const auto lights = oriented_lights_on_grid(*simulation.prepared(), simulation.request().factors.granularity,
                                              *solution, *simulation.grid(), telling("light on the grid", progress));
  result.shown = shown_at_points(*shown, lights, solution->channel_names);
  return result;
}

// The shape of an array of one number a cell.
std::vector<py::ssize_t> shape_of(const std::variant<Grid2, Grid3>& cells) {
  if (const auto* const plane = std::get_if<Grid2>(&cells)) return {plane->ny, plane->nx};
  const std::vector<std::size_t> shape = array_shape(std::get<Grid3>(cells));
  return {shape.begin(), shape.end()};
}

// The same of so many numbers a cell.
std::vector<py::ssize_t> shape_of(const std::variant<Grid2, Grid3>& cells, std::size_t numbers) {
  std::vector<py::ssize_t> shape = shape_of(cells);
  shape.push_back(static_cast<py::ssize_t>(numbers));
  return shape;
}

// "4 x 3": along the first direction first.
std::string cells_text(const std::variant<Grid2, Grid3>& cells) {
  std::string text;
  for (const py::ssize_t count : shape_of(cells)) text = std::to_string(count) + (text.empty() ? "" : " x ") + text;
  return text;
}

// The centre of a cell of so many between two numbers.
double between(const Rational& low, const Rational& high, std::uint32_t cell, std::uint32_t count) {
  return to_double(low + (high - low) * Rational(2 * cell + 1) / Rational(2 * count));
}

std::vector<double> centres_of(const Grid2& grid) {
  std::vector<double> columns, result;
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix) columns.push_back(between(grid.min.x, grid.max.x, ix, grid.nx));
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy) {
    const double y = between(grid.min.y, grid.max.y, iy, grid.ny);
    for (const double x : columns) result.insert(result.end(), {x, y});
  }
  return result;
}

std::vector<double> centres_of(const Grid3& grid) {
  std::vector<double> result;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell)
    for (const double x : to_doubles(cell_centre(grid, cell))) result.push_back(x);
  return result;
}

const char* unit_of_light(const std::string& illumination) {
  return illumination == "inverse-square" ? "W/m³" : kRadiosityUnit;
}

}  // namespace

py::array PythonGrid::centres() const {
  return frozen(std::visit([](const auto& grid) { return centres_of(grid); }, cells),
                shape_of(cells, std::holds_alternative<Grid2>(cells) ? 2 : 3));
}

PythonGrid light_on_grid(const PythonSimulation& simulation, const GridKeywords& keywords,
                         const std::optional<std::string>& show, const std::optional<std::string>& channel) {
  std::optional<Shown> shown;
  if (show) shown = shown_of(simulation.scene().table(), *show, channel, std::nullopt);
  if (shown && !is_of_points(*shown))
    throw UsageError("a grid shows 'irradiance', 'temperature' or 'sky', not '" + *show + "'");
  if (channel && !shown) throw UsageError("channel goes with show: without it there is a column for each channel");
  if (shown && keywords.illumination == "inverse-square")
    throw UsageError("show goes with light at points, not with illumination='inverse-square'");
  const auto asked = gridded(simulation, keywords);
  FoundLight light = without_lock(simulation.options().waiting, [&](const StageProgress& progress) {
    return std::visit([&](const auto& each) { return found(each, shown, progress); }, *asked);
  });
  PythonGrid grid{.cells = std::move(light.cells), .max_error = light.max_error};
  if (light.shown) {
    grid.values = frozen(light.shown->numbers(), shape_of(grid.cells));
    grid.name = light.shown->name;
    grid.unit = light.shown->unit;
    return grid;
  }
  grid.values = frozen(std::move(light.values), shape_of(grid.cells, light.channels.size()));
  grid.channels = std::move(light.channels);
  grid.name = "mean irradiance";
  grid.unit = unit_of_light(keywords.illumination);
  return grid;
}

void add_grid(py::module_& module) {
  py::class_<PythonGrid>(
      module, "Grid",
      "Light at the centres of the cells of a grid. Index 0 is the lowest row, in space that at the\n"
      "origin; columns run along x, in space along u. A volume has layers of rows, along w.")
      .def_readonly("values", &PythonGrid::values,
                    "float64 of shape (rows, columns, channels), of what was asked for by `show` (rows, columns), of\n"
                    "a volume with the layers before the rows, in `unit`. NaN in solids, and where nothing has a "
                    "value. Read only.")
      .def_property_readonly(
          "centres", &PythonGrid::centres,
          "Where the cells have their centres, float64 of shape (rows, columns, 2), in space 3, of a\n"
          "volume (layers, rows, columns, 3), in units of the scene, each coordinate the nearest double. Read only.")
      .def_property_readonly(
          "channels", [](const PythonGrid& grid) { return tuple_of(grid.channels); },
          "What values have a column each for, a tuple of str; none of what was asked for by `show`.")
      .def_readonly("name", &PythonGrid::name, "What it is, a str: 'mean irradiance', 'sky view factor', ...")
      .def_readonly("unit", &PythonGrid::unit, "The unit of values, a str: 'W/m²', 'K', '1'.")
      .def_readonly("max_error", &PythonGrid::max_error,
                    "With illumination='average' a proven bound of the error of every value, a float; else None.")
      .def("__repr__", [](const PythonGrid& grid) {
        return "<hottel.Grid of " + cells_text(grid.cells) + " cells, " + grid.name + " [" + grid.unit + "]>";
      });
}

void add_grid_questions(py::class_<PythonSimulation>& type) {
  type.def(
      "grid",
      [](const PythonSimulation& simulation, const py::object& cells, const std::optional<std::string>& show,
         const std::optional<std::string>& channel, const py::object& over, const std::string& illumination) {
        return light_on_grid(simulation, {cells, over, illumination}, show, channel);
      },
      py::arg("cells") = py::none(), py::kw_only(), py::arg("show") = py::none(), py::arg("channel") = py::none(),
      py::arg("over") = py::none(), py::arg("illumination") = "point",
      "Returns light at the centres of the cells of a grid, Grid: without `show` the mean irradiance, over all\n"
      "directions; with it 'irradiance', 'temperature' (the mean radiant one, [K]) or 'sky' (the view factor to it),\n"
      "in the plane over all directions, in space on areas that look along u x v, so that a volume has the\n"
      "temperature alone.\n\n"
      "cells: (nx, ny), of a volume (nu, nv, nw), by default those of the scene's grid, in the plane else 256 along "
      "the longer side of the\n"
      "scene. over: a dict, a grid as a scene file has it, in place of the scene's; or, of several grids, the\n"
      "name of one. channel: of irradiance. illumination: 'point', 'average' (over cells, with a proven bound; in "
      "space\n"
      "the irradiance of cells on the side of u x v) or in the plane 'inverse-square'. Throws UsageError for\n"
      "what makes no sense, InputError for a grid that is none, RequestError as of radiosity.");
}

}  // namespace hottel::python
