#include "geometry/space/contacts/near_contacts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/space/contacts/box_tree.h"
#include "geometry/space/contacts/corner_table.h"
#include "geometry/space/scene/facet_scene.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;
using Part = ClosestPoint3::Part;

class ContactFinder {
 public:
  explicit ContactFinder(const Scene3& scene)
      : scene_(scene),
        polygons_(scene.polygons),
        corners_(scene.polygons),
        edges_(corners_.edges()),
        tree_(grown_boxes()) {
    squared_width_.resize(polygons_.size());
    for (const Polygon3& polygon : polygons_) normals_.push_back(doubled_area(polygon));
  }

  Contacts3 find() {
    for (std::uint32_t c = 0; c < corners_.points.size(); ++c) look_around_corner(c);
    find_edge_pairs();
    find_crossings();
    return std::move(contacts_);
  }

 private:
  struct Target {
    std::uint32_t surface;
    ClosestPoint3 closest;
  };

  std::vector<Box3> grown_boxes() {
    std::vector<Box3> boxes;
    for (std::uint32_t s = 0; s < polygons_.size(); ++s) {
      reach_.push_back(width_above(corners_, s) / kNearPart3);
      boxes.push_back(corners_.box_of_polygon(s));
      grow(boxes.back(), reach_.back());
    }
    return boxes;
  }

  const Rational& squared_width_of(std::uint32_t s) {
    if (!squared_width_[s]) squared_width_[s] = squared_width(polygons_[s]);
    return *squared_width_[s];
  }

  bool is_near(const Rational& squared, const Surfaces& surfaces) {
    const Rational scaled = squared * kNearPart3 * kNearPart3;
    return std::all_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t s) { return scaled < squared_width_of(s); });
  }

  double reach_of(const Surfaces& surfaces) const {
    double least = reach_[surfaces.front()];
    for (const std::uint32_t s : surfaces) least = std::min(least, reach_[s]);
    return least;
  }

  bool has_corner(std::uint32_t s, std::uint32_t c) const {
    return std::binary_search(corners_.at[c].begin(), corners_.at[c].end(), s);
  }

  // The polygons around a corner that do not have it: those that it touches, and the nearest of the others.
  void look_around_corner(std::uint32_t c) {
    const Point3& at = corners_.points[c];
    const Surfaces& own = corners_.at[c];
    found_.clear();
    tree_.find(corners_.box_of_corner(c), found_);
    std::sort(found_.begin(), found_.end());
    Surfaces touched = own, through;
    std::vector<Target> near;
    for (const std::uint32_t s : found_) {
      if (has_corner(s, c) || distance_below(corners_, s, c) > std::min(reach_[s], reach_of(own))) continue;
      ClosestPoint3 closest = closest_point(polygons_[s], at);
      if (closest.squared != 0) {
        near.push_back({s, std::move(closest)});
        continue;
      }
      touched.push_back(s);
      if (closest.part == Part::kSide) through.push_back(s);
    }
    if (!through.empty()) contacts_.junctions.push_back({at, own, std::move(through)});
    std::erase_if(near, [&](const Target& target) {
      return !is_near(target.closest.squared, {target.surface}) || !is_near(target.closest.squared, own) ||
             is_beside(c, target, touched);
    });
    if (!near.empty()) add_nearest(c, near);
  }

  // The corner lies in the plane of the target, and a polygon there that it touches reaches to the target: nothing is
  // between the two.
  bool is_beside(std::uint32_t c, const Target& target, const Surfaces& touched) const {
    const Vector3& normal = normals_[target.surface];
    if (dot(normal, corners_.points[c] - polygons_[target.surface].points[0]) != 0) return false;
    return std::any_of(touched.begin(), touched.end(), [&](std::uint32_t s) {
      return cross(normal, normals_[s]).is_zero() && contains(polygons_[s], target.closest.at);
    });
  }

  void add_nearest(std::uint32_t c, const std::vector<Target>& near) {
    const Target* nearest = &near.front();
    for (const Target& target : near)
      if (target.closest.squared < nearest->closest.squared) nearest = &target;
    NearContact3 contact;
    contact.surfaces = corners_.at[c];
    contact.from = corners_.points[c];
    if (const auto corner = corner_as_near(contact.from, *nearest, near)) {
      if (!told_.insert(std::minmax(c, *corner)).second) return;
      contact.kind = NearContact3::Kind::kCornerCorner;
      contact.to = corners_.points[*corner];
      contact.squared = squared_distance(contact.from, contact.to);
      contact.targets = corners_.at[*corner];
      if (!is_near(contact.squared, contact.targets) || !is_near(contact.squared, contact.surfaces)) return;
    } else {
      contact.kind =
          nearest->closest.part == Part::kInside ? NearContact3::Kind::kCornerFace : NearContact3::Kind::kCornerEdge;
      contact.to = nearest->closest.at;
      contact.squared = nearest->closest.squared;
      for (const Target& target : near)
        if (target.closest.at == contact.to) contact.targets.push_back(target.surface);
    }
    contact.sticks_out = sticks_out(c, contact);
    contact.is_angle = std::all_of(contact.surfaces.begin(), contact.surfaces.end(), [&](std::uint32_t s) {
      return std::any_of(contact.targets.begin(), contact.targets.end(),
                         [&](std::uint32_t t) { return share_an_edge(s, t); });
    });
    contacts_.near.push_back(std::move(contact));
  }

  // The nearest corner of what is near, where it is less than sqrt(2) times as far as the nearest point.
  std::optional<std::uint32_t> corner_as_near(const Point3& from, const Target& nearest,
                                              const std::vector<Target>& near) const {
    std::optional<std::uint32_t> corner;
    Rational least = 2 * nearest.closest.squared;
    for (const Target& target : near)
      for (const std::uint32_t c : corners_.of_polygon[target.surface])
        if (Rational squared = squared_distance(from, corners_.points[c]); squared < least) {
          least = std::move(squared);
          corner = c;
        }
    return corner;
  }

  // An edge that ends at the corner crosses a target next to it.
  bool sticks_out(std::uint32_t c, const NearContact3& contact) {
    for (const std::uint32_t s : contact.surfaces)
      for (const Side3& side : sides_of(polygons_[s])) {
        if (side.from != contact.from && side.to != contact.from) continue;
        for (const std::uint32_t t : contact.targets)
          if (const auto at = meeting_point(polygons_[t], side))
            if (const Rational squared = squared_distance(*at, contact.from);
                is_near(squared, {t}) && is_near(squared, corners_.at[c]))
              return true;
      }
    return false;
  }

  // The two have two points in common, and so the way from one to the other where they are convex.
  bool share_an_edge(std::uint32_t s, std::uint32_t t) const {
    std::optional<Point3> first;
    const auto is_second = [&](const Point3& point) {
      if (!first) first = point;
      return !(*first == point);
    };
    for (const auto& [one, other] : {std::pair(s, t), std::pair(t, s)})
      for (const Side3& side : sides_of(polygons_[one])) {
        if (contains(polygons_[other], side.from) && is_second(side.from)) return true;
        if (const auto at = meeting_point(polygons_[other], side); at && is_second(*at)) return true;
      }
    return false;
  }

  Side3 segment(const CornerTable3::Edge& edge) const { return {corners_.points[edge.a], corners_.points[edge.b]}; }

  Box3 box_of(const CornerTable3::Edge& edge) const {
    Box3 box = corners_.box_of_corner(edge.a);
    box.include(corners_.box_of_corner(edge.b));
    return box;
  }

  void find_edge_pairs() {
    std::vector<Box3> boxes;
    for (const CornerTable3::Edge& edge : edges_) {
      boxes.push_back(box_of(edge));
      grow(boxes.back(), reach_of(edge.polygons));
    }
    const BoxTree3 tree(boxes);
    for (std::uint32_t k = 0; k < edges_.size(); ++k) {
      found_.clear();
      tree.find(box_of(edges_[k]), found_);
      std::sort(found_.begin(), found_.end());
      for (const std::uint32_t other : found_)
        if (other > k) look_at_pair(edges_[k], edges_[other]);
    }
  }

  void look_at_pair(const CornerTable3::Edge& e, const CornerTable3::Edge& f) {
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return;
    if (distance_below(corners_, e, f) > std::min(reach_of(e.polygons), reach_of(f.polygons))) return;
    const Side3 one = segment(e), other = segment(f);
    const auto closest = closest_insides(one, other);
    if (!closest) return;
    const Rational squared = squared_distance(closest->from, closest->to);
    const auto near = [&](const Rational& distance) {
      return is_near(distance, e.polygons) && is_near(distance, f.polygons);
    };
    if (squared == 0 || !near(squared)) return;
    for (const Point3& end : {other.from, other.to})
      if (near(closest_point(one, end).squared)) return;
    for (const Point3& end : {one.from, one.to})
      if (near(closest_point(other, end).squared)) return;
    for (const std::uint32_t s : f.polygons)
      if (meeting_point(polygons_[s], one)) return;
    for (const std::uint32_t s : e.polygons)
      if (meeting_point(polygons_[s], other)) return;
    NearContact3 contact;
    contact.kind = NearContact3::Kind::kEdgeEdge;
    contact.surfaces = e.polygons;
    contact.targets = f.polygons;
    contact.from = closest->from;
    contact.to = closest->to;
    contact.squared = squared;
    contacts_.near.push_back(std::move(contact));
  }

  void find_crossings() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> told;
    for (const CornerTable3::Edge& edge : edges_) {
      found_.clear();
      tree_.find(box_of(edge), found_);
      std::sort(found_.begin(), found_.end());
      for (const std::uint32_t through : found_) {
        if (has_corner(through, edge.a) || has_corner(through, edge.b)) continue;
        const BoundedValue from = height(corners_, through, edge.a), to = height(corners_, through, edge.b);
        const bool above = from.value > from.error && to.value > to.error;
        const bool below = from.value < -from.error && to.value < -to.error;
        if (above || below) continue;
        const std::uint32_t group = scene_.surfaces[through].group;
        const auto is_told = [&](std::uint32_t s) {
          return told.count(std::minmax(scene_.surfaces[s].group, group)) != 0;
        };
        if (std::all_of(edge.polygons.begin(), edge.polygons.end(), is_told)) continue;
        const auto at = crossing_of(segment(edge), through);
        if (!at) continue;
        for (const std::uint32_t s : edge.polygons)
          if (told.insert(std::minmax(scene_.surfaces[s].group, group)).second)
            contacts_.crossings.push_back({*at, s, through});
      }
    }
  }

  // Where the inside of the segment meets the inside of the polygon.
  std::optional<Point3> crossing_of(const Side3& side, std::uint32_t through) const {
    const Point3& origin = polygons_[through].points[0];
    const int from = sgn(dot(normals_[through], side.from - origin)),
              to = sgn(dot(normals_[through], side.to - origin));
    if (from * to >= 0) return std::nullopt;
    auto at = meeting_point(polygons_[through], side);
    if (at)
      for (const Side3& border : sides_of(polygons_[through]))
        if (closest_point(border, *at).squared == 0) return std::nullopt;
    return at;
  }

  const Scene3& scene_;
  const std::vector<Polygon3>& polygons_;
  const CornerTable3 corners_;
  const std::vector<CornerTable3::Edge> edges_;
  std::vector<double> reach_;  // the width of each polygon over kNearPart3, or more
  const BoxTree3 tree_;        // of the polygons, grown by that
  std::vector<Vector3> normals_;
  std::vector<std::optional<Rational>> squared_width_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> told_;  // pairs of corners
  Surfaces found_;
  Contacts3 contacts_;
};

bool have_one_in_common(const Surfaces& a, const Surfaces& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t s) { return std::binary_search(b.begin(), b.end(), s); });
}

// Facets, and surfaces without the patches, become the surfaces that they are of; what a surface does to itself is left
// out.
void rename(Contacts3& contacts, const std::vector<std::uint32_t>& surface_of) {
  const auto rename_all = [&](Surfaces& surfaces) {
    for (std::uint32_t& s : surfaces) s = surface_of[s];
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  };
  for (NearContact3& contact : contacts.near) {
    rename_all(contact.surfaces);
    rename_all(contact.targets);
  }
  for (Junction3& junction : contacts.junctions) {
    rename_all(junction.ends);
    rename_all(junction.through);
  }
  for (Crossing3& crossing : contacts.crossings) {
    crossing.surface = surface_of[crossing.surface];
    crossing.through = surface_of[crossing.through];
  }
  std::erase_if(contacts.near, [](const NearContact3& c) { return have_one_in_common(c.surfaces, c.targets); });
  std::erase_if(contacts.junctions, [](const Junction3& j) { return have_one_in_common(j.ends, j.through); });
  std::erase_if(contacts.crossings, [](const Crossing3& c) { return c.surface == c.through; });
}

}  // namespace

Contacts3 find_contacts(const Scene3& scene) {
  if (const std::optional<BareScene3> bare = without_patches(scene)) {
    Contacts3 contacts = find_contacts(bare->scene);
    rename(contacts, bare->surface_of);
    return contacts;
  }
  const std::optional<FacetScene3> facets = facet_scene(scene);
  if (!facets) return ContactFinder(scene).find();
  Contacts3 contacts = ContactFinder(facets->scene).find();
  rename(contacts, facets->surface_of);
  return contacts;
}

}  // namespace hottel
