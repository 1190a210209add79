#include "solver/radiosity/radiosity_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <cmath>
#include <span>
#include <utility>

#include "kernel/support/disjoint_sets.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/row_crew.h"

namespace hottel {
namespace {

constexpr std::size_t kRowsOfTask = 16;  // rows a task
constexpr double kFar = 0x1p-400;        // below it a number is looked at in a unit of its own

// sum_j F_j (a_j - b_j), enclosed.
class DifferenceSum {
 public:
  explicit DifferenceSum(const ErrorTerms& terms) : terms_(terms) {}

  // `reach`: how far the real factor may be from the one that is told.
  void add(const Rounded& factor, DoubleDouble a, DoubleDouble b, double radius_of_difference = 0, double reach = 0) {
    double d, e, p, pe, s, se;
    two_sum(a.hi, -b.hi, d, e);
    const double d_low = e + (a.lo - b.lo);
    two_product(factor.value, d, p, pe);
    two_sum(high_, p, s, se);
    high_ = s;
    const DoubleDoubleBall real = DoubleDoubleBall::of(factor);
    const double from_low = factor.value * d_low, from_shift = real.lo * d;
    low_ += (pe + se) + (from_low + from_shift);
    low_size_ += std::abs(pe) + std::abs(se) + std::abs(from_shift) +
                 std::abs(factor.value) * (std::abs(e) + std::abs(a.lo) + std::abs(b.lo));
    factor_radius_ += real.radius * (std::abs(d) + 2 * std::abs(d_low));
    if (reach > 0) factor_radius_ += reach * (std::abs(d) + 2 * std::abs(d_low) + radius_of_difference);
    other_radius_ += std::abs(factor.value) * radius_of_difference;
    ++count_;
  }

  // The same as add() of a and b that are 0.
  void add_zero() { ++count_; }

  DoubleDoubleBall result() const {
    // Each term of low went through at most count + 6 additions and products, and partial sums stay below low_size.
    const double roundings = 2 * (static_cast<double>(count_) + 16) * kBallRoundoff * low_size_;
    const double underflow = 8 * (static_cast<double>(count_) + 1) * kUnderflow;
    DoubleDoubleBall sum{0, 0, underflow};
    two_sum(high_, low_, sum.hi, sum.lo);
    if (terms_.roundings) sum.radius += (roundings + other_radius_) * (1 + 0x1p-20);
    if (terms_.factors) sum.radius += factor_radius_ * (1 + 0x1p-20);
    return sum;
  }

 private:
  ErrorTerms terms_;
  double high_ = 0, low_ = 0, low_size_ = 0, factor_radius_ = 0, other_radius_ = 0;
  std::size_t count_ = 0;
};

// How far the k-th factor of a row may be from its double, where all within its bounds are meant.
double reach_of(const ExchangeMatrix& matrix, std::uint32_t i, std::size_t k, FactorsMeant meant) {
  if (meant == FactorsMeant::kAsGiven || matrix.guarantee(i, k) == Guarantee::kExact) return 0;
  return DoubleDoubleBall::around({matrix.row(i)[k].factor.value, 0}, matrix.bounds(i, k)).radius;
}

// True if factors within their bounds may sum to 1 in this row.
bool may_be_closed(const ExchangeMatrix& matrix, std::uint32_t i) {
  DoubleDoubleBall least, most;
  if (matrix.guarantee() == Guarantee::kExact) {
    for (const FactorEntry& entry : matrix.row(i)) least = sum(least, DoubleDoubleBall::of(entry.factor));
    return least.lower() <= 1 && least.upper() >= 1;
  }
  for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
    const Enclosure bounds = matrix.bounds(i, k);
    least = sum(least, {bounds.lower, 0, 0});
    most = sum(most, {bounds.upper, 0, 0});
  }
  return least.lower() <= 1 && most.upper() >= 1;
}

// The first row of which something is true; matrix.size() where there is none. The same for any number of threads.
template <class IsTrue>
std::uint32_t first_row(const ExchangeMatrix& matrix, const IsTrue& is_true) {
  std::atomic<std::uint32_t> first{matrix.size()};
  parallel_ranges(matrix.size(), kRowsOfTask, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end && i < first; ++i) {
      if (!is_true(i)) continue;
      for (std::uint32_t there = first; i < there && !first.compare_exchange_weak(there, i);) continue;
    }
  });
  return first;
}

// See rows_are_closed().
bool rows_may_be_closed(const ExchangeMatrix& matrix) {
  if (matrix.guarantee() == Guarantee::kEstimated) return false;
  const std::uint32_t open =
      first_row(matrix, [&](std::uint32_t i) { return matrix.has_row(i) && !may_be_closed(matrix, i); });
  if (open == matrix.size()) return true;
  const std::string& name = matrix.elements()[open].name;
  if (matrix.guarantee() == Guarantee::kExact)
    throw ContractViolation(fmt::format("exact factors of '{}' must sum to 1", name));
  if (matrix.has_closed_rows() && !matrix.row(open).empty())
    throw ContractViolation(fmt::format("no factors of '{}' within their bounds sum to 1", name));
  return false;
}

void require_numbers(const ExchangeMatrix& matrix) {
  const auto is_none = [](double factor) { return !std::isfinite(factor); };
  const std::uint32_t row =
      first_row(matrix, [&](std::uint32_t i) { return std::ranges::any_of(matrix.row(i).factors(), is_none); });
  if (row == matrix.size()) return;
  throw RequestError(fmt::format("a factor of '{}' is {}: nothing can be solved", matrix.elements()[row].name,
                                 *std::ranges::find_if(matrix.row(row).factors(), is_none)));
}

bool has_negative(const ExchangeMatrix& matrix) {
  const auto is_negative = [](double factor) { return factor < 0; };
  return first_row(matrix, [&](std::uint32_t i) { return std::ranges::any_of(matrix.row(i).factors(), is_negative); }) <
         matrix.size();
}

// 1 - rho * (the sum of the row), of a row as it is.
DoubleDoubleBall loss_of(const FactorRow& factors, const DoubleDoubleBall& reflectivity) {
  DoubleDoubleBall sum_of_row;
  for (const FactorEntry& entry : factors) sum_of_row = sum(sum_of_row, DoubleDoubleBall::of(entry.factor));
  return difference({1, 0, 0}, product(reflectivity, sum_of_row));
}

}  // namespace

RadiositySystem::RadiositySystem(const ExchangeMatrix& matrix, const std::vector<Rational>& reflectivities)
    : matrix_(&matrix), rows_are_closed_(rows_may_be_closed(matrix)), unknown_(matrix.size() + 1, -1) {
  require_numbers(matrix);
  has_negative_factors_ = has_negative(matrix);
  std::vector<DoubleDoubleBall> reflectivity(reflectivities.size()), loss(reflectivities.size());
  for (std::size_t m = 0; m < reflectivities.size(); ++m) {
    const Rational& rho = reflectivities[m];
    HOTTEL_REQUIRE(rho >= 0 && rho <= 1);
    reflectivity[m] = DoubleDoubleBall::of(rho);
    absorptivity_.push_back(1 - rho);
    loss[m] = DoubleDoubleBall::of(absorptivity_.back());
  }
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const std::uint32_t m = *matrix.elements()[i].material;
    HOTTEL_REQUIRE(m < reflectivities.size());
    if (reflectivities[m] == 0) continue;
    unknown_[i] = static_cast<std::int32_t>(rows_.size());
    rows_.push_back({i, 0, reflectivity[m], loss[m]});
  }
  if (!rows_are_closed())
    parallel_for(
        rows_.size(),
        [&](std::size_t i) { rows_[i].loss = loss_of(matrix.row(rows_[i].element), rows_[i].reflectivity); },
        kRowsOfTask);
  find_components();
}

RadiositySystem::RadiositySystem(const ExchangeMatrix& some_rows, SystemNumbers numbers)
    : matrix_(&some_rows),
      rows_are_closed_(numbers.rows_are_closed),
      has_negative_factors_(numbers.has_negative_factors),
      unknown_(std::move(numbers.unknown)),
      rows_(std::move(numbers.rows)),
      components_(std::move(numbers.components)) {
  HOTTEL_REQUIRE(unknown_.size() == some_rows.size() + std::size_t{1});
}

void RadiositySystem::find_components() {
  SharedDisjointSets sets(rows_.size());
  std::vector<char> loses(rows_.size());
  parallel_ranges(rows_.size(), kRowsOfTask, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      loses[i] = absorptivity(rows_[i]) != 0;
      for (const FactorEntry& entry : matrix_->row(rows_[i].element)) {
        const std::int32_t j = unknown_[entry.to];
        if (j < 0)
          loses[i] = 1;
        else if (is_positive(entry.factor))
          sets.join(i, static_cast<std::uint32_t>(j));
      }
    }
  });
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const std::uint32_t r = sets.root(i);
    if (r == i) {
      rows_[i].component = static_cast<std::uint32_t>(components_.size());
      components_.push_back({rows_[i].element, 0, false});
    } else {
      rows_[i].component = rows_[r].component;
    }
    SystemComponent& component = components_[rows_[i].component];
    ++component.size;
    component.loses |= loses[i] != 0;
  }
}

DoubleDoubleBall RadiositySystem::value(const SplitVector& x, std::size_t unknown) const {
  return sum(DoubleDoubleBall::of(x.constant[rows_[unknown].component]), DoubleDoubleBall::of(x.rest[unknown]));
}

std::vector<DoubleDoubleBall> RadiositySystem::residual(const ResidualQuestion& question, SharedRows* others) const {
  std::vector<DoubleDoubleBall> result(rows_.size());
  const auto here = [&](const WorkRange& unknowns) { set_residual(question, unknowns, result); };
  if (others != nullptr)
    others->residual(question, here, result);
  else
    here({0, rows_.size()});
  return result;
}

void RadiositySystem::set_residual(const ResidualQuestion& question, const WorkRange& unknowns,
                                   std::vector<DoubleDoubleBall>& result) const {
  const std::vector<DoubleDouble>& rest = question.x.rest;
  HOTTEL_REQUIRE(question.terms.meant == FactorsMeant::kAsGiven || rows_are_closed());
  HOTTEL_REQUIRE(unknowns.end <= rows_.size() && result.size() == rows_.size());
  const auto is_zero = [](const DoubleDouble& value) { return value.hi == 0 && value.lo == 0; };
  const bool is_start = std::all_of(rest.begin(), rest.end(), is_zero);  // nothing is exchanged yet
  parallel_ranges(unknowns.size(), kRowsOfTask, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = unknowns.begin + first; i < unknowns.begin + last; ++i)
      if (question.is_wanted[rows_[i].component]) result[i] = residual_of_row(question, i, is_start);
  });
}

DoubleDoubleBall RadiositySystem::residual_of_row(const ResidualQuestion& question, std::size_t i,
                                                  bool is_start) const {
  const Sources* const sources = question.sources;
  const SplitVector& x = question.x;
  const ErrorTerms& terms = question.terms;
  const SystemRow& row = rows_[i];
  const DoubleDoubleBall here = value(x, i);
  DifferenceSum exchanged(terms);
  const FactorRow factors = matrix_->row(row.element);
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const FactorEntry entry = factors[k];
    const std::int32_t j = unknown_[entry.to];
    if (j >= 0 && is_start) {
      exchanged.add_zero();
    } else if (j >= 0) {
      exchanged.add(entry.factor, x.rest[i], x.rest[static_cast<std::size_t>(j)], 0,
                    reach_of(*matrix_, row.element, k, terms.meant));
    } else {
      const DoubleDoubleBall there = sources ? sources->emission_in(row.component, entry.to) : DoubleDoubleBall();
      exchanged.add(entry.factor, {here.hi, here.lo}, {there.hi, there.lo}, here.radius + there.radius,
                    reach_of(*matrix_, row.element, k, terms.meant));
    }
  }
  const DoubleDoubleBall left = sum(product(row.loss, here), product(row.reflectivity, exchanged.result()));
  DoubleDoubleBall result =
      difference(sources ? sources->emission_in(row.component, row.element) : DoubleDoubleBall(), left);
  if (!terms.roundings && !terms.factors) result.radius = 0;
  return result;
}

namespace {

// The irradiance of one row. A row that sums to 1 is a mean: differences to its smallest value lose nothing, and none
// is above the mean.
DoubleDoubleBall gathered(const ExchangeMatrix& matrix, std::uint32_t i, const std::vector<DoubleDoubleBall>& radiosity,
                          bool is_mean, FactorsMeant meant) {
  const FactorRow row = matrix.row(i);
  DoubleDoubleBall base;
  if (is_mean) {
    base = radiosity[*std::ranges::min_element(row.columns(), {}, [&](std::uint32_t to) { return radiosity[to].hi; })];
    base.radius = 0;
  }
  DifferenceSum above(ErrorTerms{});
  bool is_dark = base.size() == 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const FactorEntry entry = row[k];
    const DoubleDoubleBall& there = radiosity[entry.to];
    if (there.size() == 0 && base.size() == 0) continue;
    is_dark = false;
    above.add(entry.factor, {there.hi, there.lo}, {base.hi, base.lo}, there.radius, reach_of(matrix, i, k, meant));
  }
  return is_dark ? DoubleDoubleBall() : sum(base, above.result());
}

// The same, whatever the sizes of factors and radiosities. Nothing is subtracted: what is far from others in size has
// little in common with them.
ScaledBall gathered_far(const ExchangeMatrix& matrix, std::uint32_t i, const std::vector<ScaledBall>& radiosity,
                        FactorsMeant meant) {
  ScaledBall result;
  const FactorRow row = matrix.row(i);
  for (std::size_t k = 0; k < row.size(); ++k) {
    const FactorEntry entry = row[k];
    DoubleDoubleBall factor = DoubleDoubleBall::of(entry.factor);
    factor.radius += reach_of(matrix, i, k, meant) * kOutward;
    result = sum(result, product(ScaledBall::of(factor), radiosity[entry.to]));
  }
  return result;
}

}  // namespace

std::vector<ScaledBall> RadiositySystem::irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant,
                                                    SharedRows* others) const {
  std::vector<ScaledBall> result(matrix_->size());
  const auto here = [&](const WorkRange& elements) { set_irradiance(radiosity, meant, elements, result); };
  if (others != nullptr)
    others->irradiance(radiosity, meant, here, result);
  else
    here({0, matrix_->size()});
  return result;
}

void RadiositySystem::set_irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant,
                                     const WorkRange& elements, std::vector<ScaledBall>& result) const {
  HOTTEL_REQUIRE(meant == FactorsMeant::kAsGiven || rows_are_closed());
  HOTTEL_REQUIRE(elements.end <= matrix_->size() && result.size() == matrix_->size());
  int unit = INT_MIN;
  for (const ScaledBall& b : radiosity)
    if (!b.is_zero()) unit = std::max(unit, b.exponent);
  if (unit == INT_MIN) return;
  std::vector<DoubleDoubleBall> in_unit;
  std::vector<char> is_far;
  bool is_any_far = false;
  for (const ScaledBall& b : radiosity) {
    in_unit.push_back(b.in_unit(unit));
    is_far.push_back(!b.is_zero() && in_unit.back().size() < kFar);
    is_any_far |= is_far.back() != 0;
  }
  parallel_ranges(elements.size(), kRowsOfTask, [&](std::size_t first, std::size_t last) {
    for (auto i = static_cast<std::uint32_t>(elements.begin + first); i < elements.begin + last; ++i) {
      const auto row = matrix_->row(i);
      if (!matrix_->has_row(i) || row.empty()) continue;
      const bool sees_far =
          is_any_far && std::ranges::any_of(row.columns(), [&](std::uint32_t to) { return is_far[to] != 0; });
      const DoubleDoubleBall near = gathered(*matrix_, i, in_unit, rows_are_closed(), meant);
      result[i] = sees_far || (near.size() != 0 && near.size() < kFar) ? gathered_far(*matrix_, i, radiosity, meant)
                                                                       : ScaledBall::of(near, unit);
    }
  });
}

PlainSystem::PlainSystem(const RadiositySystem& system, const std::vector<char>& is_wanted) {
  begin.push_back(0);
  for (const SystemRow& row : system.rows()) {
    for (const FactorEntry& entry : system.matrix().row(row.element)) {
      const std::int32_t j = system.unknown(entry.to);
      if (j < 0 || !is_wanted[row.component]) continue;
      to.push_back(static_cast<std::uint32_t>(j));
      scatter.push_back(row.reflectivity.hi * entry.factor.value);
    }
    begin.push_back(to.size());
    area.push_back(system.matrix().elements()[row.element].area.value);
  }
}

PlainSource::PlainSource(const RadiositySystem& system, const Sources& sources) : value(system.size(), 0) {
  for (std::size_t i = 0; i < system.size(); ++i) {
    const SystemRow& row = system.rows()[i];
    double from_known = 0;
    for (const FactorEntry& entry : system.matrix().row(row.element))
      if (system.unknown(entry.to) < 0)
        from_known += entry.factor.value * sources.emission_in(row.component, entry.to).hi;
    value[i] = sources.emission_in(row.component, row.element).hi + row.reflectivity.hi * from_known;
  }
  std::vector<double> largest(system.components().size(), 0);
  for (std::size_t i = 0; i < system.size(); ++i) {
    double& most = largest[system.rows()[i].component];
    most = std::max(most, std::abs(value[i]));
  }
  for (const SystemRow& row : system.rows())
    per_largest.push_back(largest[row.component] > 0 ? 1 / largest[row.component] : 1);
}

double PlainSource::relative(const std::vector<double>& r) const {
  double result = 0;
  for (std::size_t i = 0; i < r.size(); ++i) result = std::max(result, std::abs(r[i]) * per_largest[i]);
  return result;
}

double PlainSystem::gathered(std::size_t i, const std::vector<double>& x) const {
  double sum = 0;
  for (std::size_t k = begin[i]; k < begin[i + 1]; ++k) sum += scatter[k] * x[to[k]];
  return sum;
}

void PlainSystem::multiply(const WorkRange& unknowns, const std::vector<double>& x, std::vector<double>& result) const {
  parallel_ranges(unknowns.size(), kRowsOfTask, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = unknowns.begin + first; i < unknowns.begin + last; ++i) result[i] = gathered(i, x);
  });
}

std::vector<double> PlainSystem::residual(const std::vector<double>& of, const std::vector<double>& x,
                                          SharedRows* others) const {
  std::vector<double> result(of.size());
  const auto here = [&](const WorkRange& unknowns) { multiply(unknowns, x, result); };
  if (others != nullptr)
    others->multiply(RowProduct::kPlain, x, here, result);
  else
    here({0, of.size()});
  for (std::size_t i = 0; i < of.size(); ++i) result[i] = of[i] - (x[i] - result[i]);
  return result;
}

}  // namespace hottel
