// The lights of a scene in space where they arrive first.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "solver/space/light/direct_light.h"

namespace hottel {

// All lights of a scene as they stand, each with its power by channel, a sun with its irradiance.
//
// REQUIRES that the scene outlives it. COST: an exact map a light; nothing without lights.
class SceneLights3 {
 public:
  struct Lamp {
    std::unique_ptr<const DirectLight3> light;
    std::array<double, 3> power;
  };
  explicit SceneLights3(const PreparedScene3& prepared);

  const std::vector<Lamp>& lamps() const { return lamps_; }
  // Adds the direct mean irradiance at a point to `result`, one place a channel.
  void add(const Point3& point, std::span<double> result) const;
  // Adds the direct irradiance of a surface at a point whose front has this normal.
  void add(const Point3& point, const Vector3& normal, std::span<double> result) const;

 private:
  std::vector<Lamp> lamps_;
};

}  // namespace hottel
