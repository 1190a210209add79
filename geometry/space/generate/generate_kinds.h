// The generators, one function a kind of scene. Internal to geometry/space/generate.
#pragma once

#include "geometry/space/generate/generator_request.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Each returns the scene that generate_3() says, with the properties listed there; generate_3() is what others call.
//
// REQUIRES: n is within the limits of the kind (generator_kinds_3).
Scene3 generate_room_boxes_3(const GeneratorRequest3& request);
Scene3 generate_room_stacked_3(const GeneratorRequest3& request);
Scene3 generate_room_touching_3(const GeneratorRequest3& request);
Scene3 generate_room_floating_3(const GeneratorRequest3& request);
Scene3 generate_room_turned_3(const GeneratorRequest3& request);
Scene3 generate_room_piercing_3(const GeneratorRequest3& request);
Scene3 generate_street_blocks_3(const GeneratorRequest3& request);
Scene3 generate_town_3(const GeneratorRequest3& request);
Scene3 generate_terrain_3(const GeneratorRequest3& request);
Scene3 generate_nested_cubes_3(const GeneratorRequest3& request);
Scene3 generate_triangle_soup_3(const GeneratorRequest3& request);
Scene3 generate_furnished_room_3(const GeneratorRequest3& request);
Scene3 generate_flat_3(const GeneratorRequest3& request);
Scene3 generate_lattice_boxes_3(const GeneratorRequest3& request);

}  // namespace hottel
