#include "geometry/space/check/gap_closer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/check/repaired_shapes.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/contacts/box_tree.h"
#include "geometry/space/contacts/corner_table.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr int kMostPasses = 8;  // a move may bring other things within reach

class GapCloser {
 public:
  GapCloser(const Scene3& scene, const Rational& distance, const std::vector<char>& held)
      : scene_(scene), distance_(distance), squared_(distance * distance), table_(scene.polygons) {
    is_fixed_.assign(table_.points.size(), 0);
    for (std::uint32_t s = 0; s < held.size(); ++s)
      if (held[s] != 0) hold(s);
    for (const Mask3& mask : scene.masks)
      for (const std::uint32_t s : {mask.surface, mask.base}) hold(s);
    hold_patches();
  }

  Repair3 close() {
    std::vector<RepairStep> refused;
    for (;;) {
      start();
      for (int pass = 0; pass < kMostPasses && improve(); ++pass) {
      }
      Repair3 repair{scene_, {}, {}};
      tell_moves(repair.steps);
      if (const Corners blamed = rebuild(repair); !blamed.empty()) {
        for (const std::uint32_t s : blamed) keep_corners_of(s, refused);
        continue;
      }
      repair.steps.insert(repair.steps.end(), refused.begin(), refused.end());
      tell_left(repair.steps);
      repair.moved = moved_together();
      return repair;
    }
  }

 private:
  void hold_patches() {
    const PatchCarriers3 carriers(scene_);
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) {
      if (!carriers.bases().is_patch(s)) continue;
      hold(s);
      for (const std::uint32_t carrier : carriers.of(s)) hold(carrier);
    }
  }

  std::string name(std::uint32_t s) const { return quoted_name(scene_.surfaces[s].name); }
  std::uint32_t first_at(std::uint32_t c) const { return table_.at[c].front(); }
  const Point3& place(std::uint32_t c) const { return place_[into_[c]]; }

  void start() {
    place_ = table_.points;
    into_.resize(place_.size());
    members_.assign(place_.size(), {});
    for (std::uint32_t c = 0; c < place_.size(); ++c) {
      into_[c] = c;
      members_[c] = {c};
    }
    onto_.assign(place_.size(), std::nullopt);
    left_.clear();
  }

  Polygon3 polygon_now(std::uint32_t s) const {
    Polygon3 polygon;
    auto corner = table_.of_polygon[s].begin();
    const auto ring = [&](std::size_t count) {
      std::vector<Point3> points;
      for (std::size_t k = 0; k < count; ++k) points.push_back(place(*corner++));
      return without_repetitions(points);
    };
    polygon.points = ring(scene_.polygons[s].points.size());
    for (const auto& hole : scene_.polygons[s].holes)
      if (std::vector<Point3> points = ring(hole.size()); points.size() > 2) polygon.holes.push_back(std::move(points));
    return polygon;
  }

  // All that was joined at c may go there: nothing would be farther than the distance from where it was.
  bool may_move(std::uint32_t c, const Point3& to) const {
    return std::all_of(members_[c].begin(), members_[c].end(), [&](std::uint32_t m) {
      return is_fixed_[m] != 0 ? table_.points[m] == to : squared_distance(table_.points[m], to) <= squared_;
    });
  }

  // One pass over all corners; true when something moved.
  bool improve() {
    now_.clear();
    std::vector<Box3> boxes(scene_.polygons.size());
    for (std::uint32_t s = 0; s < scene_.polygons.size(); ++s) {
      now_.push_back(polygon_now(s));
      for (const Point3& p : now_[s].points) include_rounded(p, boxes[s]);
    }
    const BoxTree3 tree(std::move(boxes));
    left_.clear();
    bool has_moved = false;
    for (std::uint32_t c = 0; c < place_.size(); ++c) {
      if (into_[c] != c) continue;
      const Point3& at = place_[c];
      Box3 box;
      include_rounded({at.x - distance_, at.y - distance_, at.z - distance_}, box);
      include_rounded({at.x + distance_, at.y + distance_, at.z + distance_}, box);
      Corners near;
      tree.find(box, near);
      std::sort(near.begin(), near.end());
      if (!merge(c, near) && !snap(c, near)) continue;
      has_moved = true;
    }
    return has_moved;
  }

  // Joins c with the nearest corner within reach with which it can be joined.
  bool merge(std::uint32_t c, const Corners& near) {
    std::set<std::pair<Rational, std::uint32_t>> others;
    for (const std::uint32_t s : near)
      for (const std::uint32_t corner : table_.of_polygon[s]) {
        const std::uint32_t other = into_[corner];
        if (other == c) continue;
        Rational squared = squared_distance(place_[c], place_[other]);
        if (squared <= squared_) others.emplace(std::move(squared), other);
      }
    for (const auto& [squared, other] : others) {
      const std::uint32_t first = std::min(c, other), second = std::max(c, other);
      if (may_move(second, place_[first])) return join(second, first);
      if (may_move(first, place_[second])) return join(first, second);
    }
    return false;
  }

  bool join(std::uint32_t gone, std::uint32_t keep) {
    for (const std::uint32_t m : members_[gone]) into_[m] = keep;
    members_[keep].insert(members_[keep].end(), members_[gone].begin(), members_[gone].end());
    for (const std::uint32_t m : members_[gone])
      for (const std::uint32_t s : table_.at[m]) now_[s] = polygon_now(s);
    return true;
  }

  bool ends_at(std::uint32_t s, std::uint32_t c) const {
    return std::any_of(table_.of_polygon[s].begin(), table_.of_polygon[s].end(),
                       [&](std::uint32_t corner) { return into_[corner] == c; });
  }

  // Puts c onto the nearest edge within reach that it is not on, or else onto the nearest face.
  bool snap(std::uint32_t c, const Corners& near) {
    const Point3 at = place_[c];
    Corners touched;  // polygons that it lies on without ending there
    std::optional<std::pair<std::uint32_t, ClosestPoint3>> face;
    std::optional<std::pair<Side3, ClosestPoint3>> edge;
    std::uint32_t of_edge = 0;
    for (const std::uint32_t s : near) {
      if (ends_at(s, c) || !has_area(now_[s])) continue;
      ClosestPoint3 closest = closest_point(now_[s], at);
      if (closest.squared > squared_) continue;
      if (closest.squared == 0) touched.push_back(s);
      if (closest.squared == 0 && closest.part == ClosestPoint3::Part::kSide) continue;
      for (const Side3& side : sides_of(now_[s])) {
        ClosestPoint3 on_side = closest_point(side, at);
        if (on_side.part == ClosestPoint3::Part::kCorner || on_side.squared > squared_ || on_side.squared == 0)
          continue;
        if (edge && edge->second.squared <= on_side.squared) continue;
        edge.emplace(side, std::move(on_side));
        of_edge = s;
      }
      if (closest.squared > 0 && closest.part == ClosestPoint3::Part::kInside &&
          (!face || closest.squared < face->second.squared))
        face.emplace(s, std::move(closest));
    }
    if (edge && (move_onto_edge(c, of_edge, edge->first, edge->second, touched))) return true;
    if (face && move_onto_face(c, face->first, face->second, touched)) return true;
    if (edge)
      left_.emplace_back(c, of_edge);
    else if (face)
      left_.emplace_back(c, face->first);
    return false;
  }

  // Moves c where it may go and still touches what it touched.
  bool try_move(std::uint32_t c, const Point3& to, std::uint32_t onto, bool is_edge, const Corners& touched) {
    if (!may_move(c, to) || is_too_long(to)) return false;
    if (std::any_of(touched.begin(), touched.end(), [&](std::uint32_t s) { return !contains(now_[s], to); }))
      return false;
    place_[c] = to;
    onto_[c] = {onto, is_edge};
    for (const std::uint32_t m : members_[c])
      for (const std::uint32_t s : table_.at[m]) now_[s] = polygon_now(s);
    return true;
  }

  bool move_onto_edge(std::uint32_t c, std::uint32_t s, const Side3& side, const ClosestPoint3& closest,
                      const Corners& touched) {
    // The foot itself, where it can be: corners one over the other stay so.
    if (is_long(closest.at) && try_move(c, short_point_near(side, place_[c], closest), s, true, touched)) return true;
    if (try_move(c, closest.at, s, true, touched)) return true;
    // Where the edge passes through what the corner has to stay on.
    for (const std::uint32_t t : touched)
      if (const auto at = meeting_point(now_[t], side))
        if (try_move(c, *at, s, true, touched)) return true;
    return false;
  }

  bool move_onto_face(std::uint32_t c, std::uint32_t s, const ClosestPoint3& closest, const Corners& touched) {
    const Vector3 normal = doubled_area(now_[s]);
    const Point3 at = place_[c];
    const Rational height = dot(normal, at - now_[s].points[0]);
    if (is_long(closest.at))
      if (const Point3 to = short_point_near(now_[s], at, closest); contains(now_[s], to))
        if (try_move(c, to, s, false, touched)) return true;
    std::vector<Vector3> ways{normal};
    if (touched.size() == 1) {
      // Within the plane that it lies on, square to where that meets the other.
      const Vector3 other = doubled_area(now_[touched[0]]);
      ways.push_back(cross(cross(other, normal), other));
    } else if (touched.size() > 1) {
      ways.push_back(cross(doubled_area(now_[touched[0]]), doubled_area(now_[touched[1]])));
    }
    for (const Vector3& way : ways) {
      const Rational slope = dot(normal, way);
      if (slope == 0) continue;
      const Point3 to = moved(at, -height / slope, way);
      if (contains(now_[s], to) && try_move(c, to, s, false, touched)) return true;
    }
    return false;
  }

  void tell_moves(std::vector<RepairStep>& steps) const {
    for (std::uint32_t c = 0; c < table_.points.size(); ++c) {
      if (place(c) == table_.points[c]) continue;
      const std::uint32_t root = into_[c];
      const bool is_merged = root != c && place_[root] == table_.points[root];
      std::string where;
      if (is_merged)
        where = "where " + name(first_at(root)) + " has one";
      else if (onto_[root])
        where = fmt::format("{} {}", onto_[root]->second ? "on an edge of" : "on", name(onto_[root]->first));
      steps.push_back({is_merged ? "merged" : "snapped", scene_.surfaces[first_at(c)].name,
                       fmt::format("the corner of {} went from {} to {}, {}", names_text(scene_, table_.at[c]),
                                   place_text(table_.points[c]), place_text(place(c)), where)});
    }
  }

  void tell_left(std::vector<RepairStep>& steps) const {
    for (const auto& [c, s] : left_) {
      if (into_[c] != c || !has_area(now_[s])) continue;
      if (const Rational squared = closest_point(now_[s], place_[c]).squared; squared == 0 || squared > squared_)
        continue;
      steps.push_back({"not-repaired", scene_.surfaces[first_at(c)].name,
                       fmt::format("the corner of {} at {} is within reach of {}, but cannot be put there without "
                                   "leaving what it lies on, moving too far, or to a place of very long numbers",
                                   names_text(scene_, table_.at[c]), place_text(place_[c]), name(s))});
    }
  }

  // None of the corners of a polygon moves from now on.
  void hold(std::uint32_t s) {
    for (const std::uint32_t c : table_.of_polygon[s]) is_fixed_[c] = 1;
  }
  void keep_corners_of(std::uint32_t s, std::vector<RepairStep>& refused) {
    hold(s);
    refused.push_back({"not-repaired", scene_.surfaces[s].name,
                       fmt::format("the corners of {} stay: moved, they would make no polygon of it", name(s))});
  }

  // The polygons of which a corner moved; those of one list have one that moved in common, or two that were joined,
  // with another of it.
  std::vector<Corners> moved_together() const {
    std::vector<std::uint32_t> leader(scene_.polygons.size());
    std::iota(leader.begin(), leader.end(), 0U);
    const auto first = [&](std::uint32_t s) {
      while (leader[s] != s) s = leader[s] = leader[leader[s]];
      return s;
    };
    std::vector<std::optional<std::uint32_t>> joined(place_.size());  // a polygon with a corner that went there
    std::vector<char> has_moved(scene_.polygons.size(), 0);
    for (std::uint32_t c = 0; c < place_.size(); ++c) {
      if (place(c) == table_.points[c]) continue;
      for (const std::uint32_t s : table_.at[c]) {
        has_moved[s] = 1;
        std::optional<std::uint32_t>& other = joined[into_[c]];
        if (other) leader[first(s)] = first(*other);
        other = s;
      }
    }
    std::map<std::uint32_t, Corners> together;
    for (std::uint32_t s = 0; s < has_moved.size(); ++s)
      if (has_moved[s] != 0) together[first(s)].push_back(s);
    std::vector<Corners> result;
    for (auto& [_, surfaces] : together) result.push_back(std::move(surfaces));
    return result;
  }

  bool is_changed(std::uint32_t s) const {
    return std::any_of(table_.of_polygon[s].begin(), table_.of_polygon[s].end(),
                       [&](std::uint32_t c) { return !(place(c) == table_.points[c]); });
  }

  // Puts the polygons into the scene as they are now; returns those that cannot be put there.
  Corners rebuild(Repair3& repair) const {
    Corners blamed;
    std::set<std::string> names;
    for (const Surface& surface : scene_.surfaces) names.insert(surface.name);
    repair.scene.surfaces.clear();
    repair.scene.polygons.clear();
    std::vector<std::uint32_t> now(scene_.surfaces.size());  // of those that stay as they are
    const auto keep = [&](std::uint32_t s, const Surface& surface, Polygon3 polygon) {
      repair.origins.push_back(s);
      repair.former_names.push_back(surface.name);
      repair.scene.add(surface, std::move(polygon));
    };
    for (std::uint32_t s = 0; s < scene_.polygons.size(); ++s) {
      const Surface& surface = scene_.surfaces[s];
      if (!is_changed(s)) {
        now[s] = static_cast<std::uint32_t>(repair.scene.surfaces.size());
        keep(s, surface, scene_.polygons[s]);
        continue;
      }
      Polygon3 polygon = polygon_now(s);
      if (!has_area(polygon)) {
        repair.steps.push_back({"dropped", surface.name, fmt::format("{} has no area any more", name(s))});
        continue;
      }
      const bool keeps_side = dot(doubled_area(polygon), doubled_area(scene_.polygons[s])) > 0;
      if (keeps_side && polygon_problem(polygon).text.empty()) {
        keep(s, surface, std::move(polygon));
        continue;
      }
      const std::vector<Polygon3> triangles = keeps_side ? fan_of(polygon) : std::vector<Polygon3>();
      bool is_free = !triangles.empty();
      for (std::size_t k = 0; k < triangles.size(); ++k) is_free &= names.count(piece_name(surface.name, k)) == 0;
      if (!is_free) {
        blamed.push_back(s);
        continue;
      }
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        Surface piece = surface;
        piece.name = piece_name(surface.name, k);
        keep(s, piece, triangles[k]);
      }
      repair.steps.push_back({"triangulated", surface.name,
                              fmt::format("{} would not be plane any more: {} triangles, {} to {}", name(s),
                                          triangles.size(), quoted_name(piece_name(surface.name, 0)),
                                          quoted_name(piece_name(surface.name, triangles.size() - 1)))});
    }
    repair.scene.masks.clear();
    for (const Mask3& mask : scene_.masks) repair.scene.masks.push_back({now[mask.surface], now[mask.base]});
    return blamed;
  }

  const Scene3& scene_;
  const Rational distance_, squared_;
  const CornerTable3 table_;                                         // as it was
  std::vector<char> is_fixed_;                                       // by corner: it stays where it was
  std::vector<Point3> place_;                                        // where it is now, if nothing was joined with it
  std::vector<std::uint32_t> into_;                                  // the corner that each was joined into
  std::vector<Corners> members_;                                     // of a corner that others were joined into
  std::vector<std::optional<std::pair<std::uint32_t, bool>>> onto_;  // the polygon that it was put on, and on an edge
  std::vector<std::pair<std::uint32_t, std::uint32_t>> left_;
  std::vector<Polygon3> now_;
};

}  // namespace

Repair3 closed_gaps(const Scene3& scene, const Rational& distance, const std::vector<char>& held) {
  return GapCloser(scene, distance, held).close();
}

}  // namespace hottel
