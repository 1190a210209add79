// The generators, one function a kind of scene. Internal to geometry/plane/generate.
#pragma once

#include "geometry/plane/generate/generator_request.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// As generate_2() says, for a request whose number of edges and digits are within the limits of the kind.
Scene2 generate_room(const GeneratorRequest& request);
Scene2 generate_clutter(const GeneratorRequest& request);
Scene2 generate_lattice(const GeneratorRequest& request);
Scene2 generate_maze(const GeneratorRequest& request);
Scene2 generate_comb(const GeneratorRequest& request);
Scene2 generate_star(const GeneratorRequest& request);
Scene2 generate_pillars(const GeneratorRequest& request);
Scene2 generate_plates(const GeneratorRequest& request);

}  // namespace hottel
