// What a simulation does, and what not.
#pragma once

#include "python/bindings/simulation.h"

namespace hottel::python {

void add_plan_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
