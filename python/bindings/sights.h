// What some point of a face in space sees, and the surfaces of lines along which that changes, as Python holds them.
#pragma once

#include <string>
#include <vector>

#include "python/bindings/simulation.h"

namespace hottel::python {

// What some point of a face sees: the lines of `hottel visibility --face`.
struct PythonFaceSight {
  std::vector<std::string> names;
  py::array is_whole;
};

// The event surfaces between two faces: the columns of `hottel visibility --events --from A --to B`.
struct PythonEvents {
  std::vector<std::string> kinds;
  py::array edges, vertices, others;
  std::vector<std::vector<std::string>> edge_of, crossing;
  py::array begin, t, rulings;
};

void add_sight_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
