// The mean irradiance at a point: how bright the surroundings are, averaged over all directions.
#pragma once

#include <span>

#include "solver/plane/light/sent_out.h"

namespace hottel {

// Writes (1/2 pi) times the integral over all directions of the radiosity seen there, per channel: the row of the point
// (LightRowFinder2, which says what it is on edges and vertices) times what is sent out (SentOut2::light).
//                                                                                     [unit: that of radiosity]
//   (1) what is seen is decided exactly; the angles are computed in doubles, each good to about 2^-50 turns times the
//       ratio of the scene's extent to the distance of the vertex
//   (2) exactly B where everything seen sends out B; never below the least nor above the largest radiosity seen
//   (3) exactly 0 where nothing but black backs and a dark sky is seen
//   (4) NaN exactly in solids, in the interior of their union, and where the scene is closed and no face with a
//   material
//       is seen
// REQUIRES: location and view are those of the eye; columns and what is sent out are of one table; result has one place
// per channel.
void mean_irradiance(const Vertices2& vertices, const LightColumns2& columns, const SentOut2& sent_out, const Eye2& eye,
                     const Location2& location, const View2& view, std::span<double> result);

}  // namespace hottel
