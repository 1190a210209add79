// What the module consists of: each adds its classes, in this order.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>             // optional
#include <pybind11/stl/filesystem.h>  // path

namespace hottel::python {

namespace py = pybind11;

void add_errors(py::module_& module);
void add_picture(py::module_& module);
void add_check(py::module_& module);
void add_scene(py::module_& module);
void add_generate(py::module_& module);
void add_factors(py::module_& module);
void add_root_sum(py::module_& module);
void add_radiosity(py::module_& module);
void add_visible(py::module_& module);
void add_visible_map(py::module_& module);
void add_grid(py::module_& module);
void add_graph(py::module_& module);
void add_critical(py::module_& module);
void add_sights(py::module_& module);
void add_oriented_light(py::module_& module);
void add_plan(py::module_& module);
void add_judgement(py::module_& module);
void add_simulation(py::module_& module);
void add_frames(py::module_& module);
void add_examples(py::module_& module);  // to the docstrings of all classes

}  // namespace hottel::python
