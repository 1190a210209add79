#include "geometry/space/arrangement/coplanar_clusters.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/space/scene/plane_triangulation.h"
#include "kernel/doubles.h"
#include "kernel/support/disjoint_sets.h"

namespace hottel {
namespace {

using Member = CoplanarCluster3::Member;

// A box of a polygon in its plane, rounded. Rounding keeps the order of numbers: where polygons meet, their boxes do.
struct FlatBox {
  std::array<double, 2> low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};

  explicit FlatBox(const std::vector<FlatPoint3>& points) {
    for (const FlatPoint3& p : points)
      for (const std::size_t a : {0u, 1u}) {
        const double value = to_double(a == 0 ? p.u : p.v);
        low[a] = std::min(low[a], value);
        high[a] = std::max(high[a], value);
      }
  }
  bool meets(const FlatBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1];
  }
};

bool share_an_area(const Member& a, const Member& b) {
  return a.is_convex && b.is_convex ? enters(a.parts.front(), b.parts.front()) : a.region.may_meet(b.region);
}

// Joins those polygons of one plane that overlap; `members` are theirs.
void join_overlapping(const std::vector<Member>& members, DisjointSets& sets) {
  std::vector<FlatBox> boxes;
  for (const Member& member : members) boxes.emplace_back(member.region.loops().front());
  std::vector<std::uint32_t> order(members.size()), open;
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low[0] < boxes[b].low[0]; });
  for (const std::uint32_t k : order) {
    std::erase_if(open, [&](std::uint32_t other) { return boxes[other].high[0] < boxes[k].low[0]; });
    for (const std::uint32_t other : open)
      if (boxes[k].meets(boxes[other]) && sets.root(members[k].surface) != sets.root(members[other].surface) &&
          share_an_area(members[k], members[other]))
        sets.join_to_smaller(members[k].surface, members[other].surface);
    open.push_back(k);
  }
}

Member member_of(std::uint32_t surface, const Polygon3& polygon, const PlaneFrame3& frame) {
  Member member{
      surface, frame.region(polygon.points, polygon.holes), {}, frame.is_front_up(polygon.points), is_convex(polygon)};
  if (member.is_convex)
    member.parts.push_back(frame.outline(polygon.points));
  else
    member.parts = convex_pieces(member.region);
  return member;
}

}  // namespace

const Member& CoplanarCluster3::member(std::uint32_t surface) const {
  return *std::lower_bound(members.begin(), members.end(), surface,
                           [](const Member& m, std::uint32_t s) { return m.surface < s; });
}

std::vector<CoplanarCluster3> coplanar_clusters(const std::vector<Polygon3>& polygons) {
  std::vector<PlaneFrame3> frames;
  frames.reserve(polygons.size());
  for (const Polygon3& polygon : polygons) frames.emplace_back(polygon.points);
  std::vector<std::uint32_t> order(polygons.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return frames[a].precedes(frames[b]); });
  std::vector<Member> members(polygons.size());
  DisjointSets sets(polygons.size());
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end =
        std::find_if(begin, order.end(), [&](std::uint32_t k) { return frames[*begin].precedes(frames[k]); });
    std::vector<Member> here;
    for (auto k = begin; k != end; ++k) here.push_back(member_of(*k, polygons[*k], frames[*k]));
    join_overlapping(here, sets);
    for (Member& member : here) members[member.surface] = std::move(member);
    begin = end;
  }
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<CoplanarCluster3> clusters;
  std::vector<std::uint32_t> cluster_of(polygons.size(), kNone);
  for (std::uint32_t s = 0; s < polygons.size(); ++s) {
    std::uint32_t& cluster = cluster_of[sets.root(s)];
    if (cluster == kNone) {
      cluster = static_cast<std::uint32_t>(clusters.size());
      clusters.push_back({frames[s], {}});
    }
    clusters[cluster].members.push_back(std::move(members[s]));
  }
  return clusters;
}

}  // namespace hottel
