// The light at a point on a small area that looks some way, and around it.
#pragma once

#include <vector>

namespace hottel {

// What arrives at a point.
//
//   (1) `irradiance`, by channel: on a small area, of what its front sees; that of lights is part of it
//                                                                                     [unit: that of radiosity]
//   (2) `sky_view_factor`: the fraction of what such an area sends out that goes to the sky, by the cosine
//   (3) `mean_irradiance`, by channel: the mean over all directions, whatever way the area looks     [the same unit]
//   (4) NaN, all of them, in solids, and outside closed scenes, where no face with a material is seen
struct OrientedLight {
  std::vector<double> irradiance, mean_irradiance;
  double sky_view_factor = 0;
};

// Returns the mean radiant temperature [K] of a point with this mean irradiance by channel: that of a black enclosure
// in which it would be the same, sigma T⁴. In two bands it is that of the thermal one, of three channels of their mean.
// NaN where the mean irradiance is.
double mean_radiant_temperature(const std::vector<double>& mean_irradiance);

}  // namespace hottel
