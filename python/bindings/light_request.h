// Where light between the faces is asked for, and what is shown of it, by names of options of the program.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "python/bindings/simulation.h"
#include "viewer/picture/shown_values.h"

namespace hottel::python {

// cells: two numbers, or None; over: a grid as a scene file has it, the name of one of the scene, or None. Without both
// the scene's own.
struct GridKeywords {
  py::object cells{py::none()}, over{py::none()};
  std::string illumination = "point";

  bool is_given() const { return !cells.is_none() || !over.is_none(); }
};

// Returns a version of the simulation with that grid, which shares all else. Throws UsageError where it makes no sense:
// in space where there is no grid, where `over` does not say which of several, RequestError where so many cells do not
// fit into memory.
std::shared_ptr<const AnySimulation> gridded(const PythonSimulation& simulation, const GridKeywords& keywords);

// Throws UsageError where that grid is a volume. what: what is of planar grids alone, "a picture".
void require_planar_grid(const PythonSimulation& simulation, const py::object& over, const std::string& what);

// What a picture or a grid shows of a scene. Throws UsageError for what is not there.
Shown shown_of(const SceneTable& scene, const std::string& show, const std::optional<std::string>& channel,
               const std::optional<std::string>& bar);

}  // namespace hottel::python
