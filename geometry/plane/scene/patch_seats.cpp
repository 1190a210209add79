#include "geometry/plane/scene/patch_seats.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/plane/scene/closest_point.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::string text(const Point2& p) { return "(" + short_text(p.x) + ", " + short_text(p.y) + ")"; }

Rational dot(const Edge2& a, const Edge2& b) {
  return (a.to.x - a.from.x) * (b.to.x - b.from.x) + (a.to.y - a.from.y) * (b.to.y - b.from.y);
}

Rational squared_length(const Edge2& edge) { return squared_distance(edge.from, edge.to); }

Rational squared_distance_to_line(const Edge2& edge, const Point2& p) {
  const Rational area = doubled_area(edge.from, edge.to, p);
  return area * area / squared_length(edge);
}

// An edge that a patch may lie on, and how far off its line the farther end of the patch is.
struct Support {
  Edge2 edge;  // as the patch has to look: turned round where it lies on the back
  Rational squared_off;
  bool looks_alike = true;
};

// Where supports are looked for: near the patch, as where it lies on one, or anywhere.
enum class Near : bool { kNo, kYes };

// What patches lie on, as far as one patch is asked about. Patches may move while it is asked.
class Supports {
 public:
  explicit Supports(const Scene2& scene) : scene_(scene), patches_(scene) {
    if (patches_.is_empty()) return;
    for (const Edge2& edge : scene.edges) boxes_.emplace_back(edge);
  }

  const PatchBases& patches() const { return patches_; }

  // The edges that lie below some of a patch or beside it, the nearest line first; those that look as it does before
  // those that do not.
  std::vector<Support> supports(std::uint32_t patch, Near near) const {
    const Edge2& own = scene_.edges[patch];
    std::vector<Support> found;
    for_each_base(patch, near, [&](Edge2 edge) {
      const Rational from = position_on(edge, own.from), to = position_on(edge, own.to);
      if (from == to || std::max(from, to) <= 0 || std::min(from, to) >= 1) return;
      Rational off = std::max(squared_distance_to_line(edge, own.from), squared_distance_to_line(edge, own.to));
      const bool looks_alike = from < to;
      found.push_back({std::move(edge), std::move(off), looks_alike});
    });
    std::ranges::stable_sort(found, [](const Support& a, const Support& b) {
      if (a.looks_alike != b.looks_alike) return a.looks_alike;
      return a.squared_off < b.squared_off;
    });
    return found;
  }

  // The parts of the way along an edge of its line that the base has there, those that look the same way: merged,
  // ascending.
  std::vector<std::pair<Rational, Rational>> covered(std::uint32_t patch, const Edge2& along) const {
    std::vector<std::pair<Rational, Rational>> parts, merged;
    for_each_base(patch, Near::kYes, [&](const Edge2& edge) {
      if (dot(edge, along) > 0 && is_on_line(along, edge))
        parts.emplace_back(position_on(along, edge.from), position_on(along, edge.to));
    });
    std::ranges::sort(parts);
    for (auto& part : parts)
      if (!merged.empty() && part.first <= merged.back().second)
        merged.back().second = std::max(merged.back().second, part.second);
      else
        merged.push_back(std::move(part));
    return merged;
  }

 private:
  // Calls take(edge) for each edge of the base, as the patch has to look.
  template <class Take>
  void for_each_base(std::uint32_t patch, Near near, const Take& take) const {
    const PatchCarriers2::Box own(scene_.edges[patch]);
    for (const std::uint32_t s : patches().under(patch)) {
      // A patch that is a base itself may have moved a little.
      const bool is_met = own.meets(patches_.is_patch(s) ? PatchCarriers2::Box(scene_.edges[s]) : boxes_[s]);
      if (near == Near::kYes && !is_met) continue;
      const auto& [from, to] = scene_.edges[s];
      take(patches().is_on_backs(patch) ? Edge2{to, from} : Edge2{from, to});
    }
  }

  const Scene2& scene_;
  const PatchBases patches_;
  std::vector<PatchCarriers2::Box> boxes_;  // by surface, as they were at first
};

// Where two lines meet; nothing where they are parallel.
std::optional<Point2> crossing(const Edge2& a, const Edge2& b) {
  const Rational across =
      doubled_area({0, 0}, {a.to.x - a.from.x, a.to.y - a.from.y}, {b.to.x - b.from.x, b.to.y - b.from.y});
  if (across == 0) return std::nullopt;
  return point_at(a,
                  doubled_area(a.from, b.from, {a.from.x + b.to.x - b.from.x, a.from.y + b.to.y - b.from.y}) / across);
}

class Seater {
 public:
  Seater(Scene2& scene, const Rational& unit)
      : scene_(scene), unit_(unit), bases_(scene), typed_(scene.edges), is_seated_(typed_.size(), 0) {}

  void seat() {
    const auto order = bases_.patches().outermost_first();
    if (!order) return;
    for (const std::uint32_t patch : *order) seat(patch);
    for (std::uint32_t s = 0; s + 1 < scene_.edges.size(); ++s) join(s);
    close_polylines();
  }

 private:
  // Whether something is near enough for a patch and the edge that it is put on.
  bool is_near(std::uint32_t patch, const Edge2& line, const Rational& squared_distance) const {
    return is_within_seat(squared_distance, squared_length(typed_[patch]), squared_length(line), unit_);
  }

  void seat(std::uint32_t patch) {
    Edge2& edge = scene_.edges[patch];
    for (const Support& support : bases_.supports(patch, Near::kYes)) {
      if (!is_near(patch, support.edge, support.squared_off)) continue;
      const Edge2& line = support.edge;
      if (support.squared_off != 0)
        for (Point2* end : {&edge.from, &edge.to}) *end = point_at(line, position_on(line, *end));
      if (support.looks_alike) end_with_base(patch, line);
      is_seated_[patch] = 1;
      return;
    }
  }

  // What is beyond an end of the base by a little ends there.
  void end_with_base(std::uint32_t patch, const Edge2& line) {
    Edge2& edge = scene_.edges[patch];
    const Rational from = position_on(line, edge.from), to = position_on(line, edge.to);
    for (const auto& [low, high] : bases_.covered(patch, line)) {
      if (high <= from || low >= to) continue;
      move_a_little(patch, line, std::max(from, low), edge.from);
      move_a_little(patch, line, std::min(to, high), edge.to);
      return;
    }
  }

  void move_a_little(std::uint32_t patch, const Edge2& line, const Rational& place, Point2& point) const {
    Point2 to = point_at(line, place);
    if (is_near(patch, line, squared_distance(point, to))) point = std::move(to);
  }

  // Two pieces of a polyline meet again: on the line of both.
  void meet(std::uint32_t s, std::uint32_t next) {
    Point2 &end = scene_.edges[s].to, &begin = scene_.edges[next].from;
    if (end == begin || typed_[s].to != typed_[next].from || is_seated_[s] == 0 || is_seated_[next] == 0) return;
    const Point2 at = crossing(scene_.edges[s], scene_.edges[next]).value_or(end);
    if (is_near(s, typed_[next], squared_distance(at, typed_[s].to))) end = begin = at;
  }
  bool are_of_one_polyline(std::uint32_t s, std::uint32_t next) const {
    const Surface &a = scene_.surfaces[s], &b = scene_.surfaces[next];
    return a.on && b.on && a.group == b.group;
  }
  void join(std::uint32_t s) {
    if (are_of_one_polyline(s, s + 1)) meet(s, s + 1);
  }
  void close_polylines() {
    for (std::uint32_t first = 0, s = 0; s < scene_.edges.size(); ++s) {
      if (!are_of_one_polyline(first, s)) first = s;
      const bool is_last = s + 1 == scene_.edges.size() || !are_of_one_polyline(s, s + 1);
      if (is_last && first < s && are_of_one_polyline(first, s)) meet(s, first);
    }
  }

  Scene2& scene_;
  const Rational& unit_;
  const Supports bases_;
  const std::vector<Edge2> typed_;
  std::vector<char> is_seated_;  // by surface
};

// Says what is wrong with where patches lie.
class Judge {
 public:
  explicit Judge(const Scene2& scene) : scene_(scene), bases_(scene) {}

  void judge() const {
    for (std::uint32_t s = 0; s < scene_.edges.size(); ++s)
      if (bases_.patches().is_patch(s)) judge(s);
  }

 private:
  [[noreturn]] void refuse(std::uint32_t patch, const std::string& what, const std::string& remedy) const {
    refuse_patch(scene_, patch, what, remedy);
  }
  std::string base(std::uint32_t patch) const { return base_text(scene_.bases[*scene_.surfaces[patch].on]); }

  void judge(std::uint32_t patch) const {
    const std::vector<Support> supports = bases_.supports(patch, Near::kYes);
    const auto on_line = std::ranges::find_if(supports, [](const Support& s) { return s.squared_off == 0; });
    if (on_line == supports.end()) refuse_off(patch, bases_.supports(patch, Near::kNo));
    if (!on_line->looks_alike) refuse_turned_patch(scene_, patch);
    const Edge2& edge = scene_.edges[patch];
    Rational reached = 0;
    for (const auto& [low, high] : bases_.covered(patch, edge)) {
      if (high <= reached) continue;
      if (low > reached) refuse_beyond(patch, reached, std::min(low, Rational(1)));
      reached = high;
      if (reached >= 1) return;
    }
    refuse_beyond(patch, reached, 1);
  }

  void refuse_beyond(std::uint32_t patch, const Rational& from, const Rational& to) const {
    const Edge2& edge = scene_.edges[patch];
    refuse(patch,
           "leaves " + base(patch) + ", on which it lies, along " + text(point_at(edge, from)) + " to " +
               text(point_at(edge, to)),
           "shorten it, or make a surface without \"on\" of what is beyond");
  }

  // The farther end, and how far it is from the nearest edge of the base.
  void refuse_off(std::uint32_t patch, const std::vector<Support>& supports) const {
    const Edge2& edge = scene_.edges[patch];
    if (supports.empty()) {
      const std::uint32_t nearest = nearest_base(patch);
      refuse(patch,
             "does not lie on " + base(patch) + ": it runs beside it, from " + text(edge.from) + " to " + text(edge.to),
             "put it on " + along(nearest));
    }
    const Edge2& line = std::ranges::min_element(supports, {}, &Support::squared_off)->edge;
    const Rational from = squared_distance_to_line(line, edge.from), to = squared_distance_to_line(line, edge.to);
    refuse(patch,
           "does not lie on " + base(patch) + ": " + text(to > from ? edge.to : edge.from) + " is " +
               length_text(std::max(from, to)) + " off its line",
           "put its ends on the line from " + text(line.from) + " to " + text(line.to) +
               ", or give them as many digits as that has");
  }

  std::uint32_t nearest_base(std::uint32_t patch) const {
    const Point2& from = scene_.edges[patch].from;
    return *std::ranges::min_element(bases_.patches().under(patch), {}, [&](std::uint32_t s) {
      return closest_point(scene_.edges[s].from, scene_.edges[s].to, from).squared;
    });
  }
  std::string along(std::uint32_t s) const {
    const Edge2& edge = scene_.edges[s];
    return quoted_name(scene_.surfaces[s].name) + ", from " + text(edge.from) + " to " + text(edge.to);
  }

  const Scene2& scene_;
  const Supports bases_;
};

}  // namespace

void seat_patches(Scene2& scene, const Rational& unit) {
  if (!PatchBases(scene).is_empty()) Seater(scene, unit).seat();
}

void validate_patches(const Scene2& scene) {
  if (!scene.bases.empty()) Judge(scene).judge();
}

}  // namespace hottel
