// Frames of a scene whose lights move.
#pragma once

#include "python/bindings/simulation.h"

namespace hottel::python {

void add_frames_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
