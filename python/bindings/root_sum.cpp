#include "python/bindings/root_sum.h"

#include <pybind11/operators.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kernel/rounding.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/numbers.h"
#include "solver/plane/simulation/queries.h"

namespace hottel::python {
namespace {

// Coefficients and radicands, by radicand.
py::tuple terms_of(const RootSum& sum) {
  std::vector<RootSum::Term> terms = sum.terms();
  std::ranges::sort(terms, {}, &RootSum::Term::radicand);
  py::list result;
  for (const RootSum::Term& term : terms)
    result.append(py::make_tuple(fraction_of(term.coefficient), int_of(term.radicand)));
  return py::tuple(result);
}

py::object sympy_of(const RootSum& sum) {
  const py::module_ sympy = py::module_::import("sympy");
  py::object result = sympy.attr("Integer")(0);
  for (const RootSum::Term& term : sum.terms()) {
    const py::object factor =
        sympy.attr("Rational")(int_of(term.coefficient.get_num()), int_of(term.coefficient.get_den()));
    result = result + factor * sympy.attr("sqrt")(int_of(term.radicand));
  }
  return result;
}

double rounded(const RootSum& sum) { return round_quotient(sum, RootSum(Rational(1))).number.value; }

RootSum exact(const PythonSimulation& simulation, const std::string& from, const std::string& to) {
  if (!simulation.is_plane())
    throw UsageError("closed forms are for scenes in the plane; this version does not have them in space");
  return simulation.waited([&](const AnySimulation& any, const StageProgress& progress) {
    const Simulation2& plane = std::get<Simulation2>(any);
    plane.prepared(progress);
    return exact_pair(plane, from, to).exchange;
  });
}

}  // namespace

void add_root_sum(py::module_& module) {
  py::class_<RootSum>(module, "RootSum",
                      "A sum of rational multiples of square roots of whole numbers, exactly. float() of it is the "
                      "nearest\ndouble; sums are added, subtracted, multiplied by numbers, and compared, without "
                      "rounding.")
      .def_property_readonly("terms", &terms_of,
                             "A tuple of (fractions.Fraction, int), coefficients and what stands under the root; 1 for "
                             "the\nrational part. Empty for 0.")
      .def("sympy", &sympy_of, "Returns the sum as SymPy has it. ImportError where that is not installed.")
      .def("sign", &RootSum::sign, "Returns -1, 0 or 1, an int: decided without rounding.")
      .def("__float__", &rounded)
      .def("__str__", &RootSum::to_string)
      .def("__repr__", [](const RootSum& sum) { return "<hottel.RootSum " + sum.to_string() + ">"; })
      .def(py::self + py::self)
      .def(py::self - py::self)
      .def(
          "__mul__",
          [](const RootSum& sum, const py::object& number) { return sum * rational_of(number, false, "a factor"); },
          py::is_operator())
      .def(
          "__rmul__",
          [](const RootSum& sum, const py::object& number) { return sum * rational_of(number, false, "a factor"); },
          py::is_operator())
      .def(
          "__eq__", [](const RootSum& a, const RootSum& b) { return (a - b).is_zero(); }, py::is_operator())
      .def(
          "__lt__", [](const RootSum& a, const RootSum& b) { return (a - b).sign() < 0; }, py::is_operator())
      .def("__bool__", [](const RootSum& sum) { return !sum.is_zero(); });
}

void add_root_sum_questions(py::class_<PythonSimulation>& type) {
  type.def("exact", &exact, py::arg("from_name"), py::arg("to_name"),
           "Returns the area times the view factor of a pair of the plane in closed form, RootSum, in units of the "
           "scene.\nUsageError for names that there are not, and in space.");
}

}  // namespace hottel::python
