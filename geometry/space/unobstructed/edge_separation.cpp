#include "geometry/space/unobstructed/edge_separation.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "kernel/plain_functions.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

using std::numbers::pi;

constexpr double kSlack = 1 - 0x1p-40;  // what bounds are cut by for the sake of their own rounding
constexpr double kUnknown = std::numeric_limits<double>::infinity();

template <class Real>
double to_double(Real value) {
  return static_cast<double>(value);
}

// The parameter of the ellipse of this sum; 1 where there is none.
double ellipse(double sum) { return sum > 1 ? sum + std::sqrt(sum * sum - 1) : 1; }

}  // namespace

double log_error_3(int n, double rho) {
  const double r = 1 / (rho * rho);
  return 1.07 / n * same_bits::pow(r, n) / (1 - r);
}

int nodes_for_logs_3(double rho, double tolerance, int most) {
  if (rho < 1.5) return 0;
  const double r = 1 / (rho * rho), r2 = r * r;
  double power = r2;
  for (int n = 2; n <= most; n += 2, power *= r2)
    if (1.07 * power <= tolerance * n * (1 - r)) return n;
  return 0;
}

template <class Real>
EdgeEnds3<Real>::EdgeEnds3(const EdgePair3<Real>& pair) : u_(pair.u), v_(pair.v) {
  at_[0][0] = pair.d;
  at_[1][0] = pair.d - pair.u;
  at_[0][1] = pair.d + pair.v;
  at_[1][1] = at_[0][1] - pair.u;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      size_[a][b] = length(at_[a][b]);
      farthest_ = std::max(farthest_, to_double(size_[a][b]));
    }
  length_[0] = length(u_);
  length_[1] = length(v_);
  blur_ = 16 * kRoundoff<Real> * (farthest_ + to_double(length_[0]) + to_double(length_[1]));
}

template <class Real>
double EdgeEnds3<Real>::least_sum(int edge) const {
  const Real other = length_[1 - edge];
  const LocalVector3<Real>& w = edge == 0 ? v_ : u_;
  const auto start = [&](int focus) { return edge == 0 ? at_[focus][0] : -at_[0][focus]; };
  const auto size = [&](int focus, int end) { return edge == 0 ? size_[focus][end] : size_[end][focus]; };
  // Where the sum grows from an end on, that end has the least one. Slopes are off by less than `doubt`; the least
  // sum on the line of f is never above that on f.
  std::array<Real, 2> foot, slope{0, 0}, doubt{0, 0};
  for (int k = 0; k < 2; ++k) {
    foot[k] = -dot(start(k), w) / other;
    const std::array<Real, 2> along{-foot[k], foot[k] - other};
    for (int end = 0; end < 2; ++end) {
      const Real r = 1 / std::max(size(k, end), Real(kLeastDistance<Real>));
      slope[end] += along[end] * r;
      doubt[end] += static_cast<Real>(blur_) * r;
    }
  }
  Real sum;
  if (slope[0] > doubt[0]) {
    sum = size(0, 0) + size(1, 0);
  } else if (slope[1] > doubt[1]) {
    sum = size(0, 1) + size(1, 1);
  } else {
    const Real along = foot[0] - foot[1], across = height(edge, 0) + height(edge, 1);
    using std::sqrt;
    sum = sqrt(along * along + across * across);
  }
  return (to_double(sum) * kSlack - blur_) / to_double(length_[edge]);
}

template <class Real>
Real EdgeEnds3<Real>::height(int edge, int k) const {
  const LocalVector3<Real>& w = edge == 0 ? v_ : u_;
  const bool is_first = edge == 0 ? size_[k][0] <= size_[k][1] : size_[0][k] <= size_[1][k];
  const LocalVector3<Real>& from = edge == 0 ? at_[k][is_first ? 0 : 1] : at_[is_first ? 0 : 1][k];
  return length(cross(from, w)) / length_[1 - edge];
}

template <class Real>
Reach3::Reach3(const EdgeEnds3<Real>& ends) : farthest(ends.farthest()) {
  const double e = ends.least_sum(0), f = ends.least_sum(1);
  rho_e = ellipse(e);
  rho_f = ellipse(f);
  nearest = 0.5 * std::max((e - 1) * ends.length_of(0), (f - 1) * ends.length_of(1));
}

double Reach3::largest_log() const {
  return std::max(std::fabs(same_bits::log(nearest)), std::fabs(same_bits::log(farthest)));
}

template <class Real>
RowError3::RowError3(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends) : rho_(ellipse(ends.least_sum(0))) {
  const double length_e = ends.length_of(0), length_f = ends.length_of(1), blur = ends.blur();
  for (int k = 0; k < 2; ++k) {
    const double foot = -to_double(dot(ends.at(k, 0), pair.v)) / length_f;
    if (!(blur < foot && foot < length_f - blur)) return;
  }
  heights_ = to_double(ends.height(0, 0) + ends.height(0, 1));
  const double slope = to_double(length(cross(pair.u, pair.v))) / length_f;
  rho_line_ = ellipse((heights_ * kSlack - blur) / (slope + blur));
  for (int k = 0; k < 2; ++k) {
    const double sum = (ends.size(0, k) + ends.size(1, k)) * kSlack / length_e;
    rho_end_[k] = ellipse(sum - blur / length_e);
    scale_[k] = 1.001 * sum * length_e / length_f;
  }
  heights_ = 1.001 * (heights_ + blur) / length_f;
  has_line_ = std::min({rho_line_, rho_end_[0], rho_end_[1]}) > rho_;
}

double RowError3::operator()(int n) const {
  if (!has_line_) return rho_ > 1.01 ? log_error_3(n, rho_) : kUnknown;
  if (std::min({rho_line_, rho_end_[0], rho_end_[1]}) < 1.01) return kUnknown;
  const double r = 1 / (rho_line_ * rho_line_);
  double error = 32.0 / 15 * pi * heights_ * same_bits::pow(r, n) / (1 - r);
  for (int k = 0; k < 2; ++k) error += log_error_3(n, rho_end_[k]) * 2 * n / (2 * n - 1) * scale_[k];
  return error;
}

int RowError3::nodes_for(double tolerance, int most) const {
  const double rho = has_line_ ? std::min({rho_line_, rho_end_[0], rho_end_[1]}) : rho_;
  if (rho < 1.8) return 0;
  const int least = static_cast<int>(same_bits::log(0.01 / tolerance) / (2 * same_bits::log(rho)));
  for (int n = std::max(2, (least + 1) / 2 * 2); n <= most; n += 2)
    if ((*this)(n) <= tolerance) return n;
  return 0;
}

template class EdgeEnds3<double>;
template class EdgeEnds3<long double>;
template class EdgeEnds3<WideReal>;
template Reach3::Reach3(const EdgeEnds3<double>&);
template Reach3::Reach3(const EdgeEnds3<long double>&);
template Reach3::Reach3(const EdgeEnds3<WideReal>&);
template RowError3::RowError3(const EdgePair3<double>&, const EdgeEnds3<double>&);
template RowError3::RowError3(const EdgePair3<long double>&, const EdgeEnds3<long double>&);
template RowError3::RowError3(const EdgePair3<WideReal>&, const EdgeEnds3<WideReal>&);

}  // namespace hottel
