#include "geometry/space/integrals/edge_integral.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/integrals/arc_lanes.h"
#include "kernel/legendre_rule.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

// The points of the two rules.
template <class Real>
inline constexpr int kCoarse = 6;
template <class Real>
inline constexpr int kFine = 9;
template <>
inline constexpr int kCoarse<LongerReal> = 10;
template <>
inline constexpr int kFine<LongerReal> = 14;
template <>
inline constexpr int kCoarse<WideReal> = 14;
template <>
inline constexpr int kFine<WideReal> = 20;
// Two rules may agree by chance: their difference is held to this part of the tolerance.
constexpr double kSafety = 8;
// Where rounding makes more than this part of the tolerance, no more is won than to be as good as it.
constexpr double kMostRounding = 0.8;
// Where rounding makes more than all that is allowed, and two rules differ by less than this part of it, no more is
// won.
constexpr double kMostNoise = 0.5;
// Where the value cannot be told, so often parts are halved for the residual.
constexpr std::uint32_t kMostWhereHopeless = 1000;
// Where what happens is steep, parts of a stretch are not divided below this beforehand.
constexpr double kShortest = 0x1p-48;
template <class Real>
inline constexpr std::uint32_t kMostBisections = 20000;
template <>
inline constexpr std::uint32_t kMostBisections<LongerReal> = 1000;
template <>
inline constexpr std::uint32_t kMostBisections<WideReal> = 1000;

double in_double(double value) { return value; }
template <class Real>
double in_double(const Real& value) {
  return static_cast<double>(value);
}
const Direction3& in_doubles(const Direction3& a) { return a; }
template <class Real>
Direction3 in_doubles(const LocalVector3<Real>& a) {
  return {in_double(a.x), in_double(a.y), in_double(a.z)};
}

// The integrals of Lambda by both rules, and what an angle of the fine one may have lost, at most.
template <class Real>
struct Integrals {
  ArcVector3<Real> coarse, fine;
  double rounding = 0;
};

template <class Real, class LambdaAt>
ArcVector3<Real> integral(int n, Real width, const LambdaAt& lambda_at) {
  const LegendreRule<Real>& rule = legendre_rule<Real>(n);
  ArcVector3<Real> sum;
  for (int k = 0; k < n; ++k) sum = sum + rule.weight[k] * lambda_at(k, Real(rule.node[k] * width));
  return width * sum;
}

template <class Real, class Piece>
Integrals<Real> integrals_point_by_point(const Piece& piece, double low, double high) {
  const Real width = Real(high) - Real(low);
  Integrals<Real> result;
  const auto at = [&](double* rounding) {
    return [&piece, low, rounding](int, const Real& offset) { return piece.lambda(low, offset, rounding); };
  };
  result.coarse = integral<Real>(kCoarse<Real>, width, at(nullptr));
  result.fine = integral<Real>(kFine<Real>, width, at(&result.rounding));
  return result;
}

template <class Real, class Piece>
Integrals<Real> integrals(const Piece& piece, double low, double high) {
  return integrals_point_by_point<Real>(piece, low, high);
}

// The points of both rules at once, where that is possible: the same numbers.
template <>
Integrals<double> integrals(const StretchPiece3& piece, double low, double high) {
  constexpr std::size_t kFirst = kCoarse<double>, kCount = kFirst + kFine<double>;
  static_assert(kCount <= kLanes3);
  const double width = high - low;
  Lanes3 offsets, rounding;
  for (std::size_t k = 0; k < kLanes3; ++k)
    offsets[k] = width * (k < kFirst ? legendre_rule<double>(kCoarse<double>).node[k]
                                     : legendre_rule<double>(kFine<double>).node[std::min(k, kCount - 1) - kFirst]);
  VectorLanes3 lambda;
  if (!sum_of_arcs_in_lanes(piece.arcs, piece.corners, piece.planes, low, offsets, lambda, rounding))
    return integrals_point_by_point<double>(piece, low, high);
  const auto lanes_from = [&](std::size_t first) {
    return [&lambda, first](int node, double) {
      const std::size_t k = first + static_cast<std::size_t>(node);
      return Direction3{lambda.x[k], lambda.y[k], lambda.z[k]};
    };
  };
  return {integral<double>(kCoarse<double>, width, lanes_from(0)),
          integral<double>(kFine<double>, width, lanes_from(kFirst)),
          *std::max_element(rounding.begin() + kFirst, rounding.begin() + kCount)};
}

}  // namespace

template <class Real>
std::uint32_t EdgeIntegral3<Real>::add_stretch(const Vector& way, const Vector& moment) {
  stretches_.push_back({way, moment, in_double(length(way)), in_double(length(moment))});
  return static_cast<std::uint32_t>(stretches_.size() - 1);
}

template <class Real>
void EdgeIntegral3<Real>::add(Piece piece, std::uint32_t stretch) {
  pieces_.push_back(std::move(piece));
  const auto place = static_cast<std::uint32_t>(pieces_.size() - 1);
  has_arcs_.push_back(0);
  keep_arcs(place);
  add_parts(place, stretch, pieces_.back().low, pieces_.back().high);
}

template <class Real>
const typename EdgeIntegral3<Real>::Piece& EdgeIntegral3<Real>::with_arcs(std::uint32_t piece) {
  if (has_arcs_[piece] == 0) {
    make_arcs_(piece, pieces_[piece]);
    keep_arcs(piece);
  }
  return pieces_[piece];
}

template <class Real>
void EdgeIntegral3<Real>::keep_arcs(std::uint32_t piece) {
  has_arcs_[piece] = 1;
  with_arcs_.push_back(piece);
  bytes_of_arcs_ += pieces_[piece].bytes();
  while (bytes_of_arcs_ > most_bytes_ && with_arcs_.front() != piece) {
    Piece& first = pieces_[with_arcs_.front()];
    bytes_of_arcs_ -= first.bytes();
    first.give_up_arcs();
    has_arcs_[with_arcs_.front()] = 0;
    with_arcs_.pop_front();
  }
}

template <class Real>
EdgeValues3 EdgeIntegral3<Real>::refine(double tolerance, double residual_tolerance) {
  const auto badness = [&](const Part& part) {
    return std::max(part.error / tolerance, part.residual_error / residual_tolerance);
  };
  const auto is_better = [&](const std::pair<double, std::uint32_t>& a, const std::pair<double, std::uint32_t>& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::vector<std::pair<double, std::uint32_t>> heap;
  for (std::uint32_t k = 0; k < parts_.size(); ++k) heap.emplace_back(badness(parts_[k]), k);
  std::make_heap(heap.begin(), heap.end(), is_better);
  for (std::uint32_t count = 0; count < kMostBisections<Real> && !heap.empty(); ++count) {
    if (count % 64 == 0) sum_up();
    const bool is_hopeless = (rounding_ > kMostRounding * tolerance && kSafety * error_ <= rounding_) ||
                             (rounding_ > tolerance && error_ <= kMostNoise * rounding_);
    const bool is_done = kSafety * error_ + rounding_ <= 0.99 * tolerance;
    const bool is_noise = residual_rounding_ > residual_tolerance && residual_error_ <= kMostNoise * residual_rounding_;
    if ((is_done || is_hopeless) && (is_noise || residual_error_ <= residual_tolerance)) break;
    if (is_hopeless && count >= kMostWhereHopeless) break;
    std::pop_heap(heap.begin(), heap.end(), is_better);
    const std::uint32_t worst = heap.back().second;
    heap.pop_back();
    const Part part = parts_[worst];
    const double middle = (part.low + part.high) / 2;
    if (!(part.low < middle && middle < part.high)) continue;
    if (part.error <= part.rounding && part.residual_error <= part.residual_rounding) continue;
    parts_[worst] = make_part(part.piece, part.stretch, part.low, middle);
    parts_.push_back(make_part(part.piece, part.stretch, middle, part.high));
    error_ += parts_[worst].error + parts_.back().error - part.error;
    residual_error_ += parts_[worst].residual_error + parts_.back().residual_error - part.residual_error;
    for (const std::uint32_t k : {worst, static_cast<std::uint32_t>(parts_.size() - 1)}) {
      heap.emplace_back(badness(parts_[k]), k);
      std::push_heap(heap.begin(), heap.end(), is_better);
    }
  }
  sum_up();
  return {in_double(value_), kSafety * error_ + rounding_, in_doubles(residual_),
          kSafety * residual_error_ + residual_rounding_};
}

template <class Real>
std::vector<double> EdgeIntegral3<Real>::of_pieces() const {
  std::vector<double> result(pieces_.size(), 0);
  for (const Part& part : parts_)
    result[part.piece] += in_double(Real(dot(stretches_[part.stretch].moment, part.value)));
  return result;
}

template <class Real>
void EdgeIntegral3<Real>::add_parts(std::uint32_t piece, std::uint32_t stretch, double low, double high) {
  if (high - low > kShortest && with_arcs(piece).is_steep(low, high)) {
    add_parts(piece, stretch, low, (low + high) / 2);
    add_parts(piece, stretch, (low + high) / 2, high);
  } else {
    parts_.push_back(make_part(piece, stretch, low, high));
  }
}

template <class Real>
typename EdgeIntegral3<Real>::Part EdgeIntegral3<Real>::make_part(std::uint32_t piece, std::uint32_t stretch,
                                                                  double low, double high) {
  const auto [coarse, fine, most_rounding] = integrals<Real>(with_arcs(piece), low, high);
  const double rounding = most_rounding * (high - low);
  nodes_ += kCoarse<Real> + kFine<Real>;
  Part part{piece, stretch, low, high, fine, 0, 0, 0, 0};
  part.rounding = rounding * stretches_[stretch].moment_size;
  part.residual_rounding = rounding * stretches_[stretch].way_size;
  part.error = std::fabs(in_double(Real(dot(stretches_[stretch].moment, fine - coarse))));
  part.residual_error = in_double(length(cross(stretches_[stretch].way, fine - coarse)));
  return part;
}

template <class Real>
void EdgeIntegral3<Real>::sum_up() {
  value_ = 0;
  error_ = residual_error_ = residual_rounding_ = 0;
  rounding_ = fixed_error_;
  residual_ = {};
  for (const Part& part : parts_) {
    value_ += dot(stretches_[part.stretch].moment, part.value);
    error_ += part.error;
    rounding_ += part.rounding;
    residual_ = residual_ + cross(stretches_[part.stretch].way, part.value);
    residual_error_ += part.residual_error;
    residual_rounding_ += part.residual_rounding;
  }
  if (const Real along = dot(residual_, expected_); along > 0) residual_ = residual_ - along * expected_;
}

template class EdgeIntegral3<double>;
template class EdgeIntegral3<long double>;
template class EdgeIntegral3<LongerReal>;
template class EdgeIntegral3<WideReal>;

}  // namespace hottel
