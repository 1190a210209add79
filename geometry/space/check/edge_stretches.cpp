#include "geometry/space/check/edge_stretches.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/space/predicates/vertices.h"

namespace hottel {
namespace {

// A line: its direction in coprime integers, the first that is not 0 positive, and its moment.
using LineKey = std::array<Integer, 6>;

bool is_before(const LineKey& a, const LineKey& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const int order = cmp(a[k], b[k])) return order < 0;
  return false;
}

// A side along its line, from the smaller to the larger place there.
struct PlacedSide {
  LineKey line;
  Integer from, to;
  Side3 side;
  EdgeUse3 use;
  std::uint32_t number = 0;  // in the order of the scene
};

PlacedSide placed(const Vertices3& vertices, std::uint32_t first, std::uint32_t second) {
  const IntegerVector &a = vertices.exact(VertexId3(first)), &b = vertices.exact(VertexId3(second));
  IntegerVector along = primitive(difference(b, a));
  const Integer& leading = along.x != 0 ? along.x : along.y != 0 ? along.y : along.z;
  if (leading < 0) along = opposite(along);
  const IntegerVector moment = cross(a, along);
  PlacedSide side;
  side.line = {along.x, along.y, along.z, moment.x, moment.y, moment.z};
  side.from = dot(along, a);
  side.to = dot(along, b);
  return side;
}

// The stretches of the sides of one line.
class LineCutter {
 public:
  explicit LineCutter(std::vector<const PlacedSide*> sides) : sides_(std::move(sides)) {
    for (const PlacedSide* side : sides_) {
      ends_.push_back({side->from, &side->side.from});
      ends_.push_back({side->to, &side->side.to});
    }
    const auto before = [](const End& a, const End& b) { return a.place < b.place; };
    std::sort(ends_.begin(), ends_.end(), before);
    ends_.erase(std::unique(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.place == b.place; }),
                ends_.end());
  }

  // Calls visit(number of the first side, stretch).
  template <class Visit>
  void cut(const Visit& visit) const {
    std::vector<std::vector<const PlacedSide*>> on(ends_.size());
    for (const PlacedSide* side : sides_)
      for (std::size_t k = place_of(side->from); ends_[k].place < side->to; ++k) on[k].push_back(side);
    for (std::size_t k = 0; k + 1 < ends_.size(); ++k) {
      if (on[k].empty()) continue;
      std::sort(on[k].begin(), on[k].end(),
                [](const PlacedSide* a, const PlacedSide* b) { return a->number < b->number; });
      EdgeStretch3 stretch{*ends_[k].point, *ends_[k + 1].point, {}};
      for (const PlacedSide* side : on[k]) stretch.uses.push_back(side->use);
      visit(on[k].front()->number, std::move(stretch));
    }
  }

 private:
  struct End {
    Integer place;
    const Point3* point;
  };
  std::size_t place_of(const Integer& place) const {
    const auto at = std::lower_bound(ends_.begin(), ends_.end(), place,
                                     [](const End& end, const Integer& value) { return end.place < value; });
    return static_cast<std::size_t>(at - ends_.begin());
  }

  std::vector<const PlacedSide*> sides_;
  std::vector<End> ends_;
};

std::vector<PlacedSide> placed_sides(const std::vector<Polygon3>& polygons) {
  std::vector<Point3> points;
  for (const Polygon3& polygon : polygons)
    for (const Side3& side : sides_of(polygon)) {
      points.push_back(side.from);
      points.push_back(side.to);
    }
  const Vertices3 vertices(points);
  std::vector<PlacedSide> sides;
  for (std::uint32_t s = 0; s < polygons.size(); ++s)
    for (Side3& side : sides_of(polygons[s])) {
      const auto number = static_cast<std::uint32_t>(sides.size());
      sides.push_back(placed(vertices, 2 * number, 2 * number + 1));
      PlacedSide& last = sides.back();
      last.number = number;
      last.side = std::move(side);
      last.use = {s, last.to < last.from};
      if (!last.use.is_reversed) continue;
      std::swap(last.from, last.to);
      std::swap(last.side.from, last.side.to);
    }
  return sides;
}

}  // namespace

std::vector<EdgeStretch3> find_edge_stretches(const std::vector<Polygon3>& polygons) {
  const std::vector<PlacedSide> sides = placed_sides(polygons);
  std::vector<std::uint32_t> order(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return is_before(sides[a].line, sides[b].line); });
  std::vector<std::pair<std::uint32_t, EdgeStretch3>> found;
  for (std::size_t begin = 0; begin < order.size();) {
    std::vector<const PlacedSide*> of_line;
    std::size_t end = begin;
    for (; end < order.size() && sides[order[end]].line == sides[order[begin]].line; ++end)
      of_line.push_back(&sides[order[end]]);
    LineCutter(std::move(of_line)).cut([&](std::uint32_t number, EdgeStretch3 stretch) {
      found.emplace_back(number, std::move(stretch));
    });
    begin = end;
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<EdgeStretch3> stretches;
  for (auto& [number, stretch] : found) {
    if (stretch.uses.front().is_reversed) {
      std::swap(stretch.from, stretch.to);
      for (EdgeUse3& use : stretch.uses) use.is_reversed = !use.is_reversed;
    }
    stretches.push_back(std::move(stretch));
  }
  return stretches;
}

std::vector<EdgeStretch3> find_edge_stretches(const Scene3& scene) {
  std::vector<EdgeStretch3> stretches = find_edge_stretches(scene.polygons);
  for (EdgeStretch3& stretch : stretches)
    std::erase_if(stretch.uses, [&](const EdgeUse3& use) { return scene.surfaces[use.surface].on.has_value(); });
  std::erase_if(stretches, [](const EdgeStretch3& stretch) { return stretch.uses.empty(); });
  return stretches;
}

bool is_covered(const Side3& segment, const std::vector<Polygon3>& polygons, const std::vector<std::uint32_t>& list) {
  const Vector3 along = segment.to - segment.from;
  const Rational whole = dot(along, along);
  std::vector<std::pair<std::uint32_t, Vector3>> in_plane;  // polygons and their normals
  std::vector<Rational> cuts{0, 1};
  for (const std::uint32_t s : list) {
    const Polygon3& polygon = polygons[s];
    Vector3 normal = doubled_area(polygon);
    const Point3& origin = polygon.points[0];
    if (dot(normal, segment.from - origin) != 0 || dot(normal, segment.to - origin) != 0) continue;
    for (const Side3& side : sides_of(polygon)) {
      // Where the line of the side meets that of the segment, in their plane.
      const Vector3 across = cross(normal, side.to - side.from);
      const Rational slope = dot(across, along);
      if (slope != 0) cuts.push_back(dot(across, side.from - segment.from) / slope);
      for (const Point3* end : {&side.from, &side.to})
        if (slope == 0) cuts.push_back(dot(along, *end - segment.from) / whole);
    }
    in_plane.emplace_back(s, std::move(normal));
  }
  std::erase_if(cuts, [](const Rational& t) { return t < 0 || t > 1; });
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Point3 at = moved(segment.from, (cuts[k] + cuts[k + 1]) / 2, along);
    if (std::none_of(in_plane.begin(), in_plane.end(),
                     [&](const auto& one) { return contains_in_plane(polygons[one.first], one.second, at); }))
      return false;
  }
  return true;
}

}  // namespace hottel
