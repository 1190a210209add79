// Rounding: constants of roundoffs count operations; what is of the second order is in the factors of 1.001.
#include "geometry/space/unobstructed/log_distance.h"

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/space/unobstructed/edge_separation.h"
#include "kernel/legendre_rule.h"
#include "kernel/plain_functions.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

constexpr double kLibrary = 8;   // roundoffs of a logarithm or an angle: four units of the last place
constexpr double kMaxRatio = 4;  // of lengths, for closed forms

template <class Real>
constexpr int kMaxTensor = 16;
template <>
constexpr int kMaxTensor<WideReal> = 32;
template <class Real>
constexpr int kMaxCells = 600;
template <>
constexpr int kMaxCells<WideReal> = 6000;

template <class Real>
double to_double(Real value) {
  return static_cast<double>(value);
}

// What a mean of ln |p - f(t)| changes by at most where p is moved by x |v|.
double modulus(double x) { return x > 0 ? 4 * x * (1 + same_bits::log1p(0.5 / x)) : 0; }

// An edge pair, or a part of one, with what is asked of it.
template <class Real>
struct Cell {
  EdgePair3<Real> pair;
  EdgeContact3 contact = EdgeContact3::kNone;
  Real share = 1;  // of s and t
};

// The rules of two edges, applied to both at once. Nodes k and n - 1 - k have the same weight: there are four distances
// to one logarithm.
template <class Real>
Real tensor_mean(const EdgePair3<Real>& pair, int n_e, int n_f) {
  using same_bits::log;
  const LegendreRule<Real>&rule_e = legendre_rule<Real>(n_e), &rule_f = legendre_rule<Real>(n_f);
  const auto half_e = static_cast<std::size_t>(n_e / 2), half_f = static_cast<std::size_t>(n_f / 2);
  std::array<LocalVector3<Real>, kMaxTensor<Real>> along;
  for (std::size_t j = 0; j < 2 * half_f; ++j) along[j] = rule_f.node[j] * pair.v;
  Real sum = 0;
  for (std::size_t i = 0; i < half_e; ++i) {
    const LocalVector3<Real> a = pair.d - rule_e.node[i] * pair.u,
                             b = pair.d - rule_e.node[2 * half_e - 1 - i] * pair.u;
    Real row = 0;
    for (std::size_t j = 0; j < half_f; ++j) {
      const LocalVector3<Real>&p = along[j], &q = along[2 * half_f - 1 - j];
      const Real product = (square(a + p) * square(a + q)) * (square(b + p) * square(b + q));
      row += rule_f.weight[j] * log(product);
    }
    sum += rule_e.weight[i] * row;
  }
  return sum / 2;
}

// Rounding: places are off by those of nodes, products and sums; each square by 3 roundoffs, a product of four by 15,
// so half its logarithm by 1.9 for each distance; weights, products and the sums over rows and nodes make the rest.
template <class Real>
std::optional<Approximation<Real>> tensor(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends, double tolerance) {
  const Reach3 reach(ends);
  const int n_e = nodes_for_logs_3(reach.rho_e, tolerance / 2, kMaxTensor<Real>);
  if (n_e == 0) return {};
  const int n_f = nodes_for_logs_3(reach.rho_f, tolerance / 2, kMaxTensor<Real>);
  if (n_f == 0) return {};
  const double roundoff = kRoundoff<Real>;
  const double off = pair.error + 2 * roundoff * (ends.length_of(0) + ends.length_of(1) + ends.farthest());
  if (!(reach.nearest > 1024 * off && reach.nearest > kLeastDistance<Real>)) return {};
  Approximation<Real> result{tensor_mean(pair, n_e, n_f), 0};
  result.error = log_error_3(n_e, reach.rho_e) + log_error_3(n_f, reach.rho_f) + 1.001 * off / reach.nearest +
                 roundoff * (2 + (4 + kLibrary + (n_e + n_f) / 2) * reach.largest_log());
  return result;
}

// The mean of ln |p - f(t)| over t, for a point p with w0 = f(0) - p and w1 = f(1) - p, the rounded sum of w0 and v.
// Both are off by at most `off`, but for that.
//
//   ((w1.v) ln |w1| - (w0.v) ln |w0| + |w0 x v| angle(w0, w1)) / |v|^2 - 1
//
// Rounding, in roundoffs: scalar products 3 |w| |v|, and 1 for the sum w1; logarithms 2.5 and those of the library; the
// cross product with the nearer end 3.9 |w| |v| and 2.5 of itself; the angle 1.01 (3.9 |v| / |far end| + 6.5) < 15 and
// those of the library; 6 of each summand for what is left. Changes of place: the integral of off/|p - f(t)|, which is
// off/|v| ln((|w0| + |w1| + |v|) / (|w0| + |w1| - |v|)), where all of f is far enough.
template <class Real>
Approximation<Real> log_from_point(const LocalVector3<Real>& w0, const LocalVector3<Real>& w1,
                                   const LocalVector3<Real>& v, double off) {
  using same_bits::atan2, same_bits::log, std::sqrt;
  const Real q0 = square(w0), q1 = square(w1), q = square(v);
  const Real ln0 = q0 > 0 ? Real(log(q0) / 2) : Real(0), ln1 = q1 > 0 ? Real(log(q1) / 2) : Real(0);
  const Real height = length(cross(q0 <= q1 ? w0 : w1, v));
  const Real angle = atan2(height, dot(w0, w1));
  Approximation<Real> result;
  result.value = ((dot(w1, v) * ln1 - dot(w0, v) * ln0) + height * angle) / q - 1;

  const double size = std::sqrt(to_double(q)), r0 = std::sqrt(to_double(q0)), r1 = std::sqrt(to_double(q1));
  const double h = to_double(height) / size, a = to_double(angle);
  const double ends = r0 * (19 * std::fabs(to_double(ln0)) + 2.5) + r1 * (19 * std::fabs(to_double(ln1)) + 2.5);
  result.error = kRoundoff<Real> * ((ends + 3.9 * a * std::min(r0, r1) + (17 * a + 15) * h) / size +
                                    std::fabs(to_double(result.value)) + 1.1) +
                 kLeastDistance<Real> / size;
  if (off > 0) {
    const double gap = to_double(sqrt(q0) + sqrt(q1) - sqrt(q)) - 8 * kRoundoff<Real> * (r0 + r1 + size);
    const double x = off / size;
    result.error += gap > 2048 * off ? 1.001 * x * same_bits::log((r0 + r1 + size) / gap) : modulus(x);
  }
  return result;
}

// A row of points of e, for each the mean over f.
template <class Real>
Approximation<Real> row_mean(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends, int n) {
  const LegendreRule<Real>& rule = legendre_rule<Real>(n);
  const double off = pair.error + kRoundoff<Real> * (2 * ends.length_of(0) + ends.farthest());
  Approximation<Real> sum;
  double largest = 0;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const LocalVector3<Real> w = pair.d - rule.node[k] * pair.u;
    const Approximation<Real> mean = log_from_point(w, w + pair.v, pair.v, off);
    sum.value += rule.weight[k] * mean.value;
    sum.error += to_double(rule.weight[k]) * mean.error;
    largest = std::max(largest, std::fabs(to_double(mean.value)));
  }
  sum.error = 1.001 * sum.error + kRoundoff<Real> * (n + 2) * largest;
  return sum;
}

// Two edges that begin in one point. With r = |t v - s u|, homogeneous in s and t, the divergence of (s, t) ln r is
// 2 ln r + 1: the integral is half that of ln r over the two sides of the square on which s or t is 1, less one half.
template <class Real>
Approximation<Real> joint_mean(const EdgePair3<Real>& pair) {
  const LocalVector3<Real> across = pair.v - pair.u;
  const Approximation<Real> from_e = log_from_point(-pair.u, across, pair.v, pair.error),
                            from_f = log_from_point(-pair.v, -across, pair.u, pair.error);
  Approximation<Real> result{(from_e.value + from_f.value - 1) / 2, 0};
  result.error = (from_e.error + from_f.error) / 2 +
                 kRoundoff<Real> * (std::fabs(to_double(from_e.value)) + std::fabs(to_double(from_f.value)) + 1);
  return result;
}

// Two parallel edges in the distance c: with H(x) = (x^2 - c^2)/4 ln(x^2 + c^2) + x c atan(x/c), whose second
// derivative is half the logarithm and 3/2, the integral of ln r over both lengths is H(f1 - e0) - H(f1 - e1) + H(f0 -
// e1) - H(f0 - e0) - 3/2 u.v, differences taken along e.
//
// Rounding: x and c are off by e_x and e_c, also because the axis may be off by an angle `tilt`, which changes H by
// less than r (e_x + e_c) (|ln r^2|/2 + 2.1); the logarithm is off by 2 off/r and 3 roundoffs, so H by r off/2 besides;
// then there are the errors of products and the library, and of u.v.
template <class Real>
Approximation<Real> parallel_mean(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends) {
  using same_bits::atan2, same_bits::log;
  const bool is_longer = ends.length_of(0) >= ends.length_of(1);
  const LocalVector3<Real>& axis = is_longer ? pair.u : pair.v;
  const Real q = square(axis);
  const double roundoff = kRoundoff<Real>, off = pair.error + 2 * roundoff * ends.farthest();
  const LocalVector3<Real>* nearest = &ends.at(0, 0);
  for (int k = 1; k < 4; ++k)
    if (square(ends.at(k / 2, k % 2)) < square(*nearest)) nearest = &ends.at(k / 2, k % 2);
  const Real c = length(cross(*nearest, axis));
  const double size_u = ends.length_of(0), size_v = ends.length_of(1);
  const double tilt = 1.001 * pair.error / std::max(size_u, size_v);
  const double off_c = off + (5.4 * roundoff + tilt) * to_double(length(*nearest));

  Real sum = 0;
  double error = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const LocalVector3<Real>& w = ends.at(a, b);
      const Real square_r = square(w), x = dot(w, axis);
      const Real ln = square_r > 0 ? log(square_r) : Real(0);
      const Real h = (x - c) * (x + c) / 4 * ln + x * c * atan2(x, c);
      sum += a == b ? Real(-h) : h;
      const double r = ends.size(a, b), size = std::fabs(to_double(ln));
      if (r > 1024 * off)
        error += r * (off + (3 * roundoff + tilt) * r + off_c) * (size / 2 + 2.1) + r * off / 2 +
                 roundoff * r * r * (5 * size + 17);
      else
        error += (r + off) * (r + off) * (2 * std::fabs(same_bits::log(r + off + kLeastDistance<Real>)) + 3);
    }
  const Real product = dot(pair.u, pair.v);
  Approximation<Real> result{sum / q / product - Real(1.5), 0};
  result.error =
      1.001 * error / std::fabs(to_double(product)) +
      (6 * roundoff + 1.001 * pair.error * (1 / size_u + 1 / size_v)) * (std::fabs(to_double(result.value)) + 1.5);
  return result;
}

// How far e is moved, at most, where it is turned about its beginning to be parallel to f.
template <class Real>
double tilt_of(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends) {
  const double size_u = ends.length_of(0), size_v = ends.length_of(1);
  return 1.001 * to_double(length(cross(pair.u, pair.v))) / size_v + 2.1 * pair.error * (1 + size_u / size_v) +
         8 * kRoundoff<Real> * size_u;
}

// The mean of e so turned, and what that changes. REQUIRES that f is not the shorter one.
template <class Real>
Approximation<Real> turned_mean(const EdgePair3<Real>& pair, double change) {
  EdgePair3<Real> turned = pair;
  turned.u = (dot(pair.u, pair.v) / square(pair.v)) * pair.v;
  turned.error = 3.1 * pair.error + 8 * kRoundoff<Real> * to_double(length(pair.u));
  Approximation<Real> mean = parallel_mean(turned, EdgeEnds3<Real>(turned));
  mean.error += change;
  return mean;
}

// Cuts pairs into cells until one of the formulas above is good for each.
template <class Real>
class CellSum {
 public:
  explicit CellSum(double tolerance) : tolerance_(tolerance) {}

  Approximation<Real> operator()(const EdgePair3<Real>& pair, EdgeContact3 contact) {
    cells_.push_back({pair, contact, 1});
    if (contact == EdgeContact3::kJoint) cells_.back().pair.d = {};
    while (!cells_.empty()) {
      const Cell<Real> cell = cells_.back();
      cells_.pop_back();
      ++count_;
      settle(cell);
    }
    const Real value = sum_.value();
    return {value, 1.001 * error_ + 3 * kRoundoff<Real> * std::fabs(to_double(value))};
  }

 private:
  void settle(const Cell<Real>& cell) {
    const EdgeEnds3<Real> ends(cell.pair);
    if (const auto mean = tensor(cell.pair, ends, tolerance_)) return add(*mean, cell.share);
    const double ratio = ends.length_of(0) / ends.length_of(1);
    if (cell.contact != EdgeContact3::kNone && count_ < kMaxCells<Real>) {
      if (ratio > kMaxRatio) return halve(cell);
      if (ratio < 1 / kMaxRatio) return halve(swapped(cell));
      return add(cell.contact == EdgeContact3::kJoint ? joint_mean(cell.pair) : parallel_mean(cell.pair, ends),
                 cell.share);
    }
    // The shorter one is cut, and of the longer one the mean is taken in closed form.
    if (ratio > 1)
      settle_row(swapped(cell));
    else
      settle_row(cell, ends);
  }

  void settle_row(const Cell<Real>& cell) { settle_row(cell, EdgeEnds3<Real>(cell.pair)); }
  void settle_row(const Cell<Real>& cell, const EdgeEnds3<Real>& ends) {
    const RowError3 row_error(cell.pair, ends);
    if (const int n = row_error.nodes_for(tolerance_, kMaxLegendreNodes<Real>)) {
      Approximation<Real> mean = row_mean(cell.pair, ends, n);
      mean.error += row_error(n);
      return add(mean, cell.share);
    }
    // Edges that are all but parallel: turned until they are, where that changes little enough.
    if (cell.contact == EdgeContact3::kNone && count_ < kMaxCells<Real>)
      if (const double change = modulus(tilt_of(cell.pair, ends) / ends.length_of(1)); change <= tolerance_) {
        if (ends.length_of(1) > kMaxRatio * ends.length_of(0)) return halve(swapped(cell));
        return add(turned_mean(cell.pair, change), cell.share);
      }
    // The middle for all of it, where the mean is continuous but may not be smooth.
    const double wide = modulus(ends.length_of(0) / ends.length_of(1) / 2);
    if (wide * to_double(cell.share) <= tolerance_ / 16 || count_ >= kMaxCells<Real>) {
      Approximation<Real> mean = row_mean(cell.pair, ends, 1);
      mean.error += wide;
      return add(mean, cell.share);
    }
    halve(cell);
  }

  // Cuts e in halves. Where both edges begin in one point, the first half does so too.
  void halve(const Cell<Real>& cell) {
    Cell<Real> first = cell;
    first.share /= 2;
    first.pair.u = Real(0.5) * cell.pair.u;
    Cell<Real> second = first;
    second.pair.d = cell.pair.d - first.pair.u;
    second.pair.error += kRoundoff<Real> * to_double(length(second.pair.d));
    if (cell.contact == EdgeContact3::kJoint) second.contact = EdgeContact3::kNone;
    cells_.push_back(first);
    cells_.push_back(second);
  }

  static Cell<Real> swapped(const Cell<Real>& cell) { return {cell.pair.swapped(), cell.contact, cell.share}; }

  void add(const Approximation<Real>& mean, Real share) {
    sum_.add(share * mean.value);
    error_ += to_double(share) * mean.error;
  }

  double tolerance_, error_ = 0;
  CompensatedSum<Real> sum_;
  std::vector<Cell<Real>> cells_;
  int count_ = 0;
};

// The two parts of f, from where e begins; their shares are as exact as their lengths.
template <class Real>
Approximation<Real> both_sides_mean(const EdgePair3<Real>& pair, double tolerance) {
  const Real size = length(pair.v);
  Approximation<Real> result;
  for (const LocalVector3<Real>& part : {pair.d, pair.d + pair.v}) {
    EdgePair3<Real> edges{{}, pair.u, part, pair.error};
    if (pair.error > 0) edges.error += kRoundoff<Real> * to_double(length(part));
    const Approximation<Real> mean = CellSum<Real>(tolerance)(edges, EdgeContact3::kJoint);
    const Real share = length(part) / size;
    result.value += share * mean.value;
    result.error += to_double(share) * mean.error +
                    (edges.error / to_double(size) + 8 * kRoundoff<Real>)*std::fabs(to_double(mean.value));
  }
  return result;
}

}  // namespace

template <class Real>
std::optional<Approximation<Real>> mean_log_of_distant(const EdgePair3<Real>& pair, double tolerance) {
  return tensor(pair, EdgeEnds3<Real>(pair), tolerance);
}

template <class Real>
Approximation<Real> mean_log_of_near(const EdgePair3<Real>& pair, EdgeContact3 contact, double tolerance) {
  if (contact == EdgeContact3::kEndOn) return both_sides_mean(pair, tolerance);
  return CellSum<Real>(tolerance)(pair, contact);
}

template std::optional<Approximation<double>> mean_log_of_distant(const EdgePair3<double>&, double);
template std::optional<Approximation<long double>> mean_log_of_distant(const EdgePair3<long double>&, double);
template std::optional<Approximation<WideReal>> mean_log_of_distant(const EdgePair3<WideReal>&, double);
template Approximation<double> mean_log_of_near(const EdgePair3<double>&, EdgeContact3, double);
template Approximation<long double> mean_log_of_near(const EdgePair3<long double>&, EdgeContact3, double);
template Approximation<WideReal> mean_log_of_near(const EdgePair3<WideReal>&, EdgeContact3, double);

}  // namespace hottel
