// What many points of space see as an unstructured grid of VTK, for ParaView.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "io/results/space/seen_writer.h"

namespace hottel {

// Returns a writer of the pieces of faces that are seen, each a polygon on its face, with these arrays, in binary at
// the end of the file:
//
//   point        int64: the number of the point that sees it
//   face         int32: its face, by its place in `names`
//   solid_angle  float64, of the piece
//
// and beside them, as data of the field, `names`: all faces in order, "sky", "#in NAME" of each solid.
std::unique_ptr<SeenWriter3> seen_vtu_writer(const SeenFileOptions3& options,
                                             std::function<void(std::string_view)> sink);

}  // namespace hottel
