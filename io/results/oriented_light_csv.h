// The light at points on small areas, as csv.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/external/oriented_points.h"
#include "solver/radiosity/oriented_light.h"

namespace hottel {

// Writes `point,x,y,nx,ny,irradiance,sky_view_factor,mean_radiant_temperature`, in space with z and nz; of several
// channels `irradiance_r`, ... in place of `irradiance`. Points are numbered from 0.
//
//   (1) numbers are shortest decimals that read back to the same double; coordinates the nearest ones
//   (2) the last columns are empty where there is no light to tell (OrientedLight)
class OrientedLightCsv {
 public:
  OrientedLightCsv(int dimension, const std::vector<std::string>& channel_names,
                   std::function<void(std::string_view)> sink);

  // Some points that follow each other. REQUIRES as many of both, of these channels.
  void add(std::span<const OrientedPoint> points, std::span<const OrientedLight> lights);

 private:
  std::size_t dimension_;
  std::function<void(std::string_view)> sink_;
  std::size_t next_ = 0;
};

}  // namespace hottel
