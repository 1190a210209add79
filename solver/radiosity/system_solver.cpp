#include "solver/radiosity/system_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/support/failure.h"
#include "solver/radiosity/iterations.h"
#include "solver/radiosity/single_precision_lu.h"

namespace hottel {
namespace {

constexpr double kDefaultUntil = 1e-12;
constexpr int kDefaultIterations = 10'000;
constexpr int kDefaultShots = 100'000;
constexpr double kWorthANote = 1e-9;  // a relative residual, where it was not said how small it should be

bool is_symmetric_only(Solver solver) { return solver == Solver::kCholesky || solver == Solver::kCg; }

// What is not finite counts for nothing.
void take(const Correction& from, SplitVector& x) {
  for (std::size_t c = 0; c < x.constant.size(); ++c)
    x.constant[c] = {std::isfinite(from.constant[c]) ? from.constant[c] : 0, 0};
  for (std::size_t i = 0; i < x.rest.size(); ++i) x.rest[i] = {std::isfinite(from.rest[i]) ? from.rest[i] : 0, 0};
}

}  // namespace

SystemSolver::SystemSolver(const CachedSystem& kept, std::vector<char> is_wanted, const RadiosityOptions& options,
                           bool may_be_open, StageTimes& times)
    : kept_(kept), is_wanted_(std::move(is_wanted)), options_(options) {
  if (kept_.system.rows_are_closed())
    prepare_symmetric();
  else
    prepare_any(may_be_open);
  times.lap(is_refined() ? "radiosity" : "certificate");
}

void SystemSolver::prepare_symmetric() {
  std::uint32_t largest = 0;
  for (std::size_t c = 0; c < is_wanted_.size(); ++c)
    if (is_wanted_[c]) largest = std::max(largest, kept_.system.components()[c].size);
  const bool is_dense = largest <= kMostDenseUnknowns;
  used_ = options_.solver != Solver::kAuto ? options_.solver : is_dense ? Solver::kCholesky : Solver::kCg;
  const bool by_elimination = used_ == Solver::kCholesky || (used_ != Solver::kCg && is_dense);
  if (by_elimination) {
    inverse_ = kept_.inverses.elimination(is_wanted_);
    return;
  }
  share_rows();
  inverse_ = kept_.inverses.conjugate_gradient(is_wanted_, {}, nullptr, others());
}

void SystemSolver::share_rows() {
  if (RowCrew* const crew = CrewScope<RowCrew>::crew()) others_ = crew->begin(kept_.system, is_wanted_);
}

void SystemSolver::prepare_any(bool may_be_open) {
  if (is_symmetric_only(options_.solver))
    throw RequestError(
        fmt::format("'{}' needs a symmetric matrix, and one whose rows do not sum to 1 is not: use 'lu' or "
                    "'bicgstab'",
                    to_string(options_.solver)));
  const bool is_small = kept_.system.size() <= kMostDenseUnknowns;  // lu takes all components at once
  const std::uint32_t most = options_.serves_many ? kMostUnknownsFactoredForMany : kMostUnknownsFactoredForOne;
  const bool may_be_single = !is_small && options_.solver == Solver::kAuto && kept_.system.size() <= most;
  if (is_small)
    inverse_ = kept_.inverses.lu(is_wanted_);
  else if (may_be_single)
    inverse_ = kept_.inverses.single_precision_lu(is_wanted_);
  used_ = options_.solver != Solver::kAuto ? options_.solver : inverse_ ? Solver::kLu : Solver::kBicgstab;
  if (!inverse_) {
    share_rows();
    inverse_ = kept_.inverses.bicgstab(is_wanted_, {}, nullptr, others());
  }
  if (!may_be_open && !kept_.system.has_negative_factors() &&
      !kept_.inverses.light_dies_out(is_wanted_, *inverse_, others()))
    throw RequestError(
        "no radiosity: the spectral radius of reflectivity times factors is not below 1 (or too near it to tell); "
        "rows of the matrix sum to more than 1");
}

bool SystemSolver::is_refined() const {
  const bool is_limited = options_.iterations || options_.until;
  return used_ == Solver::kCholesky || (used_ == Solver::kCg && !is_limited) ||
         (options_.solver == Solver::kAuto && !kept_.system.rows_are_closed());
}

CertifiedBounds SystemSolver::solve(const Sources& sources, const ErrorTerms& terms, std::vector<double>& history,
                                    std::set<std::string>& notes, StageTimes& times) const {
  const RadiositySystem& system = kept_.system;
  SplitVector x{std::vector<DoubleDouble>(is_wanted_.size()), std::vector<DoubleDouble>(system.size())};
  std::vector<DoubleDoubleBall> last;
  if (is_refined())
    history = refine(system, sources, *inverse_, x, &last, others());
  else
    run_as_named(sources, x, history, notes);
  times.lap("radiosity");
  // Where factors are negative, rows may have entries in other components, which may have changed since.
  const bool is_as_given = terms.meant == FactorsMeant::kAsGiven;
  const bool knows_residual =
      is_refined() && terms.factors && terms.roundings && is_as_given && !system.has_negative_factors();
  CertifiedBounds bounds = certify(system, sources, *inverse_, x, terms, knows_residual ? &last : nullptr, others());
  if (system.rows_are_closed() && is_as_given) kept_.wide.narrow(sources, {is_refined(), !is_refined()}, bounds);
  times.lap("certificate");
  if (system.matrix().guarantee() == Guarantee::kExact) require_bounds(system, bounds);
  return bounds;
}

void SystemSolver::run_as_named(const Sources& sources, SplitVector& x, std::vector<double>& history,
                                std::set<std::string>& notes) const {
  const std::shared_ptr<const PlainSystem> plain = kept_.inverses.plain(is_wanted_);
  const PlainSource source(kept_.system, sources);
  const int most = options_.iterations.value_or(used_ == Solver::kShooting ? kDefaultShots : kDefaultIterations);
  const double until = options_.until.value_or(options_.iterations ? 0 : kDefaultUntil);
  const CgLimits limits{most, until};
  if (used_ == Solver::kJacobi || used_ == Solver::kGaussSeidel || used_ == Solver::kShooting) {
    const auto run = used_ == Solver::kJacobi ? jacobi : used_ == Solver::kGaussSeidel ? gauss_seidel : shooting;
    IterationResult result = run(*plain, source, {most, until});
    take({std::vector<double>(is_wanted_.size(), 0), std::move(result.x)}, x);
    history = std::move(result.history);
  } else if (used_ == Solver::kLu) {
    const Correction result = kept_.inverses.lu(is_wanted_)->solve(source.value);
    history.push_back(source.relative(plain->residual(source.value, result.rest)));
    take(result, x);
    return;
  } else {
    const auto solver = used_ == Solver::kCg ? kept_.inverses.conjugate_gradient(is_wanted_, limits, &history, others())
                                             : kept_.inverses.bicgstab(is_wanted_, limits, &history, others());
    take(solve_by_component(kept_.system, *solver, source.value), x);
  }
  if (!(history.back() <= (options_.until || !options_.iterations ? until : kWorthANote)))
    notes.insert(
        fmt::format("{} stopped after {} iterations with a relative residual of {:.2g}: by so much radiosities differ "
                    "from emission + reflectivity * irradiance",
                    to_string(used_), history.size() - 1, history.back()));
}

}  // namespace hottel
