// Visibility polygons of many points as NumPy's .npz: arrays that numpy.load finds by name.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "geometry/plane/prepared/prepared_scene.h"
#include "io/results/plane/polygon_writer.h"

namespace hottel {

// Returns a writer of these arrays, for n points with N corners in all:
//
//   xy          float64, N x 2: the corners of the first point, of the second, ...
//   begin       int64, n + 1: those of point k are begin[k] .. begin[k + 1] - 1
//   face        int32, N: what is seen after each corner, as an index into names
//   names       text: "" along a ray, "sky", "#range" along an arc, then the faces and solids that are told of, in the
//               order of the scene
//   solid       int32, n: the solid that a point is in, as an index into names; -1 in the open
//   irradiance  float64, n x channels; not there for 0 channels
//   area        float64, n, and `perimeter` alike: of the region; NaN where it is unbounded, or there is none
//
// REQUIRES that the scene outlives it, and polygons within the range, if there is one.
std::unique_ptr<PolygonWriter2> polygon_npz_writer(const PreparedScene2& prepared, std::size_t channels,
                                                   std::optional<Rational> range,
                                                   std::function<void(std::string_view)> sink);

}  // namespace hottel
