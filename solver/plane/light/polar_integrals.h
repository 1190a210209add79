// Areas, and integrals of the direction in which a point is seen, over a cell and parts of it.
#pragma once

#include <array>

#include "solver/plane/light/cell_frame.h"

namespace hottel {

// A convex part of a cell that is one wide; corners counter-clockwise, relative to the centre of the cell.
class CellPart2 {
 public:
  explicit CellPart2(double height);
  // Keeps what lies where at_centre + gradient . offset >= 0; size() is 0 once nothing is left. At most three cuts.
  void cut(double at_centre, const Vector2& gradient);

  int size() const { return size_; }
  const Vector2& operator[](int k) const { return corner_[static_cast<std::size_t>(k)]; }

 private:
  std::array<Vector2, 8> corner_;
  int size_ = 4;
};

// The integrals over a region of 1 and of the polar angle, measured from a unit vector `axis`, of a point z + offset,
// where z is the centre of the cell seen from the pole. They are elementary (docs/design/plane/illumination.md).
//                                                                          [unit: area of a cell that is one wide]
// REQUIRES that the region lies within a right angle about the axis, seen from the pole.
struct AreaAndAngle2 {
  double area = 0, angle = 0;
};

// These integrals for the cells of one grid, all of one height.
//
//   (1) areas and angles are within area_error() and angle_error() of the real ones, in units of 2^-53, for the
//       corners as they are
//   (2) near the pole each edge has a closed form; elsewhere series of kTerms terms are used
class PolarIntegrals2 {
 public:
  explicit PolarIntegrals2(double height);

  // Over the whole cell, and over a part of it. Near the pole by closed forms for each edge, else by series in offset /
  // z, of kTerms terms.
  // REQUIRES of over() that the part is not empty.
  AreaAndAngle2 over_cell(const Vector2& z, const Vector2& axis) const;
  AreaAndAngle2 over(const CellPart2& part, const Vector2& z, const Vector2& axis) const;

  // Bounds on the errors of over(), in units of 2^-53, when the corners are taken as they are. That of over_cell() is
  // 12 of its area when it is not near.
  double area_error() const { return 32 * radius_ * radius_; }
  double angle_error(const Vector2& z) const;

  // Whether the pole is within kFar radii of the centre of the cell.
  bool is_near(const Vector2& z) const { return dot(z, z) <= kFar * kFar * radius_ * radius_; }
  double radius() const { return radius_; }  // half the diagonal of a cell

 private:
  static constexpr int kTerms = 6;
  static constexpr double kFar = 16;  // radii; nearer to the pole the series are not used

  double height_, radius_;
  std::array<double, kTerms> moments_;  // means of offset^2k / 2k over the cell, k = 1, 2, ...
};

}  // namespace hottel
