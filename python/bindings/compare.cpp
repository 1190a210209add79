#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "geometry/closed_promise.h"
#include "io/external/external_method.h"
#include "io/external/plane/external_matrix.h"
#include "io/external/space/external_matrix.h"
#include "io/results/grid_report.h"
#include "kernel/support/failure.h"
#include "python/bindings/external_array.h"
#include "python/bindings/judgement.h"
#include "python/bindings/light_request.h"
#include "solver/plane/compare/pair_explanation.h"
#include "solver/plane/compare/verdict.h"
#include "solver/plane/light/light_values.h"
#include "solver/space/compare/pair_explanation.h"
#include "solver/space/compare/verdict.h"
#include "solver/space/light/illumination_grid.h"

namespace hottel::python {
namespace {

// What comparing needs of each dimension.
struct ComparedPlane {
  using Method = ExchangeMethod2;
  using External = FromMatrix<ElementMethod2, PreparedScene2>;
  using Explainer = PairExplainer2;
  static MethodCatalogue2 methods() { return all_methods_2(); }
};
struct ComparedSpace {
  using Method = ExchangeMethod3;
  using External = FromMatrix<ElementMethod3, PreparedScene3>;
  using Explainer = PairExplainer3;
  static MethodCatalogue3 methods() { return all_methods_3(); }
};
template <class Comparison>
using Compared = std::conditional_t<std::is_same_v<Comparison, MethodComparison2>, ComparedPlane, ComparedSpace>;

// What a fault is called, in the order of Fault.
constexpr std::array kFaults{"transposed",     "constant-factor", "row-factor",       "reversed",     "permuted",
                             "shifted",        "rows-permuted",   "columns-permuted", "no-occlusion", "all-or-nothing",
                             "sky-missing",    "sky-is-rest",     "missing",          "method",       "behind",
                             "sampling-noise", "areas",           "emission"};
static_assert(kFaults.size() == static_cast<std::size_t>(Fault::kEmission) + 1);

// What is asked of a comparison; of a method its name, of others a matrix.
struct CompareKeywords {
  std::string method;
  std::optional<ExternalMatrix> matrix;
  double beyond = 1e-6;
  std::optional<int> repeat;
  std::size_t worst = 10;
};

struct Outcome {
  MethodResult result;
  std::vector<ExplainedPair> worst;
  std::optional<Verdict> verdict;
  std::vector<std::string> sentences;
};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

template <class Comparison>
MethodResult run(const Comparison& comparison, const CompareKeywords& asked) {
  using Kind = Compared<Comparison>;
  if (!asked.matrix) return comparison.run(*Kind::methods().make(asked.method), asked.repeat);
  MethodResult result = comparison.run(typename Kind::External(*asked.matrix), 1);
  if (result.errors.pairs == 0 && comparison.exact().entry_count() > 0)
    throw InputError({kArray, 0}, "holds no factor of any face: there is nothing to judge");
  result.info.name = kArray;
  result.timing = {kUnknown, kUnknown, kUnknown, 0};
  return result;
}

template <class Comparison>
Outcome compared(const Comparison& comparison, const CompareKeywords& asked) {
  require_closed(comparison.prepared().scene, comparison.exact());
  Outcome found{run(comparison, asked), {}, {}, {}};
  const typename Compared<Comparison>::Explainer explainer(comparison.prepared(), comparison.exact());
  found.worst = explained_worst_pairs(explainer, comparison.exact(), found.result, asked.worst);
  if (found.result.report.written) {
    found.verdict = judge(comparison.prepared(), comparison.exact(), found.result.matrix,
                          {.beyond = asked.beyond, .written = *found.result.report.written});
    found.sentences = verdict_sentences(*found.verdict, comparison.exact());
  }
  found.result.matrix = {};
  found.result.solution.reset();
  return found;
}

std::vector<py::tuple> named(const std::vector<JudgedPair>& pairs, const ExchangeMatrix& exact) {
  std::vector<py::tuple> result;
  for (const JudgedPair& pair : pairs)
    result.push_back(py::make_tuple(exact.name(pair.from), exact.name(pair.to), pair.value, pair.exact));
  return result;
}

PythonVerdict told(Verdict verdict, std::vector<std::string> sentences, const ExchangeMatrix& exact) {
  PythonVerdict result{{}, {}, named(verdict.worst_unexplained, exact), std::move(sentences)};
  const auto kind = [](Fault fault) { return kFaults[static_cast<std::size_t>(fault)]; };
  for (const FoundFault& fault : verdict.findings) {
    std::vector<std::string> parts;
    for (const Fault part : fault.parts) parts.emplace_back(kind(part));
    result.findings.push_back(
        {kind(fault.fault), fault.words, std::move(parts), fault.explained, named(fault.worst, exact)});
  }
  result.verdict = std::move(verdict);
  return result;
}

const ExchangeMatrix& exact_of(const AnyComparison& comparison) {
  return std::visit([](const auto& each) -> const ExchangeMatrix& { return each.exact(); }, comparison);
}

void require_beyond(double beyond) {
  if (!(beyond >= 0)) throw UsageError("beyond is a number, 0 or more");
}

PythonJudgement compare(PythonSimulation& simulation, const py::object& what, const py::object& names, double beyond,
                        std::optional<int> repeat, std::int64_t worst) {
  require_beyond(beyond);
  if (repeat && *repeat < 1) throw UsageError("repeat is a whole number, 1 or more");
  if (worst < 0) throw UsageError("worst is a whole number, 0 or more");
  CompareKeywords asked{"", std::nullopt, beyond, repeat, static_cast<std::size_t>(worst)};
  if (py::isinstance<py::str>(what)) {
    asked.method = what.cast<std::string>();
    if (!names.is_none()) throw UsageError("names are for a matrix, not for a method");
    std::visit(  // told before any work
        [&](const auto& each) {
          if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Simulation2>)
            all_methods_2().make(asked.method);
          else
            all_methods_3().make(asked.method);
        },
        simulation.simulation());
  } else {
    asked.matrix = external_matrix(what, names);
  }
  const auto comparison = simulation.comparison();
  Outcome found = simulation.waited([&](const AnySimulation&, const StageProgress&) {
    return std::visit([&](const auto& each) { return compared(each, asked); }, *comparison);
  });
  PythonJudgement judgement{std::move(found.result), std::move(found.worst), std::nullopt};
  if (found.verdict)
    judgement.verdict = told(std::move(*found.verdict), std::move(found.sentences), exact_of(*comparison));
  return judgement;
}

// By channel, then by element: values are of elements with a row, in order.
std::vector<std::vector<double>> by_channel(const ExternalArray& array, const ExchangeMatrix& matrix,
                                            std::size_t channels) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) rows.push_back(i);
  const std::vector<std::size_t> wanted{rows.size(), channels}, flat{rows.size()};
  if (array.shape != wanted && !(channels == 1 && array.shape == flat))
    throw InputError({kArray, 0}, "of radiosities has the shape (" + std::to_string(rows.size()) + ", " +
                                      std::to_string(channels) + "): a row for each element with a material");
  std::vector<std::vector<double>> result(channels, std::vector<double>(matrix.size(), 0));
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < channels; ++c) {
      const double value = array.values[k * channels + c];
      if (!std::isfinite(value))
        throw InputError({kArray, 0}, "has a radiosity of '" + matrix.name(rows[k]) + "' that is not finite");
      result[c][rows[k]] = value;
    }
  return result;
}

PythonRadiosityJudgement compare_radiosities(PythonSimulation& simulation, const py::object& values, double beyond) {
  require_beyond(beyond);
  const ExternalArray array = external_array(values);
  const auto comparison = simulation.comparison();
  return std::visit(
      [&](const auto& each) {
        const ExchangeMatrix& exact = each.exact();
        const RadiositySolution& solution = each.required_solution();
        PythonRadiosityJudgement result;
        const auto found = by_channel(array, exact, solution.channels.size());
        result.verdict = judge_radiosities(exact, solution, found, array.digits, beyond);
        result.sentences = verdict_sentences(result.verdict, exact, solution);
        for (const JudgedRadiosity& one : result.verdict.worst)
          result.worst.push_back(py::make_tuple(exact.name(one.element), solution.channel_names[one.channel], one.value,
                                                one.exact, one.lower, one.upper));
        return result;
      },
      *comparison);
}

// Where the cells of a grid lie, and the exact light there.
struct ExactGrid {
  GridPlace place;
  std::vector<double> values;
};
ExactGrid exact_grid(const MethodComparison2& comparison, const Simulation2& asked) {
  const Grid2& grid = asked.grid();
  const std::array<double, 2> min = to_doubles(grid.min), max = to_doubles(grid.max);
  return {{{min[0], min[1], 0}, {max[0] - min[0], 0, 0}, {0, max[1] - min[1], 0}, grid.nx, grid.ny, false},
          exact_light_on(comparison, grid).values};
}
ExactGrid exact_grid(const MethodComparison3& comparison, const Simulation3& asked) {
  const Grid3 grid = *asked.grid();
  return {{to_doubles(grid.origin), to_doubles(grid.u), to_doubles(grid.v), grid.nu, grid.nv, true},
          exact_light_on(comparison, grid).values};
}

PythonGridJudgement compare_grid(PythonSimulation& simulation, const py::object& values, const py::object& over,
                                 double beyond) {
  require_beyond(beyond);
  const ExternalArray array = external_array(values);
  const std::vector<std::size_t>& shape = array.shape;
  if (shape.size() != 2 && shape.size() != 3)
    throw InputError({kArray, 0}, "of light has the shape (ny, nx) or (ny, nx, channels)");
  const std::size_t channels = shape.size() == 3 ? shape[2] : 1;
  require_planar_grid(simulation, over, "a comparison");
  const auto asked = gridded(simulation, {py::make_tuple(shape[1], shape[0]), over, "point"});
  const auto comparison = simulation.comparison();
  return simulation.waited([&](const AnySimulation&, const StageProgress&) {
    const RadiositySolution& solution =
        std::visit([](const auto& each) -> const RadiositySolution& { return each.required_solution(); }, *comparison);
    if (channels != solution.channels.size())
      throw InputError({kArray, 0}, "has " + std::to_string(channels) + " values a cell, and the light of the scene " +
                                        std::to_string(solution.channels.size()));
    const auto* const plane = std::get_if<MethodComparison2>(&*comparison);
    const ExactGrid exact = plane != nullptr
                                ? exact_grid(*plane, std::get<Simulation2>(*asked))
                                : exact_grid(std::get<MethodComparison3>(*comparison), std::get<Simulation3>(*asked));
    const auto width = static_cast<std::uint32_t>(channels);
    const GridValues found{exact.place.nv, exact.place.nu, width, array.values},
        right{exact.place.nv, exact.place.nu, width, exact.values};
    PythonGridJudgement result{solution.channel_names, grid_errors(found, right, beyond, array.digits), "", {}};
    result.reading = grid_reading(found, right);
    result.sentences = grid_sentences(result.errors, solution.channel_names, exact.place, beyond, result.reading);
    return result;
  });
}

}  // namespace

void add_compare_questions(py::class_<PythonSimulation>& type) {
  type.def(
          "compare", &compare, py::arg("what"), py::kw_only(), py::arg("names") = py::none(), py::arg("beyond") = 1e-6,
          py::arg("repeat") = py::none(), py::arg("worst") = 10,
          "Returns a method, or view factors of others, held against the exact factors of the same elements, "
          "Judgement.\n\n"
          "what: the name of a method, 'gauss:4', 'rays:1000:normalised', 'file:PATH'; or a matrix of shape (n, n) of\n"
          "elements, with the sky last or without it: an array, a sparse matrix, a data frame, Factors. names: of its\n"
          "rows and columns, a sequence of str; without them elements are in the order of the scene. beyond: what a "
          "pair\nmay be off. repeat: how often a method is timed. worst: how many of the worst pairs are told. "
          "Throws UsageError\nfor a method that there is not, InputError and TypeError for what is no such matrix, "
          "RequestError as of factors.")
      .def(
          "compare_radiosities", &compare_radiosities, py::arg("values"), py::kw_only(), py::arg("beyond") = 1e-6,
          "Returns radiosities of others held against the proven bounds of the exact ones, RadiosityJudgement.\n\n"
          "values: array-like of shape (n, c), with one channel also (n,): a row for each element with a material, as\n"
          "radiosity has them. InputError for another shape or numbers that are not finite, RequestError as of\n"
          "radiosity.")
      .def("compare_grid", &compare_grid, py::arg("values"), py::kw_only(), py::arg("over") = py::none(),
           py::arg("beyond") = 1e-6,
           "Returns light of others on a grid held against the exact light of the same cells, GridJudgement.\n\n"
           "values: array-like of shape (ny, nx) or (ny, nx, c), the lowest row first. over: as of grid(). beyond: "
           "what\n"
           "a cell may be off, of the largest light. Errors as of grid(), InputError for another shape.");
}

}  // namespace hottel::python
