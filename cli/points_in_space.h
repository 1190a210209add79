// visibility --points of points in space without normals: how large each sees which faces.
#pragma once

#include <string>

#include "cli/streams.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A list of points as it was given, where what they see goes, and whether with its pieces.
struct SeenRequest3 {
  std::string text, name;  // csv, and what messages call it
  std::string out;         // .csv, .npz or .vtu; empty or "-": standard output, csv
  bool has_pieces = false;
  bool has_bounds = false;  // proven ones (PointBounds3); not of a .vtu
};

// Writes what each point sees (SeenWriter3): which faces, by their order, then the sky, and how large. What is seen is
// exact, the numbers are doubles. A point in a solid sees nothing, and one on the border of solids nothing in the
// directions into these. A note says how many points are in solids.
//
// Throws UsageError for other endings, and where pieces are asked of what is no .npz, or bounds of a .vtu; InputError
// for what is no list of points in space, before anything is written. COST: that of a map a point, of an exact one
// where it has bounds; memory does not grow with their number, but for their text.
void write_seen_faces(const SeenRequest3& request, const Scene3& scene, Streams& streams);

}  // namespace hottel
