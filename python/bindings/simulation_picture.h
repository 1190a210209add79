// Pictures of what was simulated.
#pragma once

#include "python/bindings/simulation.h"

namespace hottel::python {

void add_picture_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
