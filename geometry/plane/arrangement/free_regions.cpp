#include "geometry/plane/arrangement/free_regions.h"

namespace hottel {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace

FreeRegions2::FreeRegions2(const Triangulation2& triangulation, std::size_t side_count) : of_side_(side_count, 0) {
  std::vector<std::uint32_t> of_triangle(triangulation.triangle_count(), kNone);
  const auto region_of = [&](TriangleId triangle) -> std::uint32_t& { return of_triangle[triangle.index()]; };
  std::vector<TriangleId> waiting;
  const auto flood = [&](TriangleId seed, std::uint32_t region) {
    if (region_of(seed) != kNone) return false;
    region_of(seed) = region;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const TriangleId triangle = waiting.back();
      waiting.pop_back();
      for (const HalfEdgeId h : half_edges_of(triangle)) {
        if (triangulation.is_open(h)) {
          const TriangleId next = triangle_of(triangulation.twin(h));
          if (region_of(next) == kNone) {
            region_of(next) = region;
            waiting.push_back(next);
          }
        } else if (triangulation.side(h) != kSky) {
          of_side_[triangulation.side(h).index()] = region;
        }
      }
    }
    return true;
  };
  for (const HalfEdgeId h : triangulation.half_edges())
    if (triangulation.is_bare_hull(h)) flood(triangle_of(h), 0);
  std::uint32_t count = 1;
  for (const TriangleId triangle : triangulation.triangles())
    if (flood(triangle, count)) ++count;

  begin_.assign(count + 1, 0);
  for (const std::uint32_t region : of_side_) ++begin_[region + 1];
  for (std::uint32_t region = 0; region < count; ++region) begin_[region + 1] += begin_[region];
  sides_.resize(of_side_.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const PieceSideId side : IdRange<PieceSideId>(of_side_.size())) sides_[next[of(side)]++] = side;
}

}  // namespace hottel
