#include "geometry/plane/scene/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/plane/scene/closest_point.h"

namespace hottel {
PatchCarriers2::PatchCarriers2(const Scene2& scene) : scene_(&scene), bases_(scene) {
  if (bases_.is_empty()) return;
  for (const Edge2& edge : scene.edges) boxes_.emplace_back(edge);
}

PatchCarriers2::Box::Box(const Edge2& edge) {
  constexpr double kPart = 2e-4;  // twice what the tolerance lets pass
  constexpr double kAll = std::numeric_limits<double>::infinity();
  const auto [ax, ay] = to_doubles(edge.from);
  const auto [bx, by] = to_doubles(edge.to);
  const double sides = kPart * (std::abs(bx - ax) + std::abs(by - ay));
  const double more = std::isfinite(sides) ? sides : kAll;  // an edge beyond the range of doubles may be anywhere
  const auto is_far = [&](double value) { return !std::isfinite(value) || more == kAll; };
  const auto below = [&](double p, double q) {
    return is_far(p) || is_far(q) ? -kAll : std::nextafter(std::min(p, q) - more, -kAll);
  };
  const auto above = [&](double p, double q) {
    return is_far(p) || is_far(q) ? kAll : std::nextafter(std::max(p, q) + more, kAll);
  };
  low_x = below(ax, bx);
  high_x = above(ax, bx);
  low_y = below(ay, by);
  high_y = above(ay, by);
}

std::vector<std::uint32_t> PatchCarriers2::of(std::uint32_t patch) const {
  const Edge2& own = scene_->edges[patch];
  std::vector<std::uint32_t> carriers;
  for (const std::uint32_t s : bases_.under(patch)) {
    const Edge2& edge = scene_->edges[s];
    if (!boxes_[patch].meets(boxes_[s]) || edge.from == edge.to || !is_on_line(edge, own)) continue;
    const Rational from = position_on(edge, own.from), to = position_on(edge, own.to);
    if (std::max(from, to) > 0 && std::min(from, to) < 1) carriers.push_back(s);
  }
  return carriers;
}

std::vector<std::uint32_t> patches_on(const Scene2& scene, const std::vector<std::uint32_t>& surfaces) {
  const PatchCarriers2 carriers(scene);
  return carriers.bases().resting_on(surfaces, [&](std::uint32_t patch) { return carriers.of(patch); });
}

std::string shorter_patch_hint(const Scene2& scene, const Face& a, const Face& b) {
  const auto squared_length = [&](const Face& face) {
    const Edge2& edge = scene.edges[face.surface];
    return squared_distance(edge.from, edge.to);
  };
  return squared_length(a) < squared_length(b) ? patch_hint(scene, a, b) : patch_hint(scene, b, a);
}

std::optional<BareScene2> without_patches(const Scene2& scene) {
  if (PatchBases(scene).is_empty()) return std::nullopt;
  BareScene2 bare{scene, {}};
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (!scene.surfaces[s].on) bare.surface_of.push_back(s);
  bare.scene.keep(bare.surface_of);
  return bare;
}

namespace {

// The ends of a patch, each where the edge that had it went.
Edge2 carried(const Edge2& patch, const std::vector<std::uint32_t>& carriers, const Scene2& before,
              const Scene2& after) {
  const auto moved = [&](const Point2& end) {
    const auto has_it = [&](std::uint32_t s) {
      const Rational place = position_on(before.edges[s], end);
      return 0 <= place && place <= 1;
    };
    const auto carrier = std::ranges::find_if(carriers, has_it);
    const std::uint32_t s = carrier == carriers.end() ? carriers.front() : *carrier;
    return point_at(after.edges[s], position_on(before.edges[s], end));
  };
  return {moved(patch.from), moved(patch.to)};
}

// A patch that went from `old` to `now`, put back onto an edge; `now` where that cannot be.
Edge2 slid(const Edge2& old, const Edge2& now, const Edge2& along) {
  Rational from = position_on(along, now.from), to = position_on(along, now.to);
  const Rational length = abs(to - from);
  if ((from < to) != (position_on(along, old.from) < position_on(along, old.to))) return now;
  if (old.from == now.from || old.to == now.to) {
    from = std::clamp(from, Rational(0), Rational(1));
    to = std::clamp(to, Rational(0), Rational(1));
  } else {
    if (length > 1) return now;
    const Rational low = std::min(from, to), shift = std::clamp(low, Rational(0), Rational(1 - length)) - low;
    from += shift;
    to += shift;
  }
  return from == to ? now : Edge2{point_at(along, from), point_at(along, to)};
}

}  // namespace

void carry_patches(const Scene2& before, Scene2& after) {
  const PatchCarriers2 carriers_of(before);
  const auto order = carriers_of.bases().outermost_first();
  if (carriers_of.bases().is_empty() || !order) return;
  const auto has_moved = [&](std::uint32_t s) { return after.edges[s] != before.edges[s]; };
  for (const std::uint32_t patch : *order) {
    const std::vector<std::uint32_t> carriers = carriers_of.of(patch);
    if (carriers.empty()) continue;
    Edge2& edge = after.edges[patch];
    if (std::ranges::any_of(carriers, has_moved))
      edge = carried(before.edges[patch], carriers, before, after);
    else if (has_moved(patch) && carriers.size() == 1)
      edge = slid(before.edges[patch], edge, before.edges[carriers.front()]);
  }
}

void rename_bases(const Scene2& before, const std::vector<std::optional<std::uint32_t>>& place, Scene2& after) {
  const PatchCarriers2 carriers_of(before);
  const PatchBases &old = carriers_of.bases(), now(after);
  for (std::uint32_t patch = 0; patch < before.surfaces.size() && !old.is_empty(); ++patch) {
    if (!old.is_patch(patch) || !place[patch]) continue;
    std::vector<std::uint32_t> carriers;
    for (const std::uint32_t s : carriers_of.of(patch))
      if (place[s]) carriers.push_back(*place[s]);
    const auto is_under = [&](std::uint32_t s) { return now.lies_on(*place[patch], s); };
    if (carriers.empty() || std::ranges::all_of(carriers, is_under)) continue;
    const PatchBase base{after.surfaces[carriers.front()].name, old.is_on_backs(patch)};
    const auto known = std::ranges::find(after.bases, base);
    after.surfaces[*place[patch]].on = static_cast<std::uint32_t>(known - after.bases.begin());
    if (known == after.bases.end()) after.bases.push_back(base);
  }
}

}  // namespace hottel
