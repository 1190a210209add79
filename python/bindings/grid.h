// Light on grids as Python holds it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "python/bindings/light_request.h"

namespace hottel::python {

// Values at the centres of cells, of shape (rows, columns, channels), of what is shown (rows, columns).
struct PythonGrid {
  py::array values{};
  std::variant<Grid2, Grid3> cells;
  std::vector<std::string> channels{};  // none of what is shown
  std::string name{}, unit{};
  std::optional<double> max_error{};

  // Of shape (rows, columns, 2 or 3), each coordinate the nearest double.
  py::array centres() const;
};

// show: nothing for the mean irradiance.
PythonGrid light_on_grid(const PythonSimulation& simulation, const GridKeywords& keywords,
                         const std::optional<std::string>& show, const std::optional<std::string>& channel);

void add_grid_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
