#include "viewer/picture/plane/outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "geometry/patch_bases.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr std::size_t kNestingWork = 30'000'000;  // steps; beyond, nothing so fine can be seen anyway
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

double direction(const Corners2& corners, std::uint32_t surface) {
  const Pixel a = corners.at[corners.from[surface]], b = corners.at[corners.to[surface]];
  return same_bits::atan2(b.y - a.y, b.x - a.x);
}

struct Extent {
  Pixel low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Pixel high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  void add(Pixel p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

bool is_in_box(const Outline2& outline, Pixel p) {
  return p.x >= outline.top_left.x && p.x <= outline.bottom_right.x && p.y >= outline.top_left.y &&
         p.y <= outline.bottom_right.y;
}

// REQUIRES a point in the box of the outline.
bool contains(const Outline2& outline, Pixel p) {
  bool inside = false;
  const std::vector<Pixel>& corners = outline.polygon;
  for (std::size_t k = 0, last = corners.size() - 1; k < corners.size(); last = k++) {
    const Pixel &a = corners[k], &b = corners[last];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

// A point just inside, next to the middle of the longest edge.
Pixel inner_point(const Outline2& outline) {
  const std::vector<Pixel>& corners = outline.polygon;
  Pixel from, to;
  double longest = -1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Pixel &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length <= longest) continue;
    longest = length;
    from = a;
    to = b;
  }
  const double step = (outline.is_outward ? -1 : 1) * 0.01 / longest;  // fronts look out, or into a room
  return {(from.x + to.x) / 2 - (to.y - from.y) * step, (from.y + to.y) / 2 + (to.x - from.x) * step};
}

// Twice the signed area; positive when the outline turns clockwise on the screen.
double doubled_area(const Corners2& corners, const std::vector<std::uint32_t>& surfaces) {
  const Pixel o = corners.at[corners.from[surfaces.front()]];
  double sum = 0;
  for (const std::uint32_t s : surfaces) {
    const Pixel a = corners.at[corners.from[s]], b = corners.at[corners.to[s]];
    sum += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
  }
  return sum;
}

// Hands each closed polyline to `add`; returns which surfaces belong to none. Patches are neither.
template <class Add>
std::vector<bool> singles(const Scene2& scene, const Corners2& corners, const Add& add) {
  std::vector<bool> single(corners.surfaces(), true);
  for (std::uint32_t begin = 0; begin < corners.surfaces();) {
    std::uint32_t end = begin + 1;
    if (scene.surfaces[begin].on) {
      single[begin++] = false;
      continue;
    }
    while (end < corners.surfaces() && scene.surfaces[end].group == scene.surfaces[begin].group &&
           corners.to[end - 1] == corners.from[end])
      ++end;
    if (end - begin >= 3 && corners.to[end - 1] == corners.from[begin]) {
      std::vector<std::uint32_t> run(end - begin);
      std::iota(run.begin(), run.end(), begin);
      std::fill(single.begin() + begin, single.begin() + end, false);
      add(std::move(run));
    }
    begin = end;
  }
  return single;
}

// How edges that are listed one by one follow each other.
class Joints {
 public:
  Joints(const Corners2& corners, const std::vector<bool>& single)
      : corners_(corners), leaving_(corners.at.size()), arriving_(corners.at.size()), kept_(single) {
    for (std::uint32_t s = 0; s < corners.surfaces(); ++s) {
      if (!single[s]) continue;
      leaving_[corners.from[s]].push_back(s);
      arriving_[corners.to[s]].push_back(s);
    }
    drop_dead_ends();
  }

  // Whether a surface is followed and preceded by others without end.
  bool kept(std::uint32_t surface) const { return kept_[surface]; }

  // The next edge with the region still on the right: the first one met when turning counter-clockwise from straight
  // back; kNone when nothing follows.
  std::uint32_t next(std::uint32_t surface) const {
    const double back = direction(corners_, surface) + std::numbers::pi;
    std::uint32_t best = kNone;
    double best_turn = 0;
    for (const std::uint32_t candidate : leaving_[corners_.to[surface]]) {
      if (!kept_[candidate]) continue;
      double turn = std::remainder(back - direction(corners_, candidate), 2 * std::numbers::pi);
      if (turn <= 1e-9) turn += 2 * std::numbers::pi;
      if (best == kNone || turn < best_turn) {
        best = candidate;
        best_turn = turn;
      }
    }
    return best;
  }

 private:
  void drop_dead_ends() {
    std::vector<std::size_t> out, in;
    std::vector<std::uint32_t> dead;
    for (std::uint32_t v = 0; v < corners_.at.size(); ++v) {
      out.push_back(leaving_[v].size());
      in.push_back(arriving_[v].size());
      if (out[v] == 0 || in[v] == 0) dead.push_back(v);
    }
    const auto drop = [&](std::uint32_t surface) {
      if (!kept_[surface]) return;
      kept_[surface] = false;
      if (--out[corners_.from[surface]] == 0) dead.push_back(corners_.from[surface]);
      if (--in[corners_.to[surface]] == 0) dead.push_back(corners_.to[surface]);
    };
    while (!dead.empty()) {
      const std::uint32_t v = dead.back();
      dead.pop_back();
      for (const std::uint32_t s : leaving_[v]) drop(s);
      for (const std::uint32_t s : arriving_[v]) drop(s);
    }
  }

  const Corners2& corners_;
  std::vector<std::vector<std::uint32_t>> leaving_, arriving_;
  std::vector<bool> kept_;
};

// The closed runs, the largest area first.
std::vector<Outline2> closed_runs(const Scene2& scene, const Corners2& corners) {
  std::vector<Outline2> found;
  const auto add = [&](std::vector<std::uint32_t> run) {
    const double doubled = doubled_area(corners, run);
    if (doubled == 0) return;
    found.emplace_back();
    found.back().surfaces = std::move(run);
    found.back().is_outward = doubled < 0;
    found.back().area = std::abs(doubled) / 2;
  };
  const std::vector<bool> single = singles(scene, corners, add);
  const Joints joints(corners, single);
  std::vector<bool> used(corners.surfaces(), false);
  for (std::uint32_t first = 0; first < corners.surfaces(); ++first) {
    if (!joints.kept(first) || used[first]) continue;
    std::vector<std::uint32_t> run;
    std::uint32_t s = first;
    while (s != kNone && !used[s]) {
      used[s] = true;
      run.push_back(s);
      s = joints.next(s);
    }
    // A run that meets itself later than at its beginning is closed from there on.
    const auto start = std::find(run.begin(), run.end(), s);
    if (start == run.end()) continue;
    run.erase(run.begin(), start);
    add(run);
  }
  std::stable_sort(found.begin(), found.end(), [](const Outline2& a, const Outline2& b) { return a.area > b.area; });
  return found;
}

}  // namespace

Outlines2::Outlines2(const Scene2& scene, const Corners2& corners) : closed(closed_runs(scene, corners)) {
  std::vector<bool> on_run(corners.surfaces(), false);
  for (Outline2& outline : closed) {
    Extent extent;
    for (const std::uint32_t s : outline.surfaces) {
      on_run[s] = true;
      outline.polygon.push_back(corners.at[corners.from[s]]);
      extent.add(outline.polygon.back());
    }
    outline.top_left = extent.low;
    outline.bottom_right = extent.high;
  }
  for (std::uint32_t s = 0; s < corners.surfaces(); ++s)
    if (!on_run[s] && !scene.surfaces[s].on) loose.push_back(s);
  add_patches(scene);
  std::size_t steps = kNestingWork;
  for (std::size_t k = 0; k < closed.size(); ++k) nest(k, inner_point(closed[k]), steps);
  for (const std::uint32_t s : loose) {
    const Pixel a = corners.at[corners.from[s]], b = corners.at[corners.to[s]];
    around_loose.push_back(innermost(closed.size(), {(a.x + b.x) / 2, (a.y + b.y) / 2}, steps));
  }
  for (const Outline2& outline : closed) levels = std::max(levels, outline.level + 1);
  if (steps == 0) {  // rooms below, furniture on top
    for (Outline2& outline : closed) {
      outline.level = outline.is_outward ? 1 : 0;
      outline.around.reset();
    }
    std::fill(around_loose.begin(), around_loose.end(), std::nullopt);
    levels = 2;
  }
}

// Each with what it lies on.
void Outlines2::add_patches(const Scene2& scene) {
  const PatchCarriers2 carriers_of(scene);
  const PatchBases& bases = carriers_of.bases();
  if (bases.is_empty()) return;
  std::vector<std::uint32_t> outline_of(scene.surfaces.size(), kNone);
  for (std::uint32_t k = 0; k < closed.size(); ++k)
    for (const std::uint32_t s : closed[k].surfaces) outline_of[s] = k;
  for (std::uint32_t patch = 0; patch < scene.surfaces.size(); ++patch) {
    if (!bases.is_patch(patch)) continue;
    std::uint32_t below = patch;
    while (bases.is_patch(below)) {
      const std::vector<std::uint32_t> carriers = carriers_of.of(below);
      if (carriers.empty()) break;
      below = carriers.front();
    }
    (outline_of[below] == kNone ? loose : closed[outline_of[below]].surfaces).push_back(patch);
  }
}

// The smallest of the first `count` outlines that has the point inside.
std::optional<std::size_t> Outlines2::innermost(std::size_t count, Pixel point, std::size_t& steps) const {
  while (count-- > 0 && steps > 0) {
    steps -= std::min(steps, std::size_t{1});
    if (!is_in_box(closed[count], point)) continue;
    steps -= std::min(steps, closed[count].polygon.size());
    if (contains(closed[count], point)) return count;
  }
  return std::nullopt;
}

void Outlines2::nest(std::size_t k, Pixel point, std::size_t& steps) {
  closed[k].around = innermost(k, point, steps);
  if (closed[k].around) closed[k].level = closed[*closed[k].around].level + 1;
}

}  // namespace hottel
