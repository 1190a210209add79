// Faces as files hold them that know no patches.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "geometry/space/scene/patches.h"

namespace hottel {

// What patches leave of the faces of a scene, for files that may round the corners.
//
//   (1) polygons of a face share no area; together they are what beside_patches leaves of it
//   (2) where a file holds all corners of patches and of what they lie on as they are, they are those of
//       beside_patches, as they are where no patch lies. Surfaces that lie on each other stay as they are where each of
//       them can
//   (3) else they are triangles. Where a front and a back are written, of a patch and of what it lies on, both have the
//       same triangles, with the same corners: wherever these are rounded to, the two lie back to back
//   (4) and their corners are corners of all polygons of the scene in whose sides they lie, but for those left: what
//       closes before they are rounded does so after it. Other polygons stay whole
//
// REQUIRES that the scene of the carriers outlives this. COST: a PlaneTriangulation3 for each plane of patches that lie
// on each other; where something is rounded, n log n for all sides.
class PatchedFaces3 {
 public:
  using Holds = std::function<bool(const Point3& point)>;  // whether a file has a point as it is
  using Leaves =
      std::function<bool(std::uint32_t surface)>;  // whether a surface can stay as it is, with what lies on it
  PatchedFaces3(const PatchCarriers3& carriers, const Holds& holds, const Leaves& leaves = {});

  std::vector<Polygon3> of(const Face& face) const;
  // Whether a surface is cut into more than its patches leave of it: (3), (4).
  bool cuts(std::uint32_t surface) const { return is_cut_[surface] != 0; }
  // Whether a surface is a patch or has some, and all that lies on each other there is left as it is.
  bool leaves(std::uint32_t surface) const { return is_left_[surface] != 0; }

 private:
  struct Part;
  void cut(const std::vector<std::uint32_t>& surfaces, const Holds& holds);
  void cut_plane(const std::vector<Part>& parts, std::map<std::uint32_t, std::vector<Polygon3>>& pieces) const;
  void share_corners();

  const PatchCarriers3* carriers_;
  std::map<std::uint32_t, std::vector<Polygon3>> pieces_;  // by Face::number(), of what is cut otherwise
  std::vector<char> is_cut_, is_left_;                     // by surface: by this, not by beside_patches; as it is
  std::vector<Point3> rounded_;                            // corners of these
};

}  // namespace hottel
