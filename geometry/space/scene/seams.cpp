#include "geometry/space/scene/seams.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/space/scene/bent_loops.h"

namespace hottel {
namespace {

using Loop = std::vector<std::size_t>;  // corners, by their places in the outline

bool is_before(const Point3& a, const Point3& b) {
  if (const int c = cmp(a.x, b.x)) return c < 0;
  if (const int c = cmp(a.y, b.y)) return c < 0;
  return a.z < b.z;
}

// For each corner the first place of its point in the order of points; nothing where all points differ.
std::optional<Loop> equal_corners(const std::vector<Point3>& points) {
  Loop order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return is_before(points[a], points[b]); });
  bool has_equal = false;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_equal = k > 0 && points[order[k]] == points[order[k - 1]];
    first[order[k]] = is_equal ? first[order[k - 1]] : order[k];
    has_equal |= is_equal;
  }
  if (!has_equal) return std::nullopt;
  return first;
}

bool goes_back(const Loop& corner) {
  const std::size_t n = corner.size();
  for (std::size_t k = 0; k < n; ++k)
    if (corner[k] == corner[(k + 2) % n]) return true;
  return false;
}

// Two sides of a loop between the same corners, one each way: the earlier, the later.
std::optional<std::pair<std::size_t, std::size_t>> seam_of(const Loop& loop, const Loop& corner) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> sides;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t from = corner[loop[k]], to = corner[loop[(k + 1) % loop.size()]];
    if (const auto back = sides.find({to, from}); back != sides.end()) return std::pair(back->second, k);
    sides.emplace(std::pair(from, to), k);
  }
  return std::nullopt;
}

// The loops that are left without seams, each from the corner that comes first.
std::vector<Loop> loops_without_seams(const Loop& corner) {
  std::vector<Loop> loops, left(1, Loop(corner.size()));
  std::iota(left[0].begin(), left[0].end(), std::size_t{0});
  while (!left.empty()) {
    const Loop loop = std::move(left.back());
    left.pop_back();
    if (loop.size() < 2) continue;
    const auto seam = seam_of(loop, corner);
    if (!seam) {
      loops.push_back(loop);
      std::rotate(loops.back().begin(), std::min_element(loops.back().begin(), loops.back().end()), loops.back().end());
      continue;
    }
    const auto at = [&](std::size_t k) { return loop.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto [there, back] = *seam;
    Loop outer(at(back + 1), loop.end());
    outer.insert(outer.end(), loop.begin(), at(there));
    left.push_back(std::move(outer));
    left.emplace_back(at(there + 1), at(std::max(back, there + 1)));
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

}  // namespace

bool open_seams(Polygon3& polygon) {
  const std::vector<Point3>& points = polygon.points;
  const std::optional<Loop> corner = points.size() < 8 ? std::nullopt : equal_corners(points);
  if (!corner || goes_back(*corner)) return false;
  std::vector<std::vector<Point3>> loops;
  for (const Loop& loop : loops_without_seams(*corner)) {
    loops.emplace_back();
    for (const std::size_t k : loop) loops.back().push_back(points[k]);
  }
  if (loops.size() < 2) return false;
  std::vector<Vector3> areas;
  for (const auto& loop : loops) areas.push_back(doubled_loop_area(loop));
  const auto largest = std::max_element(areas.begin(), areas.end(),
                                        [](const Vector3& a, const Vector3& b) { return dot(a, a) < dot(b, b); });
  const auto outline = static_cast<std::size_t>(largest - areas.begin());
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (k != outline && dot(areas[k], areas[outline]) >= 0) return false;
  polygon.points = std::move(loops[outline]);
  loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(outline));
  polygon.holes.insert(polygon.holes.end(), std::make_move_iterator(loops.begin()),
                       std::make_move_iterator(loops.end()));
  return true;
}

}  // namespace hottel
