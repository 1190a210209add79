// A map of what a point sees against the brute force, ray by ray.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/visibility/visibility_map.h"
#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// The polygons as the engine takes them.
std::vector<Polygon3> engine_polygons(const std::vector<SpacePolygon>& polygons);

struct DartCounts {
  std::uint64_t darts = 0;      // compared
  std::uint64_t ambiguous = 0;  // through an edge: not compared
};

// Throws `count` darts from the eye in directions of random integers, half of them close to corners of fragments, and
// returns what is wrong first, or an empty text: each dart must be strictly inside exactly one fragment, of the polygon
// that the brute force meets first, on the right side of it; inside none where it meets nothing, or where the dart is
// below the horizon. Everything is decided in rationals, from the polygons and the definitions of the planes alone.
std::string dart_disagreement(const std::vector<SpacePolygon>& polygons, const Look3& look, const VisibilityMap3& map,
                              std::uint64_t seed, int count, DartCounts& counts);

}  // namespace hottel::oracle
