// What writes visibility polygons of many points, whatever the format.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

// What all polygons of a file have in common.
struct PolygonFileOptions2 {
  bool is_exact = false;                        // write RoundedPolygon2::exact: csv instead of, GeoJSON beside doubles
  std::optional<Rational> range = {};           // the polygons are those within this range
  std::vector<std::string> channel_names = {};  // of the mean irradiance that is written with each; none: none is
};

// Some polygons that follow each other: where from, what is seen, and the mean irradiance by channel (empty without).
struct PolygonBatch2 {
  std::span<const Point2> eyes;
  std::span<const RoundedPolygon2> polygons;
  std::span<const std::vector<double>> irradiance;
};

// Writes polygons in the order of their points, which are numbered from 0. docs/visibility_files.md says what stands
// where.
//
//   (1) what has been added is written, except in .npz: that is held until the end
//   (2) a side is called by the name of the face that is seen, "" along a ray from the point, "sky" where it is open,
//       "#range" along an arc; a point in a solid has no corners, and "#in NAME" is told
//   (3) an unbounded region is never closed: GeoJSON and well-known text have the lines that bound it
//
// Throws RequestError where a corner is beyond the range of doubles (unless a csv is exact).
class PolygonWriter2 {
 public:
  virtual ~PolygonWriter2() = default;
  virtual void add(const PolygonBatch2& batch) = 0;
  virtual void finish() = 0;
};

}  // namespace hottel
