#include "geometry/space/proven/piece_enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <type_traits>

#include "kernel/legendre_rule.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

constexpr int kFewestNodes = 4, kMostNodes = 20;
// An ellipse has no larger rho than the first, nor than this part of that of the nearest singularity: wider ones need
// more discs than they save nodes.
constexpr double kMostRho = 4, kOfNearest = 0.65, kLeastRho = 1.7;
// So often a part is halved, all parts of a piece together, the discs of an ellipse are divided, and so many there are.
constexpr int kMostHalvings = 40, kAllHalvings = 128, kMostDivisions = 4, kMostDiscs = 80;
// A bound on an ellipse that is this many times as large as the integrand could be says little.
constexpr double kLoose = 64;

template <class Number>
Number half_turn(Number*);
template <>
Disc3 half_turn(Disc3*) {
  return {std::numbers::pi, 0, 0x1p-51};
}
template <>
Ball3<double> half_turn(Ball3<double>*) {
  return {std::numbers::pi, 0x1p-51};
}
template <>
Ball3<WideReal> half_turn(Ball3<WideReal>*) {
  static const WideReal pi = pi_of<WideReal>();
  return {pi, 16 * kRoundoff<WideReal>};
}

// The half axes of the ellipse, in half lengths, rounded up.
struct Axes {
  double along, across;
  explicit Axes(double rho) : along((rho + 1 / rho) / 2 * (1 + 0x1p-40)), across((rho - 1 / rho) / 2 * (1 + 0x1p-40)) {}
};

// A rectangle, in half lengths, by its middle.
struct Cell {
  double x, y, half_width, half_height;
  int divisions;

  bool misses(const Axes& axes) const {
    const double a = std::max(0.0, std::fabs(x) - half_width) / axes.along;
    const double b = std::max(0.0, std::fabs(y) - half_height) / axes.across;
    return a * a + b * b > 1 + 0x1p-30;
  }
  double radius() const { return std::sqrt(half_width * half_width + half_height * half_height); }
};

}  // namespace

double error_of_rule_3(double largest, double rho, int n) {
  constexpr double kRoundings = 1 + 0x1p-30;
  return largest * (64.0 / 15) * std::pow(rho, -2 * n) / (1 - 1 / (rho * rho)) * kRoundings;
}

template <class Real>
PieceEncloser3<Real>::PieceEncloser3(const ProvenPiece3<Real>& piece, const ProvenMoment3<Real>& moment, double allowed,
                                     double most_seen, ProofCounts3& counts)
    : piece_(piece),
      moment_(moment),
      allowed_(allowed),
      most_seen_(most_seen),
      halvings_left_(kAllHalvings),
      counts_(counts) {
  for (const ProvenVector3<Real>& plane : piece.planes) in_doubles_.planes.push_back(in_doubles_3(plane));
  for (const ProvenVector3<Real>& corner : piece.corners) in_doubles_.corners.push_back(in_doubles_3(corner));
  in_doubles_.arcs = piece.arcs;
  const LocalVector3<Real>& m = moment.value;
  moment_in_doubles_ = {{static_cast<double>(m.x), static_cast<double>(m.y), static_cast<double>(m.z)},
                        up(moment.error + 0x1p-52 * moment.size),
                        moment.size};
  turns_.resize(piece.arcs.size());
}

template <class Real>
Ball3<double> PieceEncloser3<Real>::enclose(double low, double high) {
  return enclose(low, high, 0);
}

template <class Real>
Ball3<double> PieceEncloser3<Real>::enclose(double low, double high, int halvings) {
  if (const auto result = enclose_by_rule(low, high)) return *result;
  const double middle = low + (high - low) / 2;
  if (halvings == kMostHalvings || --halvings_left_ < 0 || !(low < middle && middle < high)) {
    ++counts_.failures;
    largest_ = std::max(largest_, moment_.size * most_seen_);
    return {0, up(up(high - low) * moment_.size * most_seen_)};
  }
  ++counts_.halvings;
  return enclose(low, middle, halvings + 1) + enclose(middle, high, halvings + 1);
}

// Where the nearest zero of a normal, or of a direction that is linear, lets an ellipse reach; those of others are
// found when discs meet them.
template <class Real>
double PieceEncloser3<Real>::nearest_singularity(double middle, double half) const {
  double nearest = 2 * kMostRho;
  const auto take = [&](const ProvenVector3<double>& v) {
    const LocalVector3<double>&p = v.power[0], &q = v.power[1];
    const double square = dot(q, q);
    if (!v.is_linear || !(square > 0)) return;
    const double at = -dot(p, q) / square;
    const LocalVector3<double> there = p + at * q;
    const std::complex<double> z((at + v.base - middle) / half, std::sqrt(dot(there, there) / square) / half);
    const std::complex<double> r = std::sqrt(z * z - 1.0);
    nearest = std::min(nearest, std::max(std::abs(z + r), std::abs(z - r)));
  };
  for (const ProvenVector3<double>& plane : in_doubles_.planes) take(plane);
  for (const ProvenVector3<double>& corner : in_doubles_.corners) take(corner);
  return nearest;
}

template <class Real>
std::optional<Ball3<double>> PieceEncloser3<Real>::enclose_by_rule(double low, double high) {
  const double middle = low + (high - low) / 2, half = up((high - low) / 2);
  double rho = std::min(kMostRho, kOfNearest * nearest_singularity(middle, half));
  if (!(rho > kLeastRho) || !find_turns(middle)) return {};
  find_polynomials(middle);
  for (; rho > kLeastRho; rho = std::sqrt(rho)) {
    const std::optional<double> largest = largest_on_ellipse(half, rho);
    if (!largest) continue;
    int n = kFewestNodes;
    while (n < kMostNodes && error_of_rule_3(*largest, rho, n) > 2 * allowed_) ++n;
    const double error = up(error_of_rule_3(*largest, rho, n) * half);
    if (error > 2 * allowed_ * half) return {};
    const LegendreRule<Real>& rule = legendre_rule<Real>(n);
    Ball3<Real> sum;
    const Real width = Real(high) - Real(low);
    const double last = 8 * kRoundoff<Real>;  // what nodes and weights may be off
    for (int k = 0; k < n; ++k) {
      const Ball3<Real> offset{Real(rule.node[k] * width), up(last * (high - low))};
      sum = sum + Ball3<Real>{rule.weight[k], last} * at_node(low, offset);
    }
    sum = sum * Ball3<Real>{width, kRoundoff<Real> * (high - low)};
    const double value = static_cast<double>(sum.mid);
    if (!(std::isfinite(value) && std::isfinite(sum.rad))) return {};
    ++counts_.parts;
    largest_ = std::max(largest_, *largest);
    return Ball3<double>{value, up(sum.rad + error + 0x1p-52 * std::fabs(value))};
  }
  return {};
}

// In the middle of a part: an angle never passes half a turn, so its sign stays where it is more than a right angle.
template <class Real>
bool PieceEncloser3<Real>::find_turns(double middle) {
  thread_local std::vector<ProvenPoint3<Ball3<Real>>> corners;
  corners.clear();
  for (const ProvenVector3<Real>& corner : piece_.corners) {
    const Ball3<Real> s = Ball3<Real>{Real(middle), 0} + Ball3<Real>{Real(-corner.base), 0};
    corners.push_back(at(corner, s));
  }
  for (std::size_t k = 0; k < piece_.arcs.size(); ++k) {
    const SeenArc3& arc = piece_.arcs[k];
    const Ball3<Real> cosine = dot(corners[arc.begin], corners[arc.end]);
    turns_[k] = 0;
    if (!(cosine.mid < 0)) continue;
    const ProvenVector3<Real>& plane = piece_.planes[arc.plane];
    const Ball3<Real> s = Ball3<Real>{Real(middle), 0} + Ball3<Real>{Real(-plane.base), 0};
    const Ball3<Real> sine = dot(at(plane, s), cross(corners[arc.begin], corners[arc.end]));
    if (!(size_of(sine.mid) > up(up(sine.rad)))) return false;
    turns_[k] = sine.mid > 0 ? 1 : -1;
  }
  return true;
}

template <class Real>
template <class Number>
void PieceEncloser3<Real>::find_parts(const std::vector<ProvenPoint3<Number>>& corners,
                                      const std::vector<ProvenPoint3<Number>>& normals,
                                      const ProvenPoint3<Number>& moment, Parts<Number>& parts) const {
  for (auto* list : {&parts.corner_squares, &parts.plane_squares, &parts.moments, &parts.sines, &parts.cosines})
    list->clear();
  for (const ProvenPoint3<Number>& corner : corners) parts.corner_squares.push_back(dot(corner, corner));
  for (const ProvenPoint3<Number>& normal : normals) {
    parts.plane_squares.push_back(dot(normal, normal));
    parts.moments.push_back(dot(moment, normal));
  }
  for (const SeenArc3& arc : piece_.arcs) {
    const ProvenPoint3<Number>&b = corners[arc.begin], &e = corners[arc.end];
    parts.sines.push_back(dot(normals[arc.plane], cross(b, e)));
    parts.cosines.push_back(dot(b, e));
  }
}

template <class Real>
template <class Number>
Number PieceEncloser3<Real>::integrand(const Parts<Number>& parts) const {
  thread_local std::vector<Number> lengths, over_lengths;
  lengths.clear();
  over_lengths.clear();
  for (const Number& square : parts.corner_squares) lengths.push_back(root(square));
  for (const Number& square : parts.plane_squares) over_lengths.push_back(inverse(root(square)));
  const Number two = Number::of(2, 0), half = half_turn(static_cast<Number*>(nullptr));
  Number sum{};
  for (std::size_t k = 0; k < piece_.arcs.size(); ++k) {
    const SeenArc3& arc = piece_.arcs[k];
    const Number both = lengths[arc.begin] * lengths[arc.end], sine = parts.sines[k] * over_lengths[arc.plane];
    const Number rest = turns_[k] == 0 ? both + parts.cosines[k] : both - parts.cosines[k];
    Number angle = two * arc_tangent(sine * inverse(rest));
    if (turns_[k] != 0) angle = (turns_[k] > 0 ? half : -half) - angle;
    sum = sum + Number::of(arc.count / 2, 0) * (parts.moments[arc.plane] * over_lengths[arc.plane]) * angle;
  }
  return sum;
}

template <class Real>
Ball3<Real> PieceEncloser3<Real>::at_node(double from, const Ball3<Real>& offset) {
  using Number = Ball3<Real>;
  const auto since = [&](double base) { return (Number::of(Real(from), 0) + Number::of(Real(-base), 0)) + offset; };
  const auto number = [&](const Real& value) { return Number::of(value, moment_.error); };
  thread_local std::vector<ProvenPoint3<Number>> corners, normals;
  thread_local Parts<Number> parts;
  corners.clear();
  normals.clear();
  for (const ProvenVector3<Real>& corner : piece_.corners) corners.push_back(at(corner, since(corner.base)));
  for (const ProvenVector3<Real>& plane : piece_.planes) normals.push_back(at(plane, since(plane.base)));
  const LocalVector3<Real>& m = moment_.value;
  find_parts<Number>(corners, normals, {number(m.x), number(m.y), number(m.z)}, parts);
  return integrand(parts);
}

template <class Real>
void PieceEncloser3<Real>::find_polynomials(double middle) {
  const auto constant = [&](double value) { return polynomial_3(Ball3<double>::of(value, moment_in_doubles_.error)); };
  thread_local std::vector<ProvenPoint3<ProvenPolynomial3>> corners, normals;
  corners.clear();
  normals.clear();
  for (const ProvenVector3<double>& corner : in_doubles_.corners) corners.push_back(about(corner, middle));
  for (const ProvenVector3<double>& plane : in_doubles_.planes) normals.push_back(about(plane, middle));
  const LocalVector3<double>& m = moment_in_doubles_.value;
  find_parts<ProvenPolynomial3>(corners, normals, {constant(m.x), constant(m.y), constant(m.z)}, polynomials_);
}

template <class Real>
Disc3 PieceEncloser3<Real>::over_disc(const Disc3& offset) {
  thread_local Parts<Disc3> parts;
  const auto enclose = [&](const std::vector<ProvenPolynomial3>& from, std::vector<Disc3>& to) {
    to.clear();
    for (const ProvenPolynomial3& polynomial : from) to.push_back(over(polynomial, offset));
  };
  enclose(polynomials_.corner_squares, parts.corner_squares);
  enclose(polynomials_.plane_squares, parts.plane_squares);
  enclose(polynomials_.moments, parts.moments);
  enclose(polynomials_.sines, parts.sines);
  enclose(polynomials_.cosines, parts.cosines);
  return integrand(parts);
}

// All numbers are real on the axis: what holds in the upper half holds in the lower one.
template <class Real>
std::optional<double> PieceEncloser3<Real>::largest_on_ellipse(double half, double rho) {
  const Axes axes(rho);
  const double x = axes.along / 2, y = axes.across / 2;
  std::array<Cell, 4 * kMostDivisions + 2> stack{Cell{-x, y, x, y, 0}, Cell{x, y, x, y, 0}};
  std::size_t count = 2;
  double largest = 0;
  for (int discs = 0; count > 0;) {
    const Cell cell = stack[--count];
    if (cell.misses(axes)) continue;
    if (++discs > kMostDiscs) return {};
    // The middle as a double may be off by half a unit of its last place, and so may the middle of the disc.
    const double radius = up(half * cell.radius() + 0x1p-50 * half * rho + 0x1p-52);
    const Disc3 offset{half * cell.x, half * cell.y, radius};
    const Disc3 there = over_disc(offset);
    const double size = up(there.size() + there.rad);
    if (size <= kLoose * moment_.size) {
      largest = std::max(largest, size);
      continue;
    }
    if (cell.divisions == kMostDivisions) return {};
    const double w = cell.half_width / 2, h = cell.half_height / 2;
    for (const int k : {0, 1, 2, 3})
      stack[count++] = {cell.x + (k % 2 == 0 ? -w : w), cell.y + (k < 2 ? h : -h), w, h, cell.divisions + 1};
  }
  return largest;
}

template class PieceEncloser3<double>;
template class PieceEncloser3<WideReal>;

}  // namespace hottel
