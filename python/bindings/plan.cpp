#include "python/bindings/plan.h"

#include <string>

#include "python/bindings/bindings.h"
#include "python/bindings/words.h"
#include "solver/plan.h"

namespace hottel::python {
namespace {

py::tuple effects_of(const PythonSimulation& simulation) {
  const auto plan = simulation.waited([](const AnySimulation& any, const StageProgress& progress) {
    return std::visit([&](const auto& each) { return each.plan(progress); }, any);
  });
  py::list effects;
  for (const PlannedEffect& effect : plan->effects()) effects.append(effect);
  return py::tuple(effects);
}

}  // namespace

void add_plan(py::module_& module) {
  py::class_<PlannedEffect>(module, "PlannedEffect", "One effect, simulated or not, and why: a line of `hottel plan`.")
      .def_readonly("effect", &PlannedEffect::effect, "What it is called, a str: 'occlusion', 'sky', ...")
      .def_readonly("used", &PlannedEffect::used, "Whether it is simulated, a bool.")
      .def_property_readonly(
          "reason", [](const PlannedEffect& effect) { return in_python(effect.reason); },
          "Why, or why not: a sentence for people, a str.")
      .def_readonly("seconds", &PlannedEffect::seconds_estimate,
                    "About what it takes on one core, a float [s]; 0 where it is not used.")
      .def("__repr__", [](const PlannedEffect& effect) {
        return "<hottel.PlannedEffect " + effect.effect + (effect.used ? ": " : ", not used: ") +
               in_python(effect.reason) + ">";
      });
}

void add_plan_questions(py::class_<PythonSimulation>& type) {
  type.def_property_readonly("plan", &effects_of,
                             "What is simulated of the scene, what not, and why: a tuple of PlannedEffect. An effect "
                             "is left\nout only where it cannot change a number.");
}

}  // namespace hottel::python
