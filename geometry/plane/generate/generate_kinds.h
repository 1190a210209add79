// The generators, one function a kind of scene. Internal to geometry/plane/generate.
#pragma once

#include "geometry/plane/generate/generator_request.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// As generate_2() says, for a request whose number of edges and digits are within the limits of the kind.
Scene2 generate_room_2(const GeneratorRequest2& request);
Scene2 generate_clutter_2(const GeneratorRequest2& request);
Scene2 generate_lattice_2(const GeneratorRequest2& request);
Scene2 generate_maze_2(const GeneratorRequest2& request);
Scene2 generate_comb_2(const GeneratorRequest2& request);
Scene2 generate_star_2(const GeneratorRequest2& request);
Scene2 generate_pillars_2(const GeneratorRequest2& request);
Scene2 generate_plates_2(const GeneratorRequest2& request);

}  // namespace hottel
