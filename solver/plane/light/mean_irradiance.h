// The mean irradiance at a point: how bright the surroundings are, averaged over all directions.
#pragma once

#include <span>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/view.h"
#include "solver/plane/light/face_radiosity.h"

namespace hottel {

// Writes (1/2 pi) times the integral over all directions of the radiosity seen there, per channel.
//                                                                                     [unit: that of radiosity]
//   (1) what is seen is decided exactly; the angles are computed in doubles, each good to about 2^-50 turns times the
//       ratio of the scene's extent to the distance of the vertex
//   (2) exactly B where everything seen sends out B; never negative
//   (3) exactly 0 where nothing but black backs and a dark sky is seen
//   (4) NaN exactly in solids: in the interior of their union
//
// On an edge or vertex the light jumps. There the value is the limit of its mean over ever smaller discs about the
// point: on an edge the mean of the limits from its two sides; at a vertex the mean over the directions from which one
// can approach it. (Every line through the centre of a cell halves it: no side of an edge has the larger part.) One
// approaches through free space only: on the border of a solid the free side alone counts.
//
// REQUIRES: location and view are those of the eye; result has one place per channel.
// COST: one arc tangent for each change of radiosity around the point.
void mean_irradiance(const Vertices2& vertices, const FaceRadiosity2& radiosity, const Eye2& eye,
                     const Location2& location, const View2& view, std::span<double> result);

}  // namespace hottel
