// The generators, one function a kind of scene. Internal to geometry/plane/generate.
#pragma once

#include "geometry/plane/generate/generator_request.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Each returns the scene that generate_2() says, with the properties listed there; generate_2() is what others call.
//
// REQUIRES: the number of edges is within the limits of the kind (generator_kinds_2), and 0 <= digits <=
// kMaxGeneratedDigits. More may be refused: each throws UsageError where it cannot obey the request.
Scene2 generate_room_2(const GeneratorRequest2& request);
Scene2 generate_clutter_2(const GeneratorRequest2& request);
Scene2 generate_lattice_2(const GeneratorRequest2& request);
Scene2 generate_maze_2(const GeneratorRequest2& request);
Scene2 generate_comb_2(const GeneratorRequest2& request);
Scene2 generate_star_2(const GeneratorRequest2& request);
Scene2 generate_pillars_2(const GeneratorRequest2& request);
Scene2 generate_plates_2(const GeneratorRequest2& request);

}  // namespace hottel
