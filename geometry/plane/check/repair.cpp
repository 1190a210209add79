#include "geometry/plane/check/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/harmless_repair.h"
#include "geometry/name.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/arrangement/solids.h"
#include "geometry/plane/check/contact_findings.h"
#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/gap_findings.h"
#include "geometry/plane/check/near_misses.h"
#include "geometry/plane/check/needles.h"
#include "geometry/plane/check/point_neighbours.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/closed_groups.h"
#include "geometry/plane/scene/closest_point.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr int kMostPasses = 8;               // a move may bring other things within reach
constexpr std::size_t kShortPlace = 48;      // characters of two coordinates that are kept as they come
constexpr unsigned long kMostDecimals = 60;  // of the parameter along a surface

// A point inside the segment a-b next to the foot of p: the foot itself where it has short coordinates, otherwise one
// with few decimals along the segment that is hardly farther from p.
Point2 short_point_near(const Point2& a, const Point2& b, const Point2& p, const ClosestPoint2& closest) {
  if (to_string(closest.at.x).size() + to_string(closest.at.y).size() <= kShortPlace) return closest.at;
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational t = (dx * (p.x - a.x) + dy * (p.y - a.y)) / (dx * dx + dy * dy);
  Integer power = 1;
  for (unsigned long decimals = 1; decimals <= kMostDecimals; ++decimals) {
    power *= 10;
    Integer rounded;
    const Rational scaled = t * power + Rational(1, 2);
    mpz_fdiv_q(rounded.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    Rational near(rounded, power);
    near.canonicalize();
    if (near <= 0 || near >= 1) continue;
    Point2 place{a.x + near * dx, a.y + near * dy};
    if (squared_distance(p, place) * 256 <= closest.squared * 289) return place;
  }
  return closest.at;
}

class GapCloser {
 public:
  GapCloser(const Scene2& scene, const Rational& distance, const std::vector<char>& held)
      : scene_(scene), distance_(distance), squared_(distance * distance) {
    PointIndex2 index;
    for (const auto& [from, to] : scene.edges) segments_.push_back({index.insert(from), index.insert(to)});
    for (const Point2& p : index.points()) origin_.push_back(p);
    place_ = origin_;
    const IdRange<VertexId> all(place_.size());
    into_.assign(all.begin(), all.end());
    members_.resize(place_.size());
    ending_.resize(place_.size());
    for (const VertexId v : all) members_[v.index()] = {v};
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (const VertexId v : {segments_[s].a, segments_[s].b}) ending_[v.index()].push_back(s);
    snapped_to_.resize(place_.size());
    is_held_.resize(place_.size());
    for (std::uint32_t s = 0; s < held.size(); ++s)
      if (held[s] != 0) hold(s);
    hold_patches();
    find_outlines();
  }

  Repair2 close() {
    for (int pass = 0; pass < kMostPasses && improve(); ++pass) {
    }
    Repair2 repair{scene_, {}, {}, moved_together(), {}};
    tell_moves(repair.steps);
    rebuild(repair);
    for (const auto& [v, s] : left_)
      if (into_[v.index()] == v && still_apart(v, s))
        repair.steps.push_back({"not-repaired", scene_.surfaces[ending_[v.index()].front()].name,
                                fmt::format("the end of {} at {} is within reach of {}, with which it makes an angle",
                                            name(ending_[v.index()].front()), place_text(place_[v.index()]), name(s))});
    return repair;
  }

 private:
  void hold(std::uint32_t s) { is_held_[segments_[s].a.index()] = is_held_[segments_[s].b.index()] = 1; }
  // Patches, and what they lie on, stay where they are, and are no repetitions.
  void hold_patches() {
    is_kept_.assign(scene_.surfaces.size(), 0);
    const PatchCarriers2 carriers_of(scene_);
    const PatchBases& bases = carriers_of.bases();
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) {
      if (!bases.is_patch(s)) continue;
      std::vector<std::uint32_t> stay = carriers_of.of(s);
      stay.push_back(s);
      for (const std::uint32_t one : stay) {
        hold(one);
        is_kept_[one] = 1;
      }
    }
  }

  std::string name(std::uint32_t s) const { return quoted_name(scene_.surfaces[s].name); }
  Segment2 segment(std::uint32_t s) const { return {into_[segments_[s].a.index()], into_[segments_[s].b.index()]}; }
  bool is_point(std::uint32_t s) const { return segment(s).a == segment(s).b; }

  // All that was joined at v may go there: nothing would be farther than the distance from where it was.
  bool may_move(VertexId v, const Point2& to) const {
    return std::all_of(members_[v.index()].begin(), members_[v.index()].end(), [&](VertexId m) {
      const Point2& from = origin_[m.index()];
      return is_held_[m.index()] != 0 ? from == to : squared_distance(from, to) <= squared_;
    });
  }

  // At least the distance, in the units of the approximate coordinates: as it compares with the width of the scene.
  double reach_in(const Vertices2& vertices) const {
    VertexId left(0), right(0), low(0), high(0);
    for (const VertexId v : IdRange<VertexId>(place_.size())) {
      if (place_[v.index()].x < place_[left.index()].x) left = v;
      if (place_[v.index()].x > place_[right.index()].x) right = v;
      if (place_[v.index()].y < place_[low.index()].y) low = v;
      if (place_[v.index()].y > place_[high.index()].y) high = v;
    }
    const Rational wide = place_[right.index()].x - place_[left.index()].x,
                   tall = place_[high.index()].y - place_[low.index()].y;
    const double approximate = wide > tall ? vertices.approximate(right).x - vertices.approximate(left).x
                                           : vertices.approximate(high).y - vertices.approximate(low).y;
    const double reach = 2 * approximate * to_double(distance_ / std::max(wide, tall));
    return std::nextafter(reach, std::numeric_limits<double>::infinity());
  }

  std::vector<std::vector<std::uint32_t>> candidates() const {
    std::vector<Point2> points;
    std::vector<Segment2> now;
    for (const Point2& p : place_) points.push_back(p);
    const Vertices2 vertices(points, points.size());
    for (std::uint32_t s = 0; s < segments_.size(); ++s) now.push_back(segment(s));
    return segments_near_vertices(vertices, now, std::vector<double>(place_.size(), reach_in(vertices)));
  }

  // One pass over all points; true when something moved.
  bool improve() {
    const auto near = candidates();
    left_.clear();
    bool moved = false;
    for (const VertexId v : IdRange<VertexId>(place_.size()))
      if (into_[v.index()] == v) moved |= merge(v, near[v.index()]) || snap(v, near[v.index()]);
    return moved;
  }

  // Joins v with the nearest end within reach with which it can be joined.
  bool merge(VertexId v, const std::vector<std::uint32_t>& near) {
    std::set<std::pair<Rational, VertexId>> ends;
    for (const std::uint32_t s : near)
      for (const VertexId u : {segment(s).a, segment(s).b}) {
        Rational squared = squared_distance(place_[v.index()], place_[u.index()]);
        if (u != v && squared <= squared_) ends.emplace(std::move(squared), u);
      }
    const auto nearest = std::find_if(ends.begin(), ends.end(), [&](const auto& end) {
      return may_move(std::max(v, end.second), place_[std::min(v, end.second).index()]);
    });
    if (nearest == ends.end()) return false;
    const VertexId keep = std::min(v, nearest->second), gone = std::max(v, nearest->second);
    for (const VertexId m : members_[gone.index()]) into_[m.index()] = keep;
    members_[keep.index()].insert(members_[keep.index()].end(), members_[gone.index()].begin(),
                                  members_[gone.index()].end());
    ending_[keep.index()].insert(ending_[keep.index()].end(), ending_[gone.index()].begin(),
                                 ending_[gone.index()].end());
    return true;
  }

  // Puts v onto the nearest surface within reach.
  bool snap(VertexId v, const std::vector<std::uint32_t>& near) {
    std::optional<std::pair<std::uint32_t, ClosestPoint2>> nearest;
    for (const std::uint32_t s : near) {
      const Segment2 now = segment(s);
      if (now.a == now.b || now.a == v || now.b == v) continue;
      ClosestPoint2 closest = closest_point(place_[now.a.index()], place_[now.b.index()], place_[v.index()]);
      if (closest.squared == 0) return false;  // it lies on one
      if (closest.end < 0 && closest.squared <= squared_ && (!nearest || closest.squared < nearest->second.squared))
        nearest = {s, std::move(closest)};
    }
    if (!nearest) return false;
    const auto& [s, closest] = *nearest;
    const Segment2 onto = segment(s);
    for (const std::uint32_t own : ending_[v.index()])
      for (const VertexId end : {segment(own).a, segment(own).b})
        if (end != v && (end == onto.a || end == onto.b)) {
          left_.emplace_back(v, s);
          return false;
        }
    Point2 to = short_point_near(place_[onto.a.index()], place_[onto.b.index()], place_[v.index()], closest);
    if (!may_move(v, to)) to = closest.at;
    if (!may_move(v, to)) return false;
    place_[v.index()] = std::move(to);
    snapped_to_[v.index()] = s;
    return true;
  }

  bool still_apart(VertexId v, std::uint32_t s) const {
    const Segment2 now = segment(s);
    return now.a != now.b && now.a != v && now.b != v &&
           closest_point(place_[now.a.index()], place_[now.b.index()], place_[v.index()]).squared > 0;
  }

  bool has_moved(VertexId v) const { return place_[into_[v.index()].index()] != origin_[v.index()]; }

  // The surfaces of which an end moved; those of one list have one that moved in common, or two that were joined, with
  // another of it.
  std::vector<std::vector<std::uint32_t>> moved_together() const {
    std::vector<std::uint32_t> leader(segments_.size());
    std::iota(leader.begin(), leader.end(), 0U);
    const auto first = [&](std::uint32_t s) {
      while (leader[s] != s) s = leader[s] = leader[leader[s]];
      return s;
    };
    std::vector<std::optional<std::uint32_t>> joined(place_.size());  // a surface with an end that went there
    std::map<std::uint32_t, std::vector<std::uint32_t>> together;
    const auto ends_of = [&](std::uint32_t s) { return std::array{segments_[s].a, segments_[s].b}; };
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (const VertexId v : ends_of(s))
        if (has_moved(v)) {
          std::optional<std::uint32_t>& other = joined[into_[v.index()].index()];
          if (other) leader[first(s)] = first(*other);
          other = s;
        }
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      if (std::ranges::any_of(ends_of(s), [&](VertexId v) { return has_moved(v); })) together[first(s)].push_back(s);
    std::vector<std::vector<std::uint32_t>> result;
    for (auto& [_, surfaces] : together) result.push_back(std::move(surfaces));
    return result;
  }

  void tell_moves(std::vector<RepairStep>& steps) const {
    for (const VertexId m : IdRange<VertexId>(origin_.size())) {
      const VertexId v = into_[m.index()];
      if (place_[v.index()] == origin_[m.index()]) continue;
      // Those that ended here before anything was joined stand first.
      const std::uint32_t s = ending_[m.index()].front();
      const bool is_merged = v != m;
      const std::string what = is_merged                ? "where " + name(ending_[v.index()].front()) + " ends"
                               : snapped_to_[v.index()] ? "on " + name(*snapped_to_[v.index()])
                                                        : "";
      steps.push_back({is_merged ? "merged" : "snapped", scene_.surfaces[s].name,
                       fmt::format("the end of {} went from {} to {}, {}", name(s), place_text(origin_[m.index()]),
                                   place_text(place_[v.index()]), what)});
    }
  }

  void rebuild(Repair2& repair) const {
    std::vector<Surface> kept;
    std::vector<Edge2> edges;
    std::map<std::pair<VertexId, VertexId>, std::vector<std::uint32_t>> by_ends;
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      const Segment2 now = segment(s);
      if (now.a == now.b) {
        repair.steps.push_back({"dropped", scene_.surfaces[s].name, fmt::format("{} became a point", name(s))});
        continue;
      }
      auto& same = by_ends[{now.a, now.b}];
      const auto first = std::find_if(same.begin(), same.end(), [&](std::uint32_t t) { return act_alike(t, s); });
      if (first != same.end() && must_close_[scene_.surfaces[s].group] != 0) {
        repair.steps.push_back(
            {"not-repaired", scene_.surfaces[s].name,
             fmt::format("{} repeats {}, but its outline would be open without it", name(s), name(*first))});
      } else if (first != same.end() && is_kept_[s] == 0) {
        repair.steps.push_back(
            {"dropped", scene_.surfaces[s].name, fmt::format("{} repeats {}", name(s), name(*first))});
        continue;
      }
      same.push_back(s);
      repair.origins.push_back(s);
      kept.push_back(scene_.surfaces[s]);
      edges.push_back({place_[now.a.index()], place_[now.b.index()]});
    }
    for (const Surface& surface : kept) repair.former_names.push_back(surface.name);
    repair.scene.surfaces = std::move(kept);
    repair.scene.edges = std::move(edges);
  }

  void find_outlines() {
    must_close_.assign(scene_.groups.size(), 0);
    const std::vector<ClosedGroup2> closed = closed_groups(scene_);
    if (!may_have_solids(scene_, closed)) return;
    for (const ClosedGroup2& group : closed) must_close_[group.group] = 1;
    for (std::uint32_t group = 0; group < scene_.groups.size(); ++group)
      if (scene_.groups[group].behind != Behind::kByOutline) must_close_[group] = 1;
  }

  bool act_alike(std::uint32_t s, std::uint32_t t) const {
    const Surface &a = scene_.surfaces[s], &b = scene_.surfaces[t];
    return scene_.materials[a.material] == scene_.materials[b.material] && a.back.has_value() == b.back.has_value() &&
           (!a.back || scene_.materials[*a.back] == scene_.materials[*b.back]);
  }

  const Scene2& scene_;
  const Rational distance_, squared_;
  std::vector<Segment2> segments_;  // as they were
  std::vector<Point2> origin_, place_;
  std::vector<VertexId> into_;                      // the vertex that each was joined into
  std::vector<std::vector<VertexId>> members_;      // of a vertex that others were joined into
  std::vector<std::vector<std::uint32_t>> ending_;  // surfaces by vertex; those that came by joining follow
  std::vector<std::optional<std::uint32_t>> snapped_to_;
  std::vector<std::pair<VertexId, std::uint32_t>> left_;
  std::vector<char> must_close_;  // by group
  std::vector<char> is_held_;     // by vertex: it stays where it was
  std::vector<char> is_kept_;     // by surface: it is never dropped as a repetition
};

// What is found without any light.
Findings2 shape_and_contacts(const Scene2& scene) {
  const Arrangement2 arrangement(scene, Division2(scene.surfaces.size(), 1), Conflicts2::kFirstWins);
  Findings2 findings = contact_findings(scene, find_contacts(scene, arrangement));
  for (Findings2 more : {gap_findings(scene, find_near_misses(scene), false), needle_findings(scene, arrangement)})
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  return findings;
}

}  // namespace

Repair2 close_gaps(const Scene2& scene, const Rational& distance) {
  HOTTEL_REQUIRE(distance > 0);
  const auto close = [&](const Scene2& some, const std::vector<char>& held) {
    return GapCloser(some, distance, held).close();
  };
  return HarmlessRepair(scene, close, shape_and_contacts).repair();
}

Repair2 unrepaired(const Scene2& scene) {
  Repair2 repair{scene, {}, {}};
  for (const Surface& surface : scene.surfaces) repair.former_names.push_back(surface.name);
  return repair;
}

std::string former_name(const Repair2& repair, const Element& element) {
  const std::size_t length = repair.scene.surfaces[element.surface].name.size();
  return repair.former_names[element.surface] + element.name.substr(length);
}

}  // namespace hottel
