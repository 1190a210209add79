// What the wedges of a vertex add to the light in the cells of a grid.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "solver/plane/light/cell_frame.h"
#include "solver/plane/light/face_radiosity.h"
#include "solver/plane/light/vertex_wedges.h"

namespace hottel {

// A line that cuts cells, and how well one knows where: the signed distance from it, positive on the left of its
// direction, in the unit of a frame.
//
//   (1) at() is within doubt() of the real distance, up to eight roundings of the distance itself
//   (2) doubt() grows with the distance of the point from the grid
class CutLine2 {
 public:
  CutLine2() = default;
  // The line through a point in a direction, which is known to kDirection of its length. REQUIRES a
  // direction of some length.
  CutLine2(const FinePoint2& point, const FinePoint2& direction, const CellFrame2& frame);

  double at(const FinePoint2& place) const;  // REQUIRES a place in the grid
  double doubt() const { return doubt_; }
  // The unit vector along which the distance grows: to the left of the line, rounded.
  const Vector2& gradient() const { return gradient_; }

  // Half the extent of a cell across the line: how far a corner of a cell may lie beyond its centre.
  double support() const { return support_; }
  // +1: a whole cell certainly lies left of the line, -1: right of it, 0: neither is certain. By plain doubles; the
  // same for the same line and cell, always. centre: of the cell, rounded.
  int side_of_cell(const Vector2& centre) const {
    const double rough = dot(gradient_, centre - rounded(point_));
    return rough > rough_support_ ? 1 : rough < -rough_support_ ? -1 : 0;
  }

 private:
  FinePoint2 point_, direction_;
  double inverse_length_ = 0, doubt_ = 0, support_ = 0, rough_support_ = 0;
  Vector2 gradient_{0, 0};
};

// A wedge in the coordinates of a grid. A point in it that sees the apex in the direction angle (from the axis) owes to
// the apex constant + slope * angle, per channel: what this means is said in docs/design/plane/illumination.md.
struct LitWedge2 {
  Vector2 axis;               // the diagonal of the wedge's quadrant
  std::uint32_t right, left;  // of LitWedges2::rays
  bool is_joined = false;     // the wedge before this one lies on the other side of the right ray, in the same quadrant
  bool is_ended = true;
  CutLine2 end;        // positive on the apex's side
  Vector2 corners[3];  // of the triangle, each within margin; far outside the grid where nothing ends it
  double margin = 0;
  double doubt = 0;                // error of any constant
  std::uint32_t coefficients = 0;  // of LitWedges2: constant and slope by channel
};

// The wedges of one vertex that add anything, counter-clockwise.
//
//   (1) two wedges of a quadrant next to the same faces have the same coefficients
//   (2) what is told of a wedge is within margin, doubt and rough_doubt of the real one; they bound the errors of
//       places, of constants and of differences from the apex, and enter the error of every cell (CellSums2)
//   (3) a wedge that would add less than its doubt anywhere, or adds the same as its neighbours, is still listed: none
//       is left out but those counted in `lost`
struct LitWedges2 {
  FinePoint2 apex;
  double rough_doubt = 0;      // a difference from the apex in doubles is known within this
  std::vector<CutLine2> rays;  // positive on the left
  std::vector<LitWedge2> wedges;
  std::vector<double> coefficients;
  double lost = 0;  // largest values of wedges that cannot be placed in the grid, summed: each cell may lack that much
};

// Finds the wedges of vertices. Threads may share one. REQUIRES that arrangement, radiosities and frame outlive it.
// COST: one sweep about the vertex; `result` is filled anew and its memory used again.
class WedgeLighting2 {
 public:
  WedgeLighting2(const Arrangement2& arrangement, const FaceRadiosity2& radiosity, const CellFrame2& frame)
      : arrangement_(arrangement), radiosity_(radiosity), frame_(frame) {}

  // Fills `result` with the wedges of v. Left out are those that lie in solids and those of which both sides send what
  // the sky sends: they add nothing. Wedges whose lines are not known to a quarter of a cell are counted in `lost`.
  void find(VertexId v, LitWedges2& result) const;

 private:
  FinePoint2 direction(VertexId v, const VertexRay2& ray) const;
  std::uint32_t add_ray(VertexId v, const VertexRay2& ray, LitWedges2& result) const;
  void place_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const;
  void place_without_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const;
  void shade(const Wedge2& wedge, LitWedge2& lit, std::vector<double>& coefficients) const;
  double angle_to_axis(PieceSideId side, const Vector2& axis, double& doubt) const;
  double largest_value(const Wedge2& wedge) const;
  bool sends_like_the_sky(PieceSideId side) const { return radiosity_.shade(side) == radiosity_.shade(kSky); }

  const Arrangement2& arrangement_;
  const FaceRadiosity2& radiosity_;
  const CellFrame2& frame_;
};

}  // namespace hottel
