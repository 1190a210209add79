// What is worth telling about a scene, and its repair.
#pragma once

#include <pybind11/pybind11.h>

#include "python/bindings/scene.h"

namespace hottel::python {

void add_check_questions(pybind11::class_<PythonScene>& type);

}  // namespace hottel::python
