// Radiosities, temperatures and net fluxes as Python holds them.
#pragma once

#include <pybind11/pybind11.h>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "io/results/radiosity_files.h"
#include "python/bindings/arrays.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel::python {

// A table of numbers: for each name and channel one of each column. Arrays are of shape (names, channels).
struct NumberTable {
  const char* what = "";
  std::vector<std::string> names, channels;
  py::array areas;   // by name
  py::dict columns;  // arrays by column
  std::string guarantee;
};

// Of radiosities: the elements that have a row, as in radiosity.csv.
struct PythonRadiosity : NumberTable {
  py::dict energy;
  std::vector<std::string> notes;
};
// Of temperatures, as in temperature.csv: elements that have none are left out, channels that have none are NaN.
struct PythonTemperatures : NumberTable {};
// Of net fluxes of faces, groups or lights, as in flux.csv.
struct PythonFlux : NumberTable {};

// Of numbers in W, where nobody knows the unit of length: NaN.
PythonRadiosity radiosity_table(const SceneTable& scene, const ExchangeMatrix& matrix,
                                const RadiositySolution& solution);
PythonTemperatures temperature_table(const SceneTable& scene, const ExchangeMatrix& matrix,
                                     const RadiositySolution& solution);
PythonFlux flux_table(const NetFluxes& all, const std::vector<NetFlux>& some, const std::string& guarantee);

}  // namespace hottel::python
