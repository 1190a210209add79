#include "geometry/space/scene/joined_outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct BeforeInPlane {
  bool operator()(const FlatPoint3& a, const FlatPoint3& b) const { return std::tie(a.u, a.v) < std::tie(b.u, b.v); }
};

// A u + B v = C, the first of A, B that is not 0 being 1.
using Line = std::array<Rational, 3>;

Line line_through(const FlatPoint3& a, const FlatPoint3& b) {
  Rational first = a.v - b.v, second = b.u - a.u;
  const Rational unit = first != 0 ? first : second;
  first /= unit;
  second /= unit;
  return {first, second, first * a.u + second * a.v};
}

// How often a line is passed between two points that follow each other, forth less back.
using Passes = std::map<FlatPoint3, int, BeforeInPlane>;  // what changes at a point

// The sides of a region, its inside on their left: what is left of the sides of polygons where they meet.
std::vector<FlatSegment3> outer_sides(const std::vector<std::vector<FlatPoint3>>& polygons) {
  std::map<Line, Passes> lines;
  for (const auto& polygon : polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const FlatPoint3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      Passes& passes = lines[line_through(a, b)];
      const int forth = BeforeInPlane()(a, b) ? 1 : -1;
      passes[forth > 0 ? a : b] += forth;
      passes[forth > 0 ? b : a] -= forth;
    }
  std::vector<FlatSegment3> sides;
  for (const auto& [line, passes] : lines) {
    int now = 0;
    const FlatPoint3* begin = nullptr;
    for (const auto& [point, change] : passes) {
      if (change == 0) continue;
      if (now > 0) sides.push_back({*begin, point});
      if (now < 0) sides.push_back({point, *begin});
      now += change;
      begin = &point;
    }
    HOTTEL_REQUIRE(now == 0);
  }
  return sides;
}

// Which way a walk turns at a point: more to the left is more.
bool turns_further_left(const FlatSegment3& along, const FlatPoint3& a, const FlatPoint3& b) {
  const auto side = [&](const FlatPoint3& to) {
    const Rational turn = doubled_area(along[0], along[1], to);
    return turn > 0 ? 2 : turn < 0 ? 0 : 1;
  };
  if (side(a) != side(b)) return side(a) > side(b);
  return doubled_area(along[1], b, a) > 0;
}

// Joins sides to loops, at each point as far to the left as it goes.
class Walk {
 public:
  explicit Walk(std::vector<FlatSegment3> sides) : sides_(std::move(sides)), is_used_(sides_.size(), false) {
    for (std::size_t k = 0; k < sides_.size(); ++k) from_[sides_[k][0]].push_back(k);
  }

  std::vector<std::vector<FlatPoint3>> loops() {
    std::vector<std::vector<FlatPoint3>> result;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      if (is_used_[k]) continue;
      std::vector<FlatPoint3>& loop = result.emplace_back();
      for (std::optional<std::size_t> at = k; at; at = next(*at)) {
        is_used_[*at] = true;
        loop.push_back(sides_[*at][0]);
      }
    }
    return result;
  }

 private:
  std::optional<std::size_t> next(std::size_t side) const {
    std::optional<std::size_t> best;
    for (const std::size_t k : from_.at(sides_[side][1]))
      if (!best || turns_further_left(sides_[side], sides_[k][1], sides_[*best][1])) best = k;
    return is_used_[*best] ? std::nullopt : best;
  }

  std::vector<FlatSegment3> sides_;
  std::vector<bool> is_used_;
  std::map<FlatPoint3, std::vector<std::size_t>, BeforeInPlane> from_;
};

// Whether a loop lies within another one, which it may touch in points. REQUIRES that they do not cross.
bool lies_in(const std::vector<FlatPoint3>& loop, const FlatRegion3& region) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const FlatPoint3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
    const FlatPoint3 middle{(a.u + b.u) / 2, (a.v + b.v) / 2};
    for (const FlatPoint3& point : {a, middle})
      if (!region.is_on_border(point)) return region.contains(point);
  }
  return false;
}

}  // namespace

std::vector<FlatPart3> joined_outline(const std::vector<std::vector<FlatPoint3>>& polygons) {
  std::vector<FlatPart3> parts;
  std::vector<std::vector<FlatPoint3>> holes;
  for (std::vector<FlatPoint3>& loop : Walk(outer_sides(polygons)).loops()) {
    if (doubled_area(loop) > 0)
      parts.push_back({std::move(loop), {}});
    else
      holes.push_back(std::move(loop));
  }
  for (std::vector<FlatPoint3>& hole : holes) {
    FlatPart3* around = nullptr;
    for (FlatPart3& part : parts)
      if (lies_in(hole, FlatRegion3({part.outline})) &&
          (around == nullptr || doubled_area(part.outline) < doubled_area(around->outline)))
        around = &part;
    HOTTEL_REQUIRE(around != nullptr);
    around->holes.push_back(std::move(hole));
  }
  return parts;
}

}  // namespace hottel
