// What is worth telling about what solids cover.
#pragma once

#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/check/finding.h"

namespace hottel {

// Kinds: filled-room, covered.
//
//   filled-room   a solid that has whole other groups in its interior (FaceCover2 (3)): one finding a solid, which asks
//                 whether a room was meant
//   covered       a face with a material that looks into solids all along (a warning where it emits); those that a
//                 filled-room tells of left out
Findings2 solid_findings(const Scene2& scene, const FaceCover2& cover);

}  // namespace hottel
