#include "geometry/plane/arrangement/free_regions.h"

namespace hottel {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

FreeRegions2::FreeRegions2(const Triangulation2& triangulation, std::size_t side_count) : of_side_(side_count, 0) {
  const auto triangles = static_cast<HalfEdgeId>(triangulation.triangle_count());
  std::vector<std::uint32_t> of_triangle(static_cast<std::size_t>(triangles), kNone);
  const auto region_of = [&](HalfEdgeId triangle) -> std::uint32_t& {
    return of_triangle[static_cast<std::size_t>(triangle)];
  };
  std::vector<HalfEdgeId> waiting;
  const auto flood = [&](HalfEdgeId seed, std::uint32_t region) {
    if (region_of(seed) != kNone) return false;
    region_of(seed) = region;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const HalfEdgeId triangle = waiting.back();
      waiting.pop_back();
      for (HalfEdgeId h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (const HalfEdgeId twin = triangulation.twin(h); twin >= 0) {
          if (region_of(twin / 3) == kNone) {
            region_of(twin / 3) = region;
            waiting.push_back(twin / 3);
          }
        } else if (triangulation.side(h) != kSky) {
          of_side_[static_cast<std::size_t>(triangulation.side(h))] = region;
        }
      }
    }
    return true;
  };
  for (HalfEdgeId h = 0; h < 3 * triangles; ++h)
    if (triangulation.twin(h) < 0 && triangulation.side(h) == kSky) flood(h / 3, 0);
  std::uint32_t count = 1;
  for (HalfEdgeId triangle = 0; triangle < triangles; ++triangle)
    if (flood(triangle, count)) ++count;

  begin_.assign(count + 1, 0);
  for (const std::uint32_t region : of_side_) ++begin_[region + 1];
  for (std::uint32_t region = 0; region < count; ++region) begin_[region + 1] += begin_[region];
  sides_.resize(of_side_.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t side = 0; side < of_side_.size(); ++side)
    sides_[next[of_side_[side]]++] = static_cast<PieceSideId>(side);
}

}  // namespace hottel
