#include "solver/radiosity/certificate.h"

#include <algorithm>
#include <cmath>

#include "kernel/doubles.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr int kMostSteps = 25;
constexpr int kMostRounds = 8;
constexpr double kWorthwhile = 0.5;  // a step that reduces the residual less is the last

// What a solver has lost to the range of doubles corrects nothing.
DoubleDouble plus(DoubleDouble a, double b) {
  if (!std::isfinite(b)) return a;
  double s, e;
  two_sum(a.hi, b, s, e);
  DoubleDouble result;
  two_sum(s, e + a.lo, result.hi, result.lo);
  return result;
}

// The power of two by which each component is divided so that the largest of its numbers is near 1.
std::vector<int> exponents_by_component(const RadiositySystem& system, const std::vector<double>& of) {
  std::vector<double> largest(system.components().size(), 0);
  for (std::size_t i = 0; i < of.size(); ++i)
    if (std::isfinite(of[i])) {
      double& most = largest[system.rows()[i].component];
      most = std::max(most, std::abs(of[i]));
    }
  std::vector<int> result;
  for (const double most : largest) result.push_back(most > 0 ? std::ilogb(most) : 0);
  return result;
}

void add(const Correction& correction, SplitVector& x) {
  for (std::size_t c = 0; c < x.constant.size(); ++c) x.constant[c] = plus(x.constant[c], correction.constant[c]);
  for (std::size_t i = 0; i < x.rest.size(); ++i) x.rest[i] = plus(x.rest[i], correction.rest[i]);
}

SplitVector zero_of(const RadiositySystem& system) {
  return {std::vector<DoubleDouble>(system.components().size()), std::vector<DoubleDouble>(system.size())};
}

// The sizes of residuals, in each component times the power of two that brings the largest near 1: a vector of which
// they are the image then stays clear of underflow, however small they are.
std::vector<double> near_one(const RadiositySystem& system, const std::vector<char>& is_wanted,
                             const std::vector<DoubleDoubleBall>& r) {
  std::vector<double> size(r.size(), 0);
  for (std::size_t i = 0; i < r.size(); ++i)
    if (is_wanted[system.rows()[i].component]) size[i] = std::max(r[i].size(), kUnderflow);
  const std::vector<int> exponent = exponents_by_component(system, size);
  for (std::size_t i = 0; i < r.size(); ++i)
    if (size[i] > 0) size[i] = std::max(std::ldexp(size[i], -exponent[system.rows()[i].component]), kUnderflow);
  return size;
}

// A number that is not below a / b, though that may underflow; at least 0. What is not a number proves nothing.
double quotient_above(double a, double b) {
  if (a <= 0 && b > 0) return 0;
  const double nearest = a / b;
  return std::isnan(nearest) ? kInfinity : std::nextafter(nearest * kOutward, kInfinity);
}

// A positive vector v with lower bounds w of A v.
struct PositiveVector {
  SplitVector v;
  std::vector<double> image;    // w
  std::vector<char> is_proven;  // by component: w > 0 and v > 0
};

// 1 in components that the solver has left out: enough where every row loses light.
void start_where_nothing_is(const RadiositySystem& system, SplitVector& v) {
  std::vector<char> is_started(system.components().size(), 0);
  for (std::size_t i = 0; i < system.size(); ++i)
    if (system.value(v, i).hi != 0) is_started[system.rows()[i].component] = 1;
  for (std::size_t c = 0; c < is_started.size(); ++c)
    if (!is_started[c]) v.constant[c] = {1, 0};
}

// For components in which nothing is proven: v = 1, whose image is what each row loses. It takes no factor.
void take_ones_where_nothing_is_proven(const RadiositySystem& system, const std::vector<char>& is_wanted,
                                       const ErrorTerms& terms, SharedRows* others, PositiveVector& found) {
  std::vector<char> is_left = is_wanted;
  for (std::size_t c = 0; c < is_left.size(); ++c) is_left[c] = is_wanted[c] && !found.is_proven[c];
  if (std::find(is_left.begin(), is_left.end(), 1) == is_left.end()) return;
  SplitVector one = zero_of(system);
  for (std::size_t c = 0; c < is_left.size(); ++c)
    if (is_left[c]) one.constant[c] = {1, 0};
  const std::vector<DoubleDoubleBall> minus_image = system.residual({nullptr, one, is_left, terms}, others);
  for (std::size_t c = 0; c < is_left.size(); ++c)
    if (is_left[c]) found.v.constant[c] = one.constant[c], found.is_proven[c] = 1;
  for (std::size_t i = 0; i < system.size(); ++i) {
    const std::uint32_t c = system.rows()[i].component;
    if (!is_left[c]) continue;
    found.v.rest[i] = {};
    found.image[i] = -minus_image[i].upper();
    if (!(found.image[i] > 0)) found.is_proven[c] = 0;
  }
}

// Looks for v > 0 with A v near `target` > 0.
PositiveVector positive_vector(const RadiositySystem& system, const ApproximateInverse& inverse,
                               const std::vector<char>& is_wanted, std::vector<double> target, const ErrorTerms& terms,
                               SharedRows* others) {
  const std::size_t n = system.size();
  PositiveVector result{zero_of(system), std::vector<double>(n, 0), {}};
  add(inverse.solve(target), result.v);
  start_where_nothing_is(system, result.v);
  for (int round = 0;; ++round) {
    throw_if_interrupted();
    const std::vector<DoubleDoubleBall> minus_image = system.residual({nullptr, result.v, is_wanted, terms}, others);
    result.is_proven = is_wanted;
    std::vector<double> correction(n, 0);
    bool is_settled = true;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t c = system.rows()[i].component;
      if (!is_wanted[c]) continue;
      result.image[i] = -minus_image[i].upper();
      if (!(result.image[i] > 0) || !std::isfinite(result.image[i]) || !(system.value(result.v, i).lower() > 0))
        result.is_proven[c] = 0;
      if (!(result.image[i] >= target[i] / 2)) {
        is_settled = false;
        // What the error bound swallows is asked for in addition.
        if (std::isfinite(minus_image[i].radius)) target[i] = std::max(target[i], 4 * minus_image[i].radius);
      }
      correction[i] = target[i] + minus_image[i].hi;
    }
    if (is_settled || round == kMostRounds) return result;
    add(inverse.solve(correction), result.v);
  }
}

}  // namespace

Correction solve_by_component(const RadiositySystem& system, const ApproximateInverse& inverse, std::vector<double> r) {
  const std::vector<int> exponent = exponents_by_component(system, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = std::ldexp(r[i], -exponent[system.rows()[i].component]);
  Correction x = inverse.solve(r);
  for (std::size_t c = 0; c < exponent.size(); ++c) x.constant[c] = std::ldexp(x.constant[c], exponent[c]);
  for (std::size_t i = 0; i < r.size(); ++i) x.rest[i] = std::ldexp(x.rest[i], exponent[system.rows()[i].component]);
  return x;
}

std::vector<double> refine(const RadiositySystem& system, const Sources& sources, const ApproximateInverse& inverse,
                           SplitVector& x, std::vector<DoubleDoubleBall>* last, SharedRows* others) {
  std::vector<double> history;
  if (last != nullptr) last->assign(system.size(), {});
  const std::size_t count = system.components().size();
  std::vector<char> is_open = sources.is_lit;
  std::vector<double> best(count, kInfinity), relative(count, 0);
  for (int step = 0;; ++step) {
    throw_if_interrupted();
    const std::vector<DoubleDoubleBall> r = system.residual({&sources, x, is_open}, others);
    std::vector<double> largest(count, 0), excess(count, 0), right_side(r.size(), 0);
    for (std::size_t i = 0; i < r.size(); ++i) {
      const std::uint32_t c = system.rows()[i].component;
      if (!is_open[c]) continue;
      if (last != nullptr) (*last)[i] = r[i];  // x of a component that is no longer open stays
      largest[c] = std::max(largest[c], std::abs(r[i].hi));
      if (r[i].hi != 0) excess[c] = std::max(excess[c], std::abs(r[i].hi) / r[i].radius);
      right_side[i] = r[i].hi;
    }
    bool is_any_open = false;
    for (std::size_t c = 0; c < count; ++c) {
      if (!is_open[c]) continue;
      relative[c] = largest[c] / (sources.largest[c] > 0 ? sources.largest[c] : 1);
      const bool is_worthwhile = step == 0 || excess[c] < kWorthwhile * best[c];
      is_open[c] = excess[c] >= kWorthwhile && is_worthwhile && step < kMostSteps;
      is_any_open |= is_open[c] != 0;
      best[c] = excess[c];
    }
    history.push_back(count == 0 ? 0 : *std::max_element(relative.begin(), relative.end()));
    if (!is_any_open) return history;
    for (std::size_t i = 0; i < r.size(); ++i)
      if (!is_open[system.rows()[i].component]) right_side[i] = 0;
    add(solve_by_component(system, inverse, std::move(right_side)), x);
  }
}

ScaledBall CertifiedBounds::enclosed(std::size_t unknown) const {
  const double from = lower[unknown], to = upper[unknown];
  if (to == 0) return {};
  const DoubleDoubleBall& x = value[unknown];
  const double inside = std::isnan(x.hi) ? from : std::clamp(x.hi, from, to);
  return ScaledBall::of(DoubleDoubleBall::around({inside, inside == x.hi ? x.lo : 0}, {from, to}), exponent[unknown]);
}

CertifiedBounds certify(const RadiositySystem& system, const Sources& sources, const ApproximateInverse& inverse,
                        const SplitVector& x, const ErrorTerms& terms, const std::vector<DoubleDoubleBall>* residual,
                        SharedRows* others) {
  const std::size_t n = system.size();
  std::vector<DoubleDoubleBall> made;
  if (residual == nullptr) made = system.residual({&sources, x, sources.is_lit, terms}, others);
  const std::vector<DoubleDoubleBall>& r = residual != nullptr ? *residual : made;
  PositiveVector positive = positive_vector(system, inverse, sources.is_lit, near_one(system, sources.is_lit, r),
                                            {.meant = terms.meant}, others);
  if (terms.meant == FactorsMeant::kWithinBounds)
    take_ones_where_nothing_is_proven(system, sources.is_lit, terms, others, positive);

  std::vector<double> up(system.components().size(), 0), down(system.components().size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t c = system.rows()[i].component;
    if (!sources.is_lit[c]) continue;
    up[c] = std::max(up[c], quotient_above(r[i].upper(), positive.image[i]));
    down[c] = std::max(down[c], quotient_above(-r[i].lower(), positive.image[i]));
  }
  CertifiedBounds result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t c = system.rows()[i].component;
    const DoubleDoubleBall value = system.value(x, i);
    result.value.push_back(value);
    result.exponent.push_back(sources.exponent[c]);
    if (!sources.is_lit[c]) {
      result.lower.push_back(0);
      result.upper.push_back(0);
      continue;
    }
    double lower = 0, upper = kInfinity;
    if (positive.is_proven[c] && std::isfinite(up[c]) && std::isfinite(down[c])) {
      const DoubleDoubleBall v = system.value(positive.v, i);
      lower = difference(value, product(v, {down[c], 0, 0})).lower();
      upper = sum(value, product(v, {up[c], 0, 0})).upper();
    }
    if (system.has_negative_factors()) {
      result.lower.push_back(-kInfinity);
      result.upper.push_back(kInfinity);
      continue;
    }
    // B >= E always.
    const double emission = sources.emission_in(c, system.rows()[i].element).lower();
    // For factors that are only enclosed the maximum principle is of those for which light is known to die out.
    const bool is_known_to_die_out = terms.meant == FactorsMeant::kAsGiven || positive.is_proven[c] != 0;
    const Enclosure range = is_known_to_die_out ? sources.range[c] : Enclosure{0, kInfinity};
    result.lower.push_back(std::max({std::isfinite(lower) ? lower : 0, emission, range.lower}));
    result.upper.push_back(std::max(std::isnan(upper) ? kInfinity : std::min(upper, range.upper), result.lower.back()));
  }
  return result;
}

bool spectral_radius_is_below_one(const RadiositySystem& system, const ApproximateInverse& inverse,
                                  const std::vector<char>& is_wanted, SharedRows* others) {
  std::vector<double> target(system.size(), 0);
  for (std::size_t i = 0; i < system.size(); ++i) target[i] = is_wanted[system.rows()[i].component] ? 1 : 0;
  return positive_vector(system, inverse, is_wanted, target, {}, others).is_proven == is_wanted;
}

}  // namespace hottel
