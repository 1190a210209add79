// The visibility graph as Python holds it.
#pragma once

#include <string>
#include <vector>

#include "python/bindings/simulation.h"

namespace hottel::python {

// Vertices by number, and pairs of them that see each other: the columns of `hottel visibility --graph`.
struct PythonGraph {
  py::array vertices, pairs, lengths, along;
  std::vector<std::string> surfaces;  // by vertex
  std::vector<std::string> names;     // of along
};

void add_graph_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
