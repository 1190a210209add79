// Where the edges and faces of a scene lie in a picture, and which of them meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/face.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/frame.h"

namespace hottel {

// The end points of all surfaces, equal ones once.
//
//   (1) from[i] == to[j] exactly when surface i begins at the very point where j ends: decided on the exact coordinates
//   (2) at[from[i]] is where surface i begins in the picture
struct Corners2 {
  std::vector<Pixel> at;
  std::vector<std::uint32_t> from, to;  // per surface

  Corners2() = default;
  // Edge k of the corners is surface k. COST: O(n log n).
  Corners2(const Scene2& scene, const Frame2& frame);

  std::size_t surfaces() const { return from.size(); }
};

// The straight parts of faces, or of elements, that exchange light: a part that looks into a solid, or that another
// surface owns, is missing.
//
//   (1) the runs of a surface, those of its front before those of its back, are begin(surface) to end(surface) - 1
//   (2) edge k of corners() is run k, the face on its right
class FaceRuns2 {
 public:
  // REQUIRES a granularity that is not kGroup; a scene prepared by elements where it is kElement.
  FaceRuns2(const PreparedScene2& prepared, const Frame2& frame, Granularity granularity = Granularity::kFace);

  const Corners2& corners() const { return corners_; }
  std::uint32_t begin(std::uint32_t surface) const { return begin_[surface]; }
  std::uint32_t end(std::uint32_t surface) const { return begin_[surface + 1]; }
  const Face& face(std::uint32_t run) const { return face_[run]; }
  std::uint32_t element(std::uint32_t run) const { return element_[run]; }  // of elements()
  const std::vector<Element>& elements() const { return elements_; }        // those of ElementTable2

 private:
  Corners2 corners_;
  std::vector<std::uint32_t> begin_;  // by surface
  std::vector<Face> face_;            // by run
  std::vector<std::uint32_t> element_;
  std::vector<Element> elements_;
};

}  // namespace hottel
