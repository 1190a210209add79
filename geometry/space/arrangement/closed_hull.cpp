#include "geometry/space/arrangement/closed_hull.h"

#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/space/arrangement/outline_sum.h"

namespace hottel {
namespace {

// Where the vertices of a scene lie of planes, each asked once.
class SidesOfPlanes {
 public:
  struct Sides {
    bool has_front = false, has_behind = false;
  };
  explicit SidesOfPlanes(const Occluders3& occluders) : occluders_(occluders) {}

  // Of the plane of a polygon, as seen from it.
  Sides operator()(std::size_t s) {
    const IntegerVector& normal = occluders_.exact_normal(s);
    const bool is_turned = std::tie(normal.x, normal.y, normal.z) < std::make_tuple(0, 0, 0);
    const IntegerVector turned = is_turned ? opposite(normal) : normal;
    const Integer height = dot(turned, occluders_.vertices().exact(occluders_.outline(s).front()));
    const auto [place, is_new] = known_.try_emplace({turned.x, turned.y, turned.z, height});
    if (is_new) {
      place->second = find(s);
      if (is_turned) std::swap(place->second.has_front, place->second.has_behind);
    }
    Sides result = place->second;
    if (is_turned) std::swap(result.has_front, result.has_behind);
    return result;
  }

 private:
  Sides find(std::size_t s) const {
    Sides result;
    SignTier tier;
    const std::size_t count = occluders_.vertices().size();
    for (std::size_t v = 0; v < count && !(result.has_front && result.has_behind); ++v) {
      const int side = occluders_.side_of(VertexId3(v), s, tier);
      result.has_front |= side > 0;
      result.has_behind |= side < 0;
    }
    return result;
  }

  const Occluders3& occluders_;
  std::map<std::array<Integer, 4>, Sides> known_;
};

}  // namespace

// Polygons with no vertex on one side lie on the boundary of the convex hull. Each taken in the sense in which it is
// seen from inside, they cover every part of it equally often if their outlines cancel, for what is covered more often
// than what is next to it has a border there: and so at least once. A polygon with vertices on both sides is within.
ClosedHull3::ClosedHull3(const Occluders3& occluders) {
  SidesOfPlanes sides(occluders);
  const Vertices3& vertices = occluders.vertices();
  OutlineSum3 outlines;
  bool has_wall = false;
  for (std::size_t s = 0; s < occluders.size(); ++s) {
    const auto [has_front, has_behind] = sides(s);
    fronts_.push_back(has_front);
    backs_.push_back(has_behind);
    if (!has_front && !has_behind) return;  // the scene is in one plane
    if (has_front && has_behind) continue;
    const auto corners = occluders.outline(s);
    for (std::size_t k = 0; k < corners.size(); ++k)
      outlines.add(vertices.exact(corners[k]), vertices.exact(corners[(k + 1) % corners.size()]), has_front ? 1 : -1);
    has_wall = true;
  }
  is_closed_ = has_wall && outlines.is_zero();
}

}  // namespace hottel
