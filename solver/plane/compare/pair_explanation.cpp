#include "solver/plane/compare/pair_explanation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/plane/exchange/unobstructed.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/division.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

// The straight line an element lies on, ends as typed. (What other surfaces own of it is not cut off.)
struct Line {
  Point2 from, to;
  bool is_back;

  Point2 middle() const { return {(from.x + to.x) / 2, (from.y + to.y) / 2}; }
  double length() const { return std::hypot(to_double(to.x - from.x), to_double(to.y - from.y)); }
  std::array<double, 2> normal() const {  // to the right of from -> to, for a front
    const double sign = is_back ? -1 : 1;
    return {sign * to_double(to.y - from.y), -sign * to_double(to.x - from.x)};
  }
};

Line line_of(const Scene2& scene, const Element& element) {
  const Edge2& edge = scene.edges[element.surface];
  const EdgeSpan2 span = EdgeSpan2::of(element);
  return {point_at(edge, span.from), point_at(edge, span.to), element.is_back};
}

double distance(const Point2& a, const Point2& b) { return std::hypot(to_double(b.x - a.x), to_double(b.y - a.y)); }

bool touch(const Line& a, const Line& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

double angle(const Line& a, const Line& b) {
  const auto m = a.normal(), n = b.normal();
  return same_bits::atan2(std::abs(m[0] * n[1] - m[1] * n[0]), m[0] * n[0] + m[1] * n[1]) * 180 / std::numbers::pi;
}

}  // namespace

PairExplainer2::PairExplainer2(const PreparedScene2& prepared, const ExchangeMatrix& exact)
    : prepared_(prepared), exact_(exact), table_(*prepared.elements(Granularity::kElement)) {}

std::optional<double> PairExplainer2::visibility(std::uint32_t from, std::uint32_t to) const {
  for (const FactorEntry& entry : exact_.row(from))
    if (entry.to == to) return entry.visibility;
  if (to == exact_.sky()) return 0;
  for (const Segment2& f : table_.runs(from))
    for (const Segment2& g : table_.runs(to))
      if (face_each_other(prepared_.arrangement.vertices(), f, g)) return 0;
  return std::nullopt;
}

PairExplanation PairExplainer2::explain(const PairError& pair) const {
  PairExplanation result;
  result.visibility = visibility(pair.from, pair.to);
  result.reason = sight_in_words(result.visibility);
  if (pair.to == exact_.sky()) {
    result.reason += " toward the sky";
  } else {
    const Line a = line_of(prepared_.scene, exact_.elements()[pair.from]),
               b = line_of(prepared_.scene, exact_.elements()[pair.to]);
    result.distance = distance(a.middle(), b.middle());
    result.angle = angle(a, b);
    result.reason += touch(a, b)                                           ? ", touching"
                     : *result.distance < std::max(a.length(), b.length()) ? ", near"
                                                                           : ", far";
  }
  result.reason += mistake_in_words(pair);
  return result;
}

}  // namespace hottel
