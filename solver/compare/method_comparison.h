// Approximate methods beside the exact one, on one scene, in the plane or in space: their errors and times.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/compare/method_result.h"
#include "solver/compare/reference_errors.h"
#include "solver/compare/timing.h"
#include "solver/exchange_method.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// What methods are compared with: a scene and its exact factors by elements, with visibilities.
template <class Prepared>
struct ComparisonReference {
  std::shared_ptr<const Prepared> prepared;
  std::shared_ptr<const ExchangeMatrix> exact;
  std::vector<LightShares> lights = {};  // of the elements of `exact`
  double tolerance = 0;                  // of the exact factors that are not correctly rounded
  bool proves = false;                   // ExchangeRequest::proves, of methods that can
  double seconds = 0;                    // time of the exact factors
};

// A scene with its exact factors and radiosities, with which methods are compared.
//
//   (1) exact() has the elements that the scene asks for, with visibilities; all methods are compared with it
//   (2) if radiosities cannot be solved for, exact_solution() is nothing and why_no_solution() says why; methods are
//       then judged by their factors alone
//   (3) no reported error is smaller than the possible error of the reference itself (reference())
template <class Prepared>
class MethodComparison {
 public:
  // COST: one solution.
  explicit MethodComparison(ComparisonReference<Prepared> reference)
      : prepared_(std::move(reference.prepared)),
        exact_(std::move(reference.exact)),
        lights_(std::move(reference.lights)),
        tolerance_(reference.tolerance),
        proves_(reference.proves),
        seconds_(reference.seconds) {
    exact_solution_ = solve(*exact_, why_no_solution_);
    reference_ = reference_errors(*exact_, tolerance_, exact_solution_);
  }

  // Runs a method, times it and takes its errors. runs: so many after one to warm up; nothing: until three took half a
  // second together, at most ten seconds. Of repeated runs the last one's matrix and report are kept. Seconds are the
  // method's own where its report has them. progress: of each run anew; what it throws is passed on.
  //
  //   (1) info.guarantee is the stronger of two: what the method says of itself, and what all its factors here have
  //   (2) max_radiosity_error is nothing where there is no exact solution; it is infinite, and a note says why, where
  //       the method's matrix has none though there is an exact one
  // Throws RequestError when the method cannot be run on the scene. COST: the runs, and one solution of its matrix.
  MethodResult run(const ExchangeMethod<Prepared>& method, const std::optional<int>& runs = {},
                   const std::function<void(double)>& progress = {}) const {
    MethodResult result;
    ExchangeRequest request{
        .granularity = Granularity::kElement, .wants_visibility = false, .proves = proves_, .progress = progress};
    if (tolerance_ > 0) request.tolerance = tolerance_;
    result.info = method.info();
    result.timing = time_repeatedly(
        [&] {
          result.report = {};
          Stopwatch watch;
          result.matrix = method.compute(prepared(), request, result.report);
          const double seconds = watch.lap();
          return result.report.seconds.value_or(seconds);
        },
        runs);
    judge_factors(result);
    result.declared_error = method.declared_error(prepared());
    if (!exact_solution_) return result;

    std::string why_not;
    result.solution = solve(result.matrix, why_not);
    result.max_radiosity_error =
        result.solution ? std::max(max_radiosity_error(*result.solution, *exact_solution_), reference_.radiosity)
                        : std::numeric_limits<double>::infinity();
    if (!result.solution) result.notes.push_back(why_not);
    return result;
  }

  // The same for the exact method, without computing anything again: matrix and solution are those of the reference,
  // and the time is that of the one run that made it.
  MethodResult reference_as_method(const ExchangeMethod<Prepared>& exact_method) const {
    MethodResult result;
    result.info = exact_method.info();
    result.timing = {seconds_, seconds_, seconds_, 1};
    result.matrix = exact();
    judge_factors(result);
    result.declared_error = exact_method.declared_error(prepared());
    result.solution = exact_solution_;
    if (exact_solution_) result.max_radiosity_error = reference_.radiosity;
    return result;
  }

  const Prepared& prepared() const { return *prepared_; }
  const ExchangeMatrix& exact() const { return *exact_; }             // with visibilities
  const std::vector<LightShares>& lights() const { return lights_; }  // of the elements of exact()
  const ReferenceErrors& reference() const { return reference_; }
  const std::optional<RadiositySolution>& exact_solution() const { return exact_solution_; }
  const std::string& why_no_solution() const { return why_no_solution_; }
  const RadiositySolution& required_solution() const {  // throws RequestError when there is none
    if (!exact_solution_) throw RequestError("radiosities cannot be compared: " + why_no_solution_);
    return *exact_solution_;
  }

 private:
  // By its matrix and report.
  void judge_factors(MethodResult& result) const {
    result.info.guarantee = std::min(result.info.guarantee, result.matrix.guarantee());
    result.notes = result.report.notes;
    // Of columns that are not there missing_sentences() names those to which light goes.
    std::erase_if(result.notes, [&](const std::string& note) {
      return std::find(result.report.gaps.begin(), result.report.gaps.end(), note) != result.report.gaps.end();
    });
    const bool is_read = result.report.written.has_value();
    result.errors = matrix_errors(result.matrix, exact(), result.report.written.value_or(WrittenFactors()));
    if (is_read)
      for (std::string& sentence : missing_sentences(result.errors, exact()))
        result.notes.push_back(std::move(sentence));
    if (!std::isnan(result.errors.max)) result.errors.max = std::max(result.errors.max, reference_.max);
    if (!std::isnan(result.errors.rms)) result.errors.rms = std::max(result.errors.rms, reference_.rms);
    for (std::uint32_t i = 0; i < exact().size(); ++i) result.elements += exact().has_row(i);
  }

  std::optional<RadiositySolution> solve(const ExchangeMatrix& matrix, std::string& why_not) const {
    try {
      return solve_sources(matrix, prepared().scene.materials, sources_of(matrix, prepared().scene, lights_));
    } catch (const RequestError& error) {
      why_not = error.what();
      return std::nullopt;
    }
  }

  std::shared_ptr<const Prepared> prepared_;
  std::shared_ptr<const ExchangeMatrix> exact_;
  std::vector<LightShares> lights_;
  double tolerance_;
  bool proves_;
  double seconds_;
  std::string why_no_solution_;
  std::optional<RadiositySolution> exact_solution_;
  ReferenceErrors reference_;
};

}  // namespace hottel
