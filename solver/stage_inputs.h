// What stages of a simulation compare of a scene, whatever its dimension.
#pragma once

#include <vector>

#include "geometry/material.h"
#include "geometry/scene_table.h"

namespace hottel {

// Spectra that say the same and were given alike: whether one is a scalar decides how many channels there are.
struct Spectra {
  std::vector<Spectrum> values;
  friend bool operator==(const Spectra& a, const Spectra& b);
};

// Of the lights of a scene.
Spectra powers_of(const SceneTable& scene);
// Of its materials and its sky: all that radiosities depend on but for lights and reflectivities.
Spectra emissions_of(const SceneTable& scene);

// The lights but for their power, and where in the file they stand.
std::vector<Light> beams_of(std::vector<Light> lights);

}  // namespace hottel
