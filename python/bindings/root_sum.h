// Closed forms as Python holds them.
#pragma once

#include "kernel/root_sum.h"
#include "python/bindings/simulation.h"

namespace hottel::python {

void add_root_sum_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
