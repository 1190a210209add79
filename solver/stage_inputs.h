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

// True iff every two materials that acted alike before do now, and no others: materials act alike if they are equal but
// for their names. Then surfaces that overlap own the same places as before, and the arrangement can be shared.
// REQUIRES equally many materials in both.
bool are_alike_as_before(const std::vector<Material>& before, const std::vector<Material>& now);

// The lights but for their power, and where in the file they stand.
std::vector<Light> beams_of(std::vector<Light> lights);

}  // namespace hottel
