#include "python/bindings/judgement.h"

#include <array>
#include <utility>

#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

template <class Item>
py::tuple all_of(const std::vector<Item>& items) {
  py::list list;
  for (const Item& item : items) list.append(item);
  return py::tuple(list);
}

void add_verdict_class(py::module_& module) {
  py::class_<PythonFault>(module, "Fault", "One thing that is wrong with a matrix of view factors, with its evidence.")
      .def_readonly("kind", &PythonFault::kind,
                    "A stable word, a str: 'transposed', 'constant-factor', 'no-occlusion', ...")
      .def_property_readonly(
          "parts", [](const PythonFault& fault) { return tuple_of(fault.parts); },
          "What was done at once, to every pair: a tuple of words as `kind`, which is the first of them.")
      .def_readonly("words", &PythonFault::words, "One sentence for people, a str.")
      .def_readonly("explained", &PythonFault::explained,
                    "How many pairs are off, and are not once this is allowed for, an int.")
      .def_property_readonly(
          "worst", [](const PythonFault& fault) { return all_of(fault.worst); },
          "The worst of these, a tuple of (from, to, value, exact).")
      .def("__repr__",
           [](const PythonFault& fault) { return "<hottel.Fault " + fault.kind + ": " + fault.words + ">"; });
  py::class_<PythonVerdict> type(
      module, "Verdict",
      "What is to be said of a matrix of view factors of others: how many pairs are off, "
      "which\nlaws it breaks, and what would explain it. Findings are readings, not proofs.");
  const auto number = [&type](const char* name, std::uint64_t Verdict::*member, const char* doc) {
    type.def_property_readonly(
        name, [member](const PythonVerdict& each) { return each.verdict.*member; }, doc);
  };
  number("pairs", &Verdict::pairs, "How many pairs were judged, an int.");
  number("off", &Verdict::off, "How many are off by more than `beyond` and the digits left out, an int.");
  number("unsymmetric", &Verdict::unsymmetric, "How many pairs break A F = (A F) transposed, an int.");
  number("rows_off", &Verdict::rows_off, "How many rows do not sum to what they are to, an int.");
  number("negative", &Verdict::negative, "How many factors are below 0, an int.");
  number("above_one", &Verdict::above_one, "How many factors are above 1, an int.");
  number("unexplained", &Verdict::unexplained, "How many pairs are off by no fault that is known, an int.");
  type.def_property_readonly(
          "findings", [](const PythonVerdict& each) { return all_of(each.findings); },
          "What explains the pairs that are off, a tuple of Fault; what explains most comes first.")
      .def_property_readonly(
          "worst_unexplained", [](const PythonVerdict& each) { return all_of(each.unexplained); },
          "The worst pairs that nothing explains, a tuple of (from, to, value, exact).")
      .def_property_readonly(
          "sentences", [](const PythonVerdict& each) { return tuple_of(each.sentences); },
          "The verdict in words, the most important first, a tuple of str.")
      .def("__repr__", [](const PythonVerdict& each) {
        return "<hottel.Verdict: " + (each.sentences.empty() ? std::string("nothing to say") : each.sentences[0]) + ">";
      });
}

void add_pair_class(py::module_& module) {
  py::class_<ExplainedPair>(module, "JudgedPair", "A view factor that is wrong, and what may make it hard.")
      .def_readonly("from_name", &ExplainedPair::from, "The name of the element that light leaves, a str.")
      .def_readonly("to_name", &ExplainedPair::to, "The name of the element that it reaches, or 'sky', a str.")
      .def_property_readonly(
          "value", [](const ExplainedPair& pair) { return pair.error.value; }, "What the method says, a float.")
      .def_property_readonly(
          "exact", [](const ExplainedPair& pair) { return pair.error.exact; },
          "What it is by the exact method, a float.")
      .def_property_readonly(
          "visibility", [](const ExplainedPair& pair) { return pair.explanation.visibility; },
          "How much of it is not hidden, a float from 0 to 1; None where they do not face each other.")
      .def_property_readonly(
          "distance", [](const ExplainedPair& pair) { return pair.explanation.distance; },
          "Between their middles, a float in units of the scene; None of the sky.")
      .def_property_readonly(
          "angle", [](const ExplainedPair& pair) { return pair.explanation.angle; },
          "Between their normals, a float in degrees; None of the sky.")
      .def_property_readonly(
          "reason", [](const ExplainedPair& pair) { return pair.explanation.reason; },
          "In words, a str: 'partly hidden, touching'.")
      .def("__repr__", [](const ExplainedPair& pair) {
        return "<hottel.JudgedPair " + pair.from + " -> " + pair.to + ": " + shortest(pair.error.value) + ", exact " +
               shortest(pair.error.exact) + ", " + pair.explanation.reason + ">";
      });
}

void add_judgement_class(py::module_& module) {
  py::class_<PythonJudgement>(module, "Judgement",
                              "A method, or view factors of others, held against the exact factors of the same "
                              "elements.")
      .def_property_readonly(
          "method", [](const PythonJudgement& each) { return each.result.info.name; },
          "What it is called, a str; 'array' where factors were given.")
      .def_property_readonly(
          "seconds", [](const PythonJudgement& each) { return each.result.timing.median; },
          "What the factors took, a float [s], the median; NaN where they were given.")
      .def_property_readonly(
          "max_error", [](const PythonJudgement& each) { return each.result.errors.max; },
          "max |F - exact F| over pairs that are present in either matrix, a float.")
      .def_property_readonly(
          "rms_error", [](const PythonJudgement& each) { return each.result.errors.rms; },
          "The root of the mean of (F - exact F) squared, a float.")
      .def_property_readonly(
          "closure", [](const PythonJudgement& each) { return each.result.errors.closure; },
          "How far a row is from the sum of 1, at most, a float.")
      .def_property_readonly(
          "max_radiosity_error", [](const PythonJudgement& each) { return each.result.max_radiosity_error; },
          "max |B - exact B| / max |exact B|, a float; infinite where the matrix has no radiosities, None where the\n"
          "scene has none.")
      .def_property_readonly(
          "declared_error", [](const PythonJudgement& each) { return each.result.declared_error; },
          "What the method claims of max_error, a float, or None.")
      .def_property_readonly(
          "worst", [](const PythonJudgement& each) { return all_of(each.worst); },
          "The pairs that are the most wrong, the worst first, a tuple of JudgedPair.")
      .def_readonly("verdict", &PythonJudgement::verdict,
                    "What is wrong with view factors of others, Verdict; None of hottel's own methods.")
      .def_property_readonly(
          "notes", [](const PythonJudgement& each) { return tuple_of(each.result.notes); },
          "What the method and the comparison tell, a tuple of str.")
      .def("__repr__", [](const PythonJudgement& each) {
        return "<hottel.Judgement of " + each.result.info.name + ": off by " + shortest(each.result.errors.max) +
               " at most>";
      });
}

void add_radiosity_class(py::module_& module) {
  py::class_<PythonRadiosityJudgement>(module, "RadiosityJudgement",
                                       "Radiosities of others held against the proven bounds of the exact ones.")
      .def_property_readonly(
          "count", [](const PythonRadiosityJudgement& each) { return each.verdict.count; },
          "How many values were judged, an int.")
      .def_property_readonly(
          "outside", [](const PythonRadiosityJudgement& each) { return each.verdict.outside; },
          "How many lie outside the proven bounds, whatever digits were left out, an int.")
      .def_property_readonly(
          "max_error", [](const PythonRadiosityJudgement& each) { return each.verdict.max_error; },
          "max |B - exact B| / max |exact B|, a float.")
      .def_property_readonly(
          "hypothesis", [](const PythonRadiosityJudgement& each) { return each.verdict.hypothesis; },
          "What most of those outside are, in words, a str; empty where nothing explains them.")
      .def_property_readonly(
          "worst", [](const PythonRadiosityJudgement& each) { return all_of(each.worst); },
          "The worst of those outside, a tuple of (name, channel, value, exact, lower, upper).")
      .def_property_readonly(
          "sentences", [](const PythonRadiosityJudgement& each) { return tuple_of(each.sentences); },
          "The verdict in words, a tuple of str.")
      .def("__repr__", [](const PythonRadiosityJudgement& each) {
        return "<hottel.RadiosityJudgement: " + std::to_string(each.verdict.outside) + " of " +
               std::to_string(each.verdict.count) + " outside the proven bounds>";
      });
}

// One number of each channel.
template <class Number>
void add_by_channel(py::class_<PythonGridJudgement>& type, const char* name, Number GridErrors::*member,
                    const char* doc) {
  type.def_property_readonly(
      name,
      [member](const PythonGridJudgement& each) {
        std::vector<Number> values;
        for (const GridErrors& errors : each.errors) values.push_back(errors.*member);
        return frozen(std::move(values));
      },
      doc);
}

void add_grid_class(py::module_& module) {
  py::class_<PythonGridJudgement> type(module, "GridJudgement",
                                       "Light of others on a grid held against the exact light of the same cells.");
  type.def_property_readonly(
      "channels", [](const PythonGridJudgement& each) { return tuple_of(each.channels); },
      "What arrays have a number each for, a tuple of c str.");
  add_by_channel(type, "cells", &GridErrors::cells, "Cells in which both have a value, uint64 of shape (c,).");
  add_by_channel(type, "missing", &GridErrors::missing, "Cells of which only the exact light has one, shape (c,).");
  add_by_channel(type, "extra", &GridErrors::extra, "Cells of which only the other has one, shape (c,).");
  add_by_channel(type, "off", &GridErrors::off, "Cells that are wrong by more than was allowed, shape (c,).");
  add_by_channel(type, "max_error", &GridErrors::max, "The largest error, float64 of shape (c,), [W/m2].");
  add_by_channel(type, "rms_error", &GridErrors::rms, "The root mean square, shape (c,), [W/m2].");
  add_by_channel(type, "largest", &GridErrors::largest, "The largest exact value, shape (c,), [W/m2].");
  type.def_readonly(
          "reading", &PythonGridJudgement::reading,
          "How a grid reads that is off, a str: 'upside down', 'times 2 pi'; empty where nothing explains it.")
      .def_property_readonly(
          "sentences", [](const PythonGridJudgement& each) { return tuple_of(each.sentences); },
          "The verdict in words, a tuple of str.")
      .def("__repr__", [](const PythonGridJudgement& each) {
        return "<hottel.GridJudgement: " + (each.sentences.empty() ? std::string() : each.sentences[0]) + ">";
      });
}

}  // namespace

void add_judgement(py::module_& module) {
  add_verdict_class(module);
  add_pair_class(module);
  add_judgement_class(module);
  add_radiosity_class(module);
  add_grid_class(module);
}

}  // namespace hottel::python
