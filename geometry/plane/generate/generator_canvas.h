// What the generators draw on: a fixed-point plane.
// Internal to geometry/plane/generate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/generate/chance.h"
#include "geometry/generate/paint.h"
#include "geometry/plane/generate/generator_request.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A point in fixed point: in units, or placed (GeneratorCanvas2::place).
struct Dot2 {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const Dot2&, const Dot2&) = default;
};

// True iff the closed segments ab and cd have a common point; end points count, and a segment may be a point.
// REQUIRES: coordinates below 2^61 in absolute value; then it is exact.
bool share_a_point(const Dot2& a, const Dot2& b, const Dot2& c, const Dot2& d);

// A scene in the making. Generators think in units of 10^-decimals with all coordinates in [0, extent]. With digits
// asked for, place() moves the scene by a power of ten and adds digits below one unit to each point: points that were
// equal stay equal, and whatever kept a distance of 3 units does not meet.
class GeneratorCanvas2 {
 public:
  // Throws UsageError when the digits asked for cannot hold the extent and one digit more.
  GeneratorCanvas2(const GeneratorRequest2& request, int decimals, std::int64_t extent);

  // A canvas whose points the generator places itself, as multiples of 10^-decimals.
  static GeneratorCanvas2 of_placed_points(const GeneratorRequest2& request, int decimals);

  // Where a point in units comes to lie: fixed point of the finished scene. It depends on the point and the request
  // alone; without digits asked for it is the point itself.
  Dot2 place(const Dot2& unit) const;

  // Both take placed points; edges come before polylines in the scene. An edge is a group of its own, and black behind
  // where no paint is given for its back.
  void add_edge(std::string name, const Dot2& from, const Dot2& to, Paint paint, std::optional<Paint> back = {});
  // The closed polyline through the corners, one group. Its surfaces are "name[0]", "name[1]", ...; backs are black.
  void add_polygon(const std::string& name, const std::vector<Dot2>& corners, Paint paint);

  // Returns the scene, without the materials that nothing uses. REQUIRES: called once, after all the rest.
  Scene2 finish(bool closed);

 private:
  GeneratorCanvas2(const GeneratorRequest2& request, int placed_decimals);
  Edge2 edge(const Dot2& from, const Dot2& to) const;
  Rational coordinate(std::int64_t placed) const;

  std::string about_;
  std::uint64_t seed_;
  std::int64_t offset_ = 0;        // units added to each coordinate
  std::int64_t added_digits_ = 1;  // 10^m for m digits below the unit
  Integer denominator_;
  Scene2 scene_;
  Scene2 polygons_;
};

}  // namespace hottel
