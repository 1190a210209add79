// What is left of faces once solids and overlaps have taken their parts, as edges to be drawn.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "viewer/picture/plane/corners.h"

namespace hottel {

// The straight parts of faces that exchange light: a part that looks into a solid, or that another surface owns, is
// missing.
//
//   (1) the runs of a surface, those of its front before those of its back
//   (2) edge k of corners() is run k, the face on its right
class FaceRuns2 {
 public:
  FaceRuns2(const PreparedScene2& prepared, const Frame2& frame);

  const Corners2& corners() const { return corners_; }
  std::uint32_t begin(std::uint32_t surface) const { return begin_[surface]; }
  std::uint32_t end(std::uint32_t surface) const { return begin_[surface + 1]; }
  const Face& face(std::uint32_t run) const { return face_[run]; }

 private:
  Corners2 corners_;
  std::vector<std::uint32_t> begin_;  // by surface
  std::vector<Face> face_;            // by run
};

}  // namespace hottel
