// What many points of space see as NumPy's .npz: arrays that numpy.load finds by name.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "io/results/space/seen_writer.h"

namespace hottel {

// Returns a writer of these arrays, for n points that see N faces in all; with pieces P of them of C corners:
//
//   xyz           float64, n x 3: the points
//   begin         int64, n + 1: what point k sees is begin[k] .. begin[k + 1] - 1
//   face          int32, N: what is seen, as an index into names
//   solid_angle   float64, N
//   names         text: all faces in order, "sky", "#in NAME" of each solid
//   solid         int32, n: the solid that a point is in, as an index into names; -1 in the open
//   piece_begin   int64, N + 1: the pieces of that face; none of the sky
//   corner_begin  int64, P + 1: the corners of a piece, in order around it
//   direction     float64, C x 3: unit vectors from the point
//   place         float64, C x 3: where they meet the face
std::unique_ptr<SeenWriter3> seen_npz_writer(const SeenFileOptions3& options,
                                             std::function<void(std::string_view)> sink);

}  // namespace hottel
