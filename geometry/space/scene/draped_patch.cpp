#include "geometry/space/scene/draped_patch.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/planarity.h"
#include "geometry/space/scene/bent_loops.h"
#include "geometry/space/scene/flat_region.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {
namespace {

constexpr std::array<Rational Vector3::*, 3> kWays{&Vector3::x, &Vector3::y, &Vector3::z};
constexpr std::array<Rational Point3::*, 3> kPlaces{&Point3::x, &Point3::y, &Point3::z};

// What is seen along an axis; a polygon of that area goes around counter-clockwise.
class AxisView {
 public:
  explicit AxisView(const Vector3& area) {
    for (std::size_t a = 1; a < 3; ++a)
      if (abs(area.*kWays[a]) > abs(area.*kWays[dropped_])) dropped_ = a;
    first_ = (dropped_ + 1) % 3;
    second_ = (dropped_ + 2) % 3;
    if (area.*kWays[dropped_] < 0) std::swap(first_, second_);
  }

  FlatPoint3 flat(const Point3& p) const { return {p.*kPlaces[first_], p.*kPlaces[second_]}; }
  const Rational& along(const Vector3& v) const { return v.*kWays[dropped_]; }
  // The point of a plane that is seen there. REQUIRES along(normal) != 0.
  Point3 lifted(const FlatPoint3& p, const Vector3& normal, const Point3& at) const {
    Point3 result;
    result.*kPlaces[first_] = p.u;
    result.*kPlaces[second_] = p.v;
    result.*kPlaces[dropped_] = at.*kPlaces[dropped_] - (normal.*kWays[first_] * (p.u - at.*kPlaces[first_]) +
                                                         normal.*kWays[second_] * (p.v - at.*kPlaces[second_])) /
                                                            normal.*kWays[dropped_];
    return result;
  }

 private:
  std::size_t dropped_ = 0, first_ = 1, second_ = 2;
};

class Drape {
 public:
  Drape(const Polygon3& polygon, const std::vector<const Polygon3*>& facets, const Rational& unit)
      : polygon_(polygon),
        unit_(unit),
        area_(doubled_area(polygon)),
        view_(area_),
        squared_own_(squared_diameter(corners_of(polygon))) {
    const FlatRegion3 own = region_seen(polygon);
    for (const Polygon3* facet : facets) {
      Vector3 normal = doubled_area(*facet);
      if (view_.along(normal) == 0) continue;
      FlatRegion3 region = region_seen(*facet);
      if (!region.may_meet(own)) continue;
      squared_base_ = std::max(squared_base_, squared_diameter(facet->points));
      supports_.push_back({facet, std::move(normal), std::move(region)});
    }
  }

  std::optional<Polygon3> draped() const {
    Polygon3 result{polygon_.points, polygon_.holes, true};
    for (auto* loop : loops_of_it(result))
      for (Point3& corner : *loop) {
        std::optional<Point3> there = place_of(corner);
        if (!there || !is_near(square(*there - corner))) return std::nullopt;
        corner = *std::move(there);
      }
    return add_facets(result) ? std::optional(std::move(result)) : std::nullopt;
  }

 private:
  struct Support {
    const Polygon3* facet;
    Vector3 normal;
    FlatRegion3 region;
  };

  static std::vector<std::vector<Point3>*> loops_of_it(Polygon3& polygon) {
    std::vector<std::vector<Point3>*> loops{&polygon.points};
    for (auto& hole : polygon.holes) loops.push_back(&hole);
    return loops;
  }

  bool is_near(const Rational& squared_distance) const {
    return is_within_seat(squared_distance, squared_own_, squared_base_, unit_);
  }

  FlatRegion3 region_seen(const Polygon3& polygon) const {
    std::vector<std::vector<FlatPoint3>> loops;
    for (const std::vector<Point3>& loop : loops_of(polygon)) {
      loops.emplace_back();
      for (const Point3& p : loop) loops.back().push_back(view_.flat(p));
    }
    return FlatRegion3(std::move(loops));
  }

  Point3 lifted(const FlatPoint3& p, const Support& support) const {
    return view_.lifted(p, support.normal, support.facet->points.front());
  }

  // Where a corner goes; nothing where there are no supports.
  std::optional<Point3> place_of(const Point3& corner) const {
    const FlatPoint3 at = view_.flat(corner);
    for (const Support& support : supports_)
      if (support.region.is_on_border(at) || support.region.contains(at)) return lifted(at, support);
    std::optional<ClosestPoint3> best;
    for (const Support& support : supports_)
      for (const Side3& side : sides_of(*support.facet))
        if (ClosestPoint3 here = closest_point(side, corner); !best || here.squared < best->squared)
          best = std::move(here);
    return best ? std::optional(best->at) : std::nullopt;
  }

  // The triangles between the sides of all, each lifted onto what it is a part of. False where one is a part of none,
  // or off the plane of all.
  bool add_facets(Polygon3& result) const {
    const std::vector<Point3> corners = corners_of(result);
    Vector3 sum{0, 0, 0};
    for (const Point3& p : corners) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
    const Rational count = static_cast<long>(corners.size());
    const Point3 middle{sum.x / count, sum.y / count, sum.z / count};
    const FlatRegion3 own = region_seen(result);
    std::vector<FlatSegment3> segments;
    own.append_sides(segments);
    for (const Support& support : supports_) support.region.append_sides(segments);
    const PlaneTriangulation3 triangulation(segments);
    for (std::uint32_t t = 0; t < triangulation.triangles().size(); ++t) {
      const FlatPoint3 at = triangulation.centre(t);
      if (!own.contains(at)) continue;
      const auto under =
          std::ranges::find_if(supports_, [&](const Support& support) { return support.region.contains(at); });
      if (under == supports_.end()) return false;
      std::array<Point3, 3> facet;
      for (std::size_t k = 0; k < 3; ++k) {
        facet[k] = lifted(triangulation.points()[triangulation.triangles()[t].corners[k]], *under);
        const Rational height = dot(area_, facet[k] - middle);
        if (!is_near(height * height / square(area_))) return false;
      }
      result.facets.push_back(std::move(facet));
    }
    return !result.facets.empty();
  }

  const Polygon3& polygon_;
  const Rational& unit_;
  const Vector3 area_;
  const AxisView view_;
  const Rational squared_own_;
  Rational squared_base_;
  std::vector<Support> supports_;
};

}  // namespace

std::optional<Polygon3> draped(const Polygon3& polygon, const std::vector<const Polygon3*>& facets,
                               const Rational& unit) {
  return Drape(polygon, facets, unit).draped();
}

}  // namespace hottel
