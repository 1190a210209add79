// Scenes of convex bodies on a small lattice, whole and open, and of sheets at them.
#pragma once

#include <cstdint>

#include "tests/storm/space/lattice_scene.h"

namespace hottel::storm {

// Returns a scene by its number: any number gives the same on every platform. The polygon to look from, from both of
// its sides, is polygon 0. Two to seven bodies: boxes, wedges, pyramids, tetrahedra, prisms over polygons of up to
// eight sides; on a ground that is not cut or floating, beside, on and in each other, so that they touch in faces,
// edges and corners, or pierce. What would share an area of a plane with what is there is left out; so is of some
// bodies one face, at the bottom, a side or the top, or two; a face is split, or has a hole, and any may be turned
// over. Sheets lie on faces and beside them, pierce bodies, stand in them, below what is open and in its plane. Some
// bodies are turned, and some scenes; some bodies are moved by 2^-8 to 2^-60. One scene in
// sixteen is a town of twelve to twenty-five bodies, and one in seven is pressed flat.
Polygons3 hiding_scene_3(std::uint64_t number);

}  // namespace hottel::storm
