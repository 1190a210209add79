// Critical points and lines as Python holds them.
#pragma once

#include <string>
#include <vector>

#include "kernel/rational.h"
#include "python/bindings/simulation.h"

namespace hottel::python {

// The critical points of a face with respect to another one, by ascending t.
struct PythonCriticalPoints {
  py::array t, points, near, far, is_jump;
  std::vector<Rational> exact_t;
};

// The critical lines of a scene: the columns of `hottel visibility --events`.
struct PythonCriticalLines {
  py::array vertices, ends;
  std::vector<std::string> along;                   // by line, empty where the segment is free
  std::vector<std::vector<std::string>> met, seen;  // by line, four each
};

void add_critical_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
