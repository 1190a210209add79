// What a wedge of a vertex adds to the light in the cells of a grid.
#pragma once

#include <span>
#include <vector>

#include "geometry/arrangement/arrangement_2.h"
#include "solver/illumination/cell_frame_2.h"
#include "solver/illumination/face_radiosity_2.h"
#include "solver/illumination/vertex_wedges_2.h"

namespace hottel {

// A wedge in the coordinates of a grid. A point in it that sees the apex in the direction angle (from the axis) owes to
// the apex constant + slope * angle, per channel: what this means is said in docs/design/illumination_2.md.
struct LitWedge2 {
  FinePoint2 apex;
  Vector2 axis;        // a unit vector in the wedge
  CutLine2 lines[3];   // the wedge is where all are positive
  int line_count = 3;  // 2 when nothing ends the wedge
  Vector2 corners[3];  // the triangle, each within margin
  double margin = 0;
  double largest = 0;        // |constant + slope * angle| in any channel
  double largest_slope = 0;  // in any channel
  double sources = 0;        // sum of what the two sides send out beyond the sky, in the channel where it is largest
  double angle_doubt = 0;    // error of the constant angles, in radians
  std::uint32_t coefficients = 0;  // of LitWedges2: constant and slope by channel
};

// The wedges of some vertices that add anything.
struct LitWedges2 {
  std::vector<LitWedge2> wedges;
  std::vector<double> coefficients;
  double lost = 0;  // sum of `largest` over wedges that cannot be placed in the grid: each cell may lack that much

  void clear();
};

// Appends the wedges of vertex v. Scratch space is kept between calls.
class WedgeLighting2 {
 public:
  WedgeLighting2(const Arrangement2& arrangement, const FaceRadiosity2& radiosity, const CellFrame2& frame)
      : arrangement_(arrangement), radiosity_(radiosity), frame_(frame) {}

  void append(VertexId v, LitWedges2& result) const;

 private:
  FinePoint2 direction(VertexId v, const VertexRay2& ray, double& size) const;
  bool place(VertexId v, const Wedge2& wedge, LitWedge2& lit) const;
  bool place_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const;
  void shade(const Wedge2& wedge, LitWedge2& lit, std::vector<double>& coefficients) const;
  double angle_to_axis(PieceSideId side, const Vector2& axis, double& doubt) const;
  bool sends_like_the_sky(PieceSideId side) const { return radiosity_.shade(side) == radiosity_.shade(kSky); }

  const Arrangement2& arrangement_;
  const FaceRadiosity2& radiosity_;
  const CellFrame2& frame_;
};

}  // namespace hottel
