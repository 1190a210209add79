// Exact places near what a hand points at.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/plane/local_edges.h"

namespace hottel {

// What to snap to.
struct SnapRequest2 {
  int decimals = 2;                       // of places where nothing is near (decimals_at)
  double reach = 0;                       // how near a vertex or an edge must be [scene length]
  std::vector<std::uint32_t> moved = {};  // surfaces that are no goal, nor their ends: those that are being moved
  bool to_vertices = true;
  bool to_edges = true;
};

// An exact place, and what it was snapped to.
struct Snap2 {
  enum class To : unsigned char { kDecimals, kVertex, kEdge };

  Point2 at;
  To to = To::kDecimals;
  std::optional<std::uint32_t> surface = {};  // the first whose end or edge it is; nothing for decimals
};

// Snaps to one scene, often. It keeps the scene's address: the scene must stay where it is, and as it is.
class Snapper2 {
 public:
  // COST: that of LocalEdges2.
  explicit Snapper2(const Scene2& scene) : scene_(&scene), local_(scene) {}
  explicit Snapper2(Scene2&&) = delete;

  // Returns the place to put what is dropped at `place`.
  //
  //   (1) an end within reach wins, the nearest: the result is that point
  //   (2) else an edge within reach, the nearest: the result lies exactly on it, ends included. On an edge along an
  //       axis the other coordinate has the decimals, as far as the edge goes; on a slanted one the place is `from` + t
  //       (`to` - `from`) with a decimal t, so that edges between decimals have decimals again. t has as many digits as
  //       make its steps at most those of the decimals, and one at least
  //   (3) else both coordinates are rounded to the decimals (rounded_decimal)
  // What is near is decided in doubles. REQUIRES: finite coordinates; surfaces of the scene. COST: linear, in doubles.
  Snap2 at(const Place2& place, const SnapRequest2& request) const;

 private:
  Point2 on_edge(const Edge2& edge, const Place2& place, int decimals) const;

  const Scene2* scene_;
  LocalEdges2 local_;
};

// The same for once.
Snap2 snapped(const Scene2& scene, const Place2& place, const SnapRequest2& request);

}  // namespace hottel
