// What a scene in space looks like before its light is known, and where it has none.
#pragma once

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/scene/scene.h"
#include "viewer/picture/space/element_paint.h"

namespace hottel {

// The light before there are factors: every face receives the mean of what a closed room of these materials holds, a
// little more from above, so that faces are told apart. [unit: that of emissions]
ElementPaint3 light_before_factors_3(const Scene3& scene, const ElementTable3& table);

// Light on the elements of a scene.
struct ElementLight3 {
  const Scene3& scene;
  const ElementTable3& table;
  const ElementPaint3& paint;
};

// Gives faces the light that they had in another scene, by their names: where a face is divided into as many elements,
// element by element, else its mean by area. Where there are other channels nothing changes. light: of the scene and
// table.
void carry_light_3(const ElementLight3& before, const Scene3& scene, const ElementTable3& table, ElementPaint3& light);

// What a scene in which nothing shines is shown in, which is no light: each face as bright as its material and its
// slope make it, in [0, 1]; the sky pale.
ElementPaint3 form_of_3(const Scene3& scene, const ElementTable3& table);

}  // namespace hottel
