// The module hottel._core, which is the library hottel.
#include "kernel/version.h"
#include "python/bindings/bindings.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Exact view factors and light of scenes in the plane and in space: the library itself.";
  module.attr("__version__") = hottel::kVersion;
  hottel::python::add_errors(module);
  hottel::python::add_picture(module);
  hottel::python::add_scene(module);
  hottel::python::add_check(module);
  hottel::python::add_generate(module);
  hottel::python::add_factors(module);
  hottel::python::add_root_sum(module);
  hottel::python::add_radiosity(module);
  hottel::python::add_visible(module);
  hottel::python::add_visible_map(module);
  hottel::python::add_grid(module);
  hottel::python::add_graph(module);
  hottel::python::add_critical(module);
  hottel::python::add_sights(module);
  hottel::python::add_oriented_light(module);
  hottel::python::add_plan(module);
  hottel::python::add_judgement(module);
  hottel::python::add_simulation(module);
  hottel::python::add_frames(module);
  hottel::python::add_examples(module);
}
