// The closed outlines of a scene: rooms and furniture, and how they lie in each other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/corners.h"

namespace hottel {

// A closed run of edges, end to end.
struct Outline2 {
  std::vector<std::uint32_t> surfaces;  // those of the run, then the patches on them
  std::vector<Pixel> polygon;           // where each of the run begins
  bool is_outward = false;              // fronts look outwards: furniture, a pillar; else inwards: a room
  double area = 0;                      // in square pixels, positive
  std::optional<std::size_t> around;    // the smallest outline that this one lies in
  std::size_t level = 0;                // how many it lies in
  Pixel top_left, bottom_right;
};

// The outlines, the largest area first, and the edges that belong to none.
//
//   (1) a closed polyline is an outline of its own; edges listed one by one are joined end to end, and where several
//       leave a corner the run takes the one that keeps the region on its right narrowest
//   (2) edges that lead nowhere (a screen, a door leaf) and runs without an inside are loose
//   (3) outlines may touch what they lie in
//   (4) patches belong to what they lie on, and make no outlines
//
// Made for drawing: decided in doubles. What is solid is another question (solid_polygons.h). Where it would take too
// many steps to find what lies in what, as for many thousand outlines side by side, rooms are on level 0, furniture on
// level 1, and none lies in another.
// COST: O(n log n), and the number of those steps.
struct Outlines2 {
  std::vector<Outline2> closed;
  std::vector<std::uint32_t> loose;                      // surfaces
  std::vector<std::optional<std::size_t>> around_loose;  // per loose surface, into closed
  std::size_t levels = 0;

  // REQUIRES the corners of this scene; they are not needed afterwards.
  Outlines2(const Scene2& scene, const Corners2& corners);

 private:
  void add_patches(const Scene2& scene);
  // Both take what they do from the steps that are left, and stop when none are.
  std::optional<std::size_t> innermost(std::size_t count, Pixel point, std::size_t& steps) const;
  void nest(std::size_t k, Pixel point, std::size_t& steps);
};

}  // namespace hottel
