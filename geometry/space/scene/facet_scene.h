// Scenes with the triangles of their nearly plane polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// A scene of which each nearly plane polygon is replaced by its facets: surfaces of its name, its group and its
// materials, in its place. surface_of[f] is the surface of the first scene that surface f is one of; it ascends.
//
//   (1) all polygons are plane; names are not unique
struct FacetScene3 {
  Scene3 scene;
  std::vector<std::uint32_t> surface_of;
};

// Returns nothing where all polygons are plane: then the scene is its own.
std::optional<FacetScene3> facet_scene(const Scene3& scene);

}  // namespace hottel
