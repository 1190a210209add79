// Polylines on a lattice: boxes, rooms in them, outlines that touch, retrace or cross themselves, boxes without a side.
#pragma once

#include <random>
#include <vector>

#include "tests/storm/plane/lattice_scene.h"

namespace hottel::storm {

// Adds one to three polylines, each drawn from the kinds below, and lets one edge or polyline in five say what is
// behind it, of open polylines every second one.
//
//   boxes           counter-clockwise, solid
//   rooms in boxes  a box or triangle the other way round in a box that holds it, with walls in common or not
//   polygons        three to five random corners: crossing themselves, winding twice, on one line
//   there and back  one or two edges and the same backwards
//   spurs           a box with an edge there and back at a corner
//   rings           a box in a box, one outline joined by a bridge there and back
//   three sides     of a box, open, often with an edge along the fourth
//   walks           of unit steps, closed
//   open            two or three random edges
void add_polylines(std::mt19937_64& random, int k, std::vector<LatticeEdge>& lattice,
                   std::vector<oracle::InputSegment>& edges);

}  // namespace hottel::storm
