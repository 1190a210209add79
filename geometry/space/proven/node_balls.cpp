#include "geometry/space/proven/node_balls.h"

#include <vector>

namespace hottel {
namespace {

using namespace ball_arithmetic_3;
using Number = Ball3<WideReal>;
using Point = ProvenPoint3<Number>;

Number half_turn(int turn) {
  static const WideReal pi = pi_of<WideReal>();
  return {WideReal(turn * pi), 16 * kRoundoff<WideReal>};
}

// An arc at one t: with R = |b| |e| its angle is 2 atan(X / (R + Y)), or half a turn less 2 atan(X / (R - Y)).
std::optional<Number> angle_of(const Number& both, const Number& sine, const Number& cosine, int turn) {
  const Number two = Number::of(2, 0);
  if (!(cosine.mid < 0)) return two * arc_tangent(sine * inverse(both + cosine));
  if (turn == 0 && !(size_of(sine.mid) > up(up(sine.rad)))) return {};
  if (turn == 0) turn = sine.mid > 0 ? 1 : -1;
  return half_turn(turn) - two * arc_tangent(sine * inverse(both - cosine));
}

// The integrand at a node.
std::optional<Number> at_node(const ProvenPiece3<WideReal>& piece, const Point& moment,
                              std::span<const signed char> turns, double from, const Number& offset) {
  const auto since = [&](double base) {
    return (Number::of(WideReal(from), 0) + Number::of(WideReal(-base), 0)) + offset;
  };
  thread_local std::vector<Point> corners, normals;
  thread_local std::vector<Number> lengths, over_lengths;
  for (auto* list : {&corners, &normals}) list->clear();
  for (auto* list : {&lengths, &over_lengths}) list->clear();
  for (const ProvenVector3<WideReal>& corner : piece.corners) {
    corners.push_back(at(corner, since(corner.base)));
    lengths.push_back(root(dot(corners.back(), corners.back())));
  }
  for (const ProvenVector3<WideReal>& plane : piece.planes) {
    normals.push_back(at(plane, since(plane.base)));
    over_lengths.push_back(inverse(root(dot(normals.back(), normals.back()))));
  }
  Number sum;
  for (std::size_t k = 0; k < piece.arcs.size(); ++k) {
    const SeenArc3& arc = piece.arcs[k];
    const Point &b = corners[arc.begin], &e = corners[arc.end], &n = normals[arc.plane];
    const Number over = over_lengths[arc.plane];
    const auto angle = angle_of(lengths[arc.begin] * lengths[arc.end], dot(n, cross(b, e)) * over, dot(b, e), turns[k]);
    if (!angle) return {};
    sum = sum + Number::of(arc.count / 2, 0) * (dot(moment, n) * over) * *angle;
  }
  return sum;
}

}  // namespace

std::optional<Ball3<WideReal>> mean_at_nodes_3(const ProvenPiece3<WideReal>& piece,
                                               const ProvenMoment3<WideReal>& moment,
                                               std::span<const signed char> turns, const LegendreRule<WideReal>& rule,
                                               double low, double high) {
  constexpr double kLast = 8 * kRoundoff<WideReal>;  // what nodes and weights may be off
  const auto number = [&](const WideReal& value) { return Number::of(value, moment.error); };
  const Point m{number(moment.value.x), number(moment.value.y), number(moment.value.z)};
  const WideReal width = WideReal(high) - WideReal(low);
  Number sum;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const auto value = at_node(piece, m, turns, low, {WideReal(rule.node[k] * width), up(kLast * (high - low))});
    if (!value) return {};
    sum = sum + Number{rule.weight[k], kLast} * *value;
  }
  return sum;
}

}  // namespace hottel
