#include "geometry/space/scene/patch_seats.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/bent_loops.h"
#include "geometry/space/scene/draped_patch.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "geometry/space/scene/polygon_places.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A plane polygon that patches may lie on: a surface, or a facet of one.
struct Facet {
  PlaneFrame3 frame;
  FlatRegion3 region;
  Polygon3 polygon;
  Vector3 normal;  // of its front
  PatchCarriers3::Box box;

  explicit Facet(Polygon3 p)
      : frame(p.points),
        region(frame.region(p.points, p.holes)),
        polygon(std::move(p)),
        normal(doubled_area(polygon)),
        box(polygon.points) {}

  Rational squared_distance(const Point3& point) const {
    const Rational height = dot(normal, point - polygon.points.front());
    return height * height / square(normal);
  }
  Point3 projected(const Point3& point) const {
    return moved(point, -dot(normal, point - polygon.points.front()) / square(normal), normal);
  }
  bool holds(const Point3& point) const {
    const FlatPoint3 at = frame.flat(point);
    return region.is_on_border(at) || region.contains(at);
  }
};

// A facet that a patch may lie on, and how far off its plane the farthest corner of the patch is.
struct Support {
  const Facet* facet;
  Rational squared_off;
  bool looks_alike;
};

// Where supports are looked for: near the patch, as where it lies on one, or anywhere.
enum class Near : bool { kNo, kYes };

// What patches lie on. Facets are those of the scene as it is when they are first asked for; what is no polygon has
// none.
class Bases {
 public:
  explicit Bases(const Scene3& scene) : scene_(scene), patches_(scene) {}

  const PatchBases& patches() const { return patches_; }

  // The facets in front of which or behind which a patch may lie, the nearest plane first; those that look as it does
  // before those that do not.
  std::vector<Support> supports(std::uint32_t patch, Near near) {
    std::vector<Support> found;
    const std::vector<Point3> corners = corners_of(scene_.polygons[patch]);
    const Vector3 front = front_of(patch);
    for (const Facet* facet : facets_under(patch, near)) {
      std::vector<std::vector<FlatPoint3>> outline(1);
      for (const Point3& p : scene_.polygons[patch].points)
        outline[0].push_back(facet->frame.flat(facet->projected(p)));
      if (!facet->region.may_meet(FlatRegion3(std::move(outline)))) continue;
      Rational off;
      for (const Point3& p : corners) off = std::max(off, facet->squared_distance(p));
      const bool looks_alike = dot(facet->normal, front) > 0;
      found.push_back({facet, std::move(off), looks_alike});
    }
    std::ranges::stable_sort(found, [](const Support& a, const Support& b) {
      if (a.looks_alike != b.looks_alike) return a.looks_alike;
      return a.squared_off < b.squared_off;
    });
    return found;
  }

  // The facets near a patch that look as it has to.
  std::vector<const Facet*> looking_alike(std::uint32_t patch) {
    std::vector<const Facet*> found = facets_under(patch, Near::kYes);
    const Vector3 front = front_of(patch);
    std::erase_if(found, [&](const Facet* facet) { return dot(facet->normal, front) <= 0; });
    return found;
  }

  // Those of them in one plane.
  std::vector<const Facet*> looking_alike(std::uint32_t patch, const PlaneFrame3& plane) {
    std::vector<const Facet*> found = looking_alike(patch);
    std::erase_if(found, [&](const Facet* facet) { return facet->frame.key() != plane.key(); });
    return found;
  }

 private:
  // Where the side looks that a patch has to lie on: its front, or where it lies on backs the other way.
  Vector3 front_of(std::uint32_t patch) const {
    const Vector3 front = doubled_area(scene_.polygons[patch]);
    return patches_.is_on_backs(patch) ? Vector3{-front.x, -front.y, -front.z} : front;
  }

  std::vector<const Facet*> facets_under(std::uint32_t patch, Near near) {
    const PatchCarriers3::Box own(scene_.polygons[patch].points);
    std::vector<const Facet*> found;
    for (const std::uint32_t s : patches_.under(patch)) {
      auto [entry, is_new] = facets_.try_emplace(s);
      if (is_new && polygon_problem(scene_.polygons[s]).text.empty())
        for (Polygon3& polygon : facets_of(scene_.polygons[s])) entry->second.emplace_back(std::move(polygon));
      for (const Facet& facet : entry->second)
        if (near == Near::kNo || own.meets(facet.box)) found.push_back(&facet);
    }
    return found;
  }

  const Scene3& scene_;
  const PatchBases patches_;
  std::map<std::uint32_t, std::vector<Facet>> facets_;  // by surface
};

// A place of a polygon in the plane of some facets that is in none of them; nothing where all of it is.
std::optional<Point3> place_beyond(const Polygon3& polygon, std::vector<const Facet*> facets) {
  const PlaneFrame3 frame(polygon.points);
  const FlatRegion3 own = frame.region(polygon.points, polygon.holes);
  std::vector<FlatSegment3> segments;
  own.append_sides(segments);
  std::erase_if(facets, [&](const Facet* facet) { return !facet->region.may_meet(own); });
  for (const Facet* facet : facets) facet->region.append_sides(segments);
  const PlaneTriangulation3 triangulation(segments);
  for (std::uint32_t t = 0; t < triangulation.triangles().size(); ++t) {
    const FlatPoint3 at = triangulation.centre(t);
    if (own.contains(at) &&
        std::ranges::none_of(facets, [&](const Facet* facet) { return facet->region.contains(at); }))
      return frame.point(at);
  }
  return std::nullopt;
}

bool has_an_area(const Polygon3& polygon) {
  return polygon.points.size() >= 3 && !doubled_area(Polygon3{polygon.points}).is_zero();
}

class Seater {
 public:
  Seater(Scene3& scene, const Rational& unit) : scene_(scene), unit_(unit), bases_(scene) {}

  void seat() {
    const auto order = bases_.patches().outermost_first();
    if (!order) return;
    for (const std::uint32_t patch : *order)
      if (has_an_area(scene_.polygons[patch])) seat(patch);
  }

 private:
  void seat(std::uint32_t patch) {
    Polygon3& polygon = scene_.polygons[patch];
    std::optional<Polygon3> in_plane = seated_in_plane(patch);
    if (!in_plane || is_beyond(patch, *in_plane))
      if (std::optional<Polygon3> across_bends = seated_across_bends(patch)) in_plane = std::move(across_bends);
    if (in_plane) polygon = *std::move(in_plane);
  }

  // In the first plane that is near enough, those first that look as it does.
  std::optional<Polygon3> seated_in_plane(std::uint32_t patch) {
    Polygon3 polygon = scene_.polygons[patch];
    const Rational own = squared_diameter(corners_of(polygon));
    for (const Support& support : bases_.supports(patch, Near::kYes)) {
      const Rational base = squared_diameter(support.facet->polygon.points);
      if (!is_within_seat(support.squared_off, own, base, unit_)) continue;
      for_each_corner(polygon, [&](Point3& corner) {
        if (support.squared_off != 0) corner = support.facet->projected(corner);
      });
      polygon.is_nearly_plane = false;
      if (!support.looks_alike) return polygon;
      const std::vector<const Facet*> facets = bases_.looking_alike(patch, support.facet->frame);
      for_each_corner(polygon, [&](Point3& corner) {
        const Point3 on_base = nearest(facets, corner);
        if (is_within_seat(square(on_base - corner), own, base, unit_)) corner = on_base;
      });
      return polygon;
    }
    return std::nullopt;
  }

  // Whether something of what is seated in a plane is beside the facets of that. There are several planes only where
  // a base is bent or a group.
  bool is_beyond(std::uint32_t patch, const Polygon3& polygon) {
    const std::vector<const Facet*> facets = bases_.looking_alike(patch, PlaneFrame3(polygon.points));
    return facets.size() < bases_.looking_alike(patch).size() && polygon_problem(polygon).text.empty() &&
           place_beyond(polygon, facets).has_value();
  }

  std::optional<Polygon3> seated_across_bends(std::uint32_t patch) {
    std::vector<const Polygon3*> facets;
    for (const Facet* facet : bases_.looking_alike(patch)) facets.push_back(&facet->polygon);
    if (facets.size() < 2) return std::nullopt;
    std::optional<Polygon3> result = draped(scene_.polygons[patch], facets, unit_);
    if (result && !polygon_problem(*result).text.empty()) result.reset();
    return result;
  }

  template <class Change>
  static void for_each_corner(Polygon3& polygon, const Change& change) {
    std::ranges::for_each(polygon.points, change);
    for (auto& hole : polygon.holes) std::ranges::for_each(hole, change);
  }

  // The point of some facets of its plane that is nearest to a point.
  static Point3 nearest(const std::vector<const Facet*>& facets, const Point3& point) {
    if (std::ranges::any_of(facets, [&](const Facet* facet) { return facet->holds(point); })) return point;
    std::optional<ClosestPoint3> best;
    for (const Facet* facet : facets)
      for (const Side3& side : sides_of(facet->polygon))
        if (ClosestPoint3 here = closest_point(side, point); !best || here.squared < best->squared)
          best = std::move(here);
    return best ? best->at : point;
  }

  Scene3& scene_;
  const Rational& unit_;
  Bases bases_;
};

// Says what is wrong with where patches lie.
class Judge {
 public:
  explicit Judge(const Scene3& scene) : scene_(scene), bases_(scene) {}

  void judge() {
    for (std::uint32_t s = 0; s < scene_.polygons.size(); ++s)
      if (bases_.patches().is_patch(s)) judge(s);
  }

 private:
  [[noreturn]] void refuse(std::uint32_t patch, const std::string& what, const std::string& remedy) const {
    refuse_patch(scene_, patch, what, remedy);
  }
  std::string base(std::uint32_t patch) const { return base_text(scene_.bases[*scene_.surfaces[patch].on]); }

  void judge(std::uint32_t patch) {
    if (!scene_.polygons[patch].facets.empty()) return judge_facets(patch);
    const std::vector<Support> supports = bases_.supports(patch, Near::kYes);
    const auto in_plane = std::ranges::find_if(supports, [](const Support& s) { return s.squared_off == 0; });
    if (in_plane == supports.end() || scene_.polygons[patch].is_nearly_plane)
      refuse_off(patch, bases_.supports(patch, Near::kNo));
    if (!in_plane->looks_alike) refuse_turned_patch(scene_, patch);
    judge_extent(patch, scene_.polygons[patch], bases_.looking_alike(patch, in_plane->facet->frame));
  }

  // Each facet of a patch across bends lies in the plane of one of its base, and within it.
  void judge_facets(std::uint32_t patch) {
    for (const Polygon3& part : facets_of(scene_.polygons[patch])) {
      std::vector<const Facet*> facets = bases_.looking_alike(patch, PlaneFrame3(part.points));
      if (facets.empty()) refuse_off(patch, bases_.supports(patch, Near::kNo));
      judge_extent(patch, part, std::move(facets));
    }
  }

  // Every part of the patch, cut by the sides of what it lies on, is in some of that.
  void judge_extent(std::uint32_t patch, const Polygon3& part, std::vector<const Facet*> facets) const {
    if (const std::optional<Point3> at = place_beyond(part, std::move(facets))) refuse_beyond(patch, *at);
  }

  void refuse_beyond(std::uint32_t patch, const Point3& at) const {
    const auto& under = bases_.patches().under(patch);
    const bool is_bent =
        std::ranges::any_of(under, [&](std::uint32_t s) { return scene_.polygons[s].is_nearly_plane; });
    refuse(patch,
           "leaves " + base(patch) + ", on which it lies: around " + place_text(at) + " there is nothing of that" +
               (is_bent ? " in its plane" : ""),
           is_bent ? "that is bent a little: make it smaller, or give the points of both more digits"
                   : "make it smaller, or make a surface without \"on\" of what is beyond");
  }

  void refuse_off(std::uint32_t patch, const std::vector<Support>& supports) const {
    const std::vector<Point3> corners = corners_of(scene_.polygons[patch]);
    if (supports.empty())
      refuse(patch, "does not lie on " + base(patch) + ": it is beside it, at " + place_text(corners.front()),
             "put it into one of the planes of that, within its border");
    const Facet& facet = *std::ranges::min_element(supports, {}, &Support::squared_off)->facet;
    const auto off = [&](const Point3& p) { return facet.squared_distance(p); };
    const Point3& farthest = *std::ranges::max_element(corners, {}, off);
    refuse(patch,
           "does not lie on " + base(patch) + ": its corner " + place_text(farthest) + " is " +
               length_text(off(farthest)) + " off its plane",
           "put its corners into the plane of that, or give them as many digits as that has");
  }

  const Scene3& scene_;
  Bases bases_;
};

}  // namespace

void seat_patches(Scene3& scene, const Rational& unit) {
  if (!PatchBases(scene).is_empty()) Seater(scene, unit).seat();
}

void validate_patches(const Scene3& scene) {
  if (!PatchBases(scene).is_empty()) Judge(scene).judge();
}

}  // namespace hottel
