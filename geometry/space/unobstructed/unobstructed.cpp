#include "geometry/space/unobstructed/unobstructed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/space/unobstructed/distant_pair.h"
#include "geometry/space/unobstructed/local_outline.h"
#include "geometry/space/unobstructed/local_pair.h"
#include "geometry/space/unobstructed/log_distance.h"
#include "geometry/space/unobstructed/small_part.h"
#include "geometry/space/vectors/moving_vector.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

using std::numbers::pi;

constexpr double kEnough = 1e-13;
constexpr double kOfDouble = 0x1p-48;  // what a measure as a double is told within, of itself

// The double integral over both outlines. Every edge of one meets every edge of the other:
//
//   2 pi S = sum over e, f of u.v J,     J = mean of ln |f(t) - e(s)|
//
// Scaling adds a constant to all J and leaves S alone, since the edges of an outline sum up to zero.
template <class Real>
class OutlineSum {
 public:
  // Coordinates are taken times 2^-exponent.
  OutlineSum(const LocalPair3& pair, int exponent)
      : pair_(pair), outlines_{LocalOutline3<Real>(pair, 0, exponent), LocalOutline3<Real>(pair, 1, exponent)} {
    for (int side = 0; side < 2; ++side) {
      const LocalOutline3<Real>& outline = outlines_[side];
      const std::size_t count = outline.corners.size();
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t next = k + 1 == count ? 0 : k + 1;
        edges_[side].push_back(outline.corners[next] - outline.corners[k]);
        off_[side].push_back(std::max(outline.off[k], outline.off[next]));
      }
    }
  }

  // S, to within error and what rounding makes.
  Approximation<Real> operator()(double error) {
    share_ = error * pi / static_cast<double>(edges_[0].size() * edges_[1].size());
    for (std::size_t k = 0; k < edges_[0].size(); ++k)
      for (std::size_t m = 0; m < edges_[1].size(); ++m) add(k, m);
    const Real value = sum_.value() / (2 * pi_of<Real>());
    return {value, 1.001 * error_ / (2 * pi) + 6 * kRoundoff<Real> * std::fabs(static_cast<double>(value))};
  }

 private:
  using Vector = LocalVector3<Real>;

  bool is_exact() const { return outlines_[0].is_exact; }

  void add(std::size_t k, std::size_t m) {
    using std::fabs;
    const Vector &u = edges_[0][k], &v = edges_[1][m];
    const double size_u = static_cast<double>(length(u)), size_v = static_cast<double>(length(v));
    const Real product = dot(u, v);
    const double size = std::fabs(static_cast<double>(product));
    const double off_u = is_exact() ? 0 : 2 * off_[0][k] + kRoundoff<Real> * size_u;
    const double off_v = is_exact() ? 0 : 2 * off_[1][m] + kRoundoff<Real> * size_v;
    const double off = 3 * kRoundoff<Real> * static_cast<double>(fabs(u.x * v.x) + fabs(u.y * v.y) + fabs(u.z * v.z)) +
                       off_u * size_v + off_v * size_u + off_u * off_v;
    if (size <= off) {  // |J| is at most ln of the largest distance, and 1.7 - ln of the longer edge
      error_ += (size + off) * (2.4 + std::fabs(same_bits::log(std::max(size_u, size_v))));
      return;
    }
    const Approximation<Real> mean = mean_log(k, m, std::max(share_ / size, kRoundoff<Real> / 2));
    const Real term = product * mean.value;
    sum_.add(term);
    error_ += (size + off) * mean.error + off * std::fabs(static_cast<double>(mean.value)) +
              kRoundoff<Real> * std::fabs(static_cast<double>(term));
  }

  Approximation<Real> mean_log(std::size_t k, std::size_t m, double tolerance) {
    const std::size_t next_k = k + 1 == edges_[0].size() ? 0 : k + 1, next_m = m + 1 == edges_[1].size() ? 0 : m + 1;
    EdgePair3<Real> edges{outlines_[1].corners[m] - outlines_[0].corners[k], edges_[0][k], edges_[1][m], 0};
    if (!is_exact())
      edges.error = 2 * (off_[0][k] + off_[1][m]) +
                    kRoundoff<Real> * static_cast<double>(length(edges.d) + length(edges.u) + length(edges.v));
    if (const auto mean = mean_log_of_distant(edges, tolerance)) return *mean;
    if (pair_.are_parallel(k, m)) return mean_log_of_near(edges, EdgeContact3::kParallel, tolerance);
    for (const std::size_t a : {k, next_k})
      for (const std::size_t b : {m, next_m})
        if (pair_.are_same(a, b))
          return mean_log_of_near(edges.reversed(a != k, b != m), EdgeContact3::kJoint, tolerance);
    for (const std::size_t a : {k, next_k})
      if (pair_.is_on(0, a, m)) return mean_log_of_near(edges.reversed(a != k, false), EdgeContact3::kEndOn, tolerance);
    for (const std::size_t b : {m, next_m})
      if (pair_.is_on(1, b, k))
        return mean_log_of_near(edges.reversed(false, b != m).swapped(), EdgeContact3::kEndOn, tolerance);
    return mean_log_of_near(edges, EdgeContact3::kNone, tolerance);
  }

  const LocalPair3& pair_;
  std::array<LocalOutline3<Real>, 2> outlines_;
  std::array<std::vector<Vector>, 2> edges_;
  std::array<std::vector<double>, 2> off_;  // of the ends of an edge: at most
  CompensatedSum<Real> sum_;
  double error_ = 0, share_ = 0;
};

// The square root of a positive integer, off by less than 2^-50 of itself: mantissa * 2^exponent.
std::pair<double, long> root(const Integer& square) {
  long exponent;
  double mantissa = mpz_get_d_2exp(&exponent, square.get_mpz_t());
  if (exponent % 2 != 0) {
    mantissa *= 2;
    --exponent;
  }
  return {std::sqrt(mantissa), exponent / 2};
}

// value * 2^exponent / weight^2, off by less than 2^-50 of itself besides.
double in_units(double value, long exponent, const Integer& weight) {
  long of_weight;
  const double mantissa = mpz_get_d_2exp(&of_weight, weight.get_mpz_t());
  return std::ldexp(value / (mantissa * mantissa),
                    static_cast<int>(std::clamp(exponent - 2 * of_weight, -5000L, 5000L)));
}

// Where value is off by error, and by the roundings of units.
Enclosure widened(double value, double error) {
  return {std::max(0.0, value * (1 - 0x1p-49) - error * (1 + 0x1p-49)), (value + error) * (1 + 0x1p-49)};
}

// In units of integer form over the weight; nothing where doubles do not tell it within 2^-49 of itself.
std::optional<Approximation<double>> twice_the_area_in_doubles(const Patch3& patch) {
  thread_local Integer difference;
  const auto coordinate = [&](const Integer& from, const Integer& to) {
    mpz_sub(difference.get_mpz_t(), to.get_mpz_t(), from.get_mpz_t());
    return mpz_sizeinbase(difference.get_mpz_t(), 2) <= 53 ? truncated_double(difference) : HUGE_VAL;
  };
  const IntegerVector& first = patch.corners[0];
  BoundedVector last, sum;
  for (std::size_t k = 1; k < patch.corners.size(); ++k) {
    const IntegerVector& corner = patch.corners[k];
    BoundedVector side{coordinate(first.x, corner.x), coordinate(first.y, corner.y), coordinate(first.z, corner.z)};
    side.size = std::max({std::fabs(side.x), std::fabs(side.y), std::fabs(side.z)});
    if (!std::isfinite(side.size)) return {};
    const BoundedVector normal = cross(last, side);
    sum.x += normal.x;
    sum.y += normal.y;
    sum.z += normal.z;
    sum.size += normal.size;
    sum.error += normal.error + kRoundoff<double> * sum.size;
    last = side;
  }
  const double size = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
  const Approximation<double> result{size, 1.74 * sum.error + 4 * kRoundoff<double> * size};
  if (!(result.error <= 0.9 * 0x1p-49 * size)) return {};
  return result;
}

// The measure is `most` at most. Nothing else is known where a sum is beyond doubles.
UnobstructedMeasure3 enclosed(double value, double error, double most, double allowed) {
  if (!std::isfinite(value) || !std::isfinite(error)) value = error = most / 2;
  UnobstructedMeasure3 result;
  result.bounds = widened(value, error);
  result.bounds.upper = std::max(std::min(result.bounds.upper, most), std::numeric_limits<double>::denorm_min());
  result.bounds.lower = std::min(result.bounds.lower, result.bounds.upper);
  result.measure = std::clamp(value, result.bounds.lower, result.bounds.upper);
  if (result.measure <= 0)
    result.measure = std::max(result.bounds.upper / 2, std::numeric_limits<double>::denorm_min());
  result.error = std::max(result.measure - result.bounds.lower, result.bounds.upper - result.measure) * (1 + 0x1p-50);
  result.has_converged = result.error <= allowed;
  return result;
}

// Less than the distance of two patches, in local coordinates: how far their boxes are apart along an axis.
double least_distance(const LocalPair3& pair) {
  double distance = 0;
  for (double BoundedVector::*axis : {&BoundedVector::x, &BoundedVector::y, &BoundedVector::z}) {
    std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (int side = 0; side < 2; ++side)
      for (const BoundedVector& corner : pair.corners(side)) {
        low[side] = std::min(low[side], corner.*axis - corner.error);
        high[side] = std::max(high[side], corner.*axis + corner.error);
      }
    distance = std::max({distance, low[0] - high[1], low[1] - high[0]});
  }
  return distance * (1 - 0x1p-50);
}

// A_i A_j / (pi d^2), which is more than the measure. `unit` is that of areas; infinite where boxes are not apart.
double most_at_distance(const LocalPair3& pair, long unit, double area_i, double area_j) {
  constexpr double kRoundings = 1 + 0x1p-45, kLeast = std::numeric_limits<double>::denorm_min();
  long of_weight;
  const double mantissa = mpz_get_d_2exp(&of_weight, pair.weight().get_mpz_t());
  const double distance = ldexp_3(least_distance(pair) / mantissa, unit / 2 - of_weight);
  return (area_i / distance + kLeast) * (area_j / distance + kLeast) / pi * kRoundings + kLeast;
}

}  // namespace

UnobstructedMeasure3 unobstructed_measure(const Vertices3& vertices, const Patch3& i, const Patch3& j, double tolerance,
                                          Effort3 effort) {
  return unobstructed_measure(vertices, i, j, {patch_area(vertices, i), patch_area(vertices, j)}, tolerance, effort);
}

UnobstructedMeasure3 unobstructed_measure(const Vertices3& vertices, const Patch3& i, const Patch3& j,
                                          const std::array<Enclosure, 2>& areas, double tolerance, Effort3 effort) {
  const LocalPair3 pair(i, j);
  if (!pair.face_each_other()) return {};
  const auto& [area_i, area_j] = areas;
  const Enclosure area{std::min(area_i.lower, area_j.lower), std::min(area_i.upper, area_j.upper)};
  const int exponent = std::ilogb(pair.extent()) + 1;
  const long unit = 2 * (exponent + pair.shift() - vertices.shift());
  const double allowed = tolerance * area.lower;
  // Every way is proven, and none is good for all pairs: the first that is good enough is taken, or else the best.
  UnobstructedMeasure3 best;
  double most = area.upper;
  const auto is_enough = [&](const auto& sum) {
    const UnobstructedMeasure3 measure = enclosed(in_units(static_cast<double>(sum.value), unit, pair.weight()),
                                                  in_units(sum.error, unit, pair.weight()), most, allowed);
    if (best.measure == 0 || !(best.error <= measure.error)) best = measure;
    return best.has_converged;
  };
  // What quadrature may be off by, in squares of what coordinates are scaled to. More digits cost next to nothing.
  const double error = std::min(tolerance, kEnough) / 2 * area.lower / in_units(1, unit, pair.weight());
  // Far below what is asked for, so that sums of rows do not see it; by default below what a double tells.
  if (const auto sum = measure_of_distant(pair, exponent, tolerance * tolerance); sum && is_enough(*sum)) return best;
  most = std::min(most, most_at_distance(pair, unit - 2 * exponent, area_i.upper, area_j.upper));
  if (is_enough(OutlineSum<double>(pair, exponent)(error))) return best;
  if (const auto sum = measure_of_small(pair, exponent, error); sum && is_enough(*sum)) return best;
  if (is_enough(OutlineSum<long double>(pair, exponent)(error))) return best;
  // What no double can tell is not asked of wider numbers.
  if (effort == Effort3::kAll && best.measure * kOfDouble <= allowed)
    is_enough(OutlineSum<WideReal>(pair, exponent)(error));
  return best;
}

Enclosure patch_area(const Vertices3& vertices, const Patch3& patch) {
  if (const auto area = twice_the_area_in_doubles(patch))
    return widened(in_units(area->value / 2, -2 * vertices.shift(), patch.weight),
                   in_units(area->error / 2, -2 * vertices.shift(), patch.weight));
  const auto& corners = patch.corners;
  IntegerVector sum;
  IntegerVector last = difference(corners[1], corners[0]);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    IntegerVector next = difference(corners[k], corners[0]);
    const IntegerVector normal = cross(last, next);
    sum = {sum.x + normal.x, sum.y + normal.y, sum.z + normal.z};
    last = std::move(next);
  }
  const auto [mantissa, exponent] = root(dot(sum, sum));
  return widened(in_units(mantissa / 2, exponent - 2 * vertices.shift(), patch.weight), 0);
}

}  // namespace hottel
