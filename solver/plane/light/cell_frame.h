// A grid and a scene in the coordinates of the grid: cells are one wide, the first corner is the origin.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/int128.h"

namespace hottel {

// A point or vector whose coordinates are good to about 2^-104 of the largest number that went into them: sums of two
// doubles, of which the first is the rounded coordinate.
struct FinePoint2 {
  DoubleDouble x, y;
};
FinePoint2 operator-(const FinePoint2& a, const FinePoint2& b);
inline FinePoint2 operator-(const FinePoint2& a) { return {{-a.x.hi, -a.x.lo}, {-a.y.hi, -a.y.lo}}; }
inline constexpr double kFine = 0x1p-102;  // more than the relative error of a coordinate or of a difference

// What CellFrame2::direction is good to, relative to its length.
inline constexpr double kDirection = 0x1p-80;

// A vector in doubles; every operation rounds.
struct Vector2 {
  double x, y;
  friend Vector2 operator+(const Vector2& a, const Vector2& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector2 operator-(const Vector2& a, const Vector2& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector2 operator*(double t, const Vector2& a) { return {t * a.x, t * a.y}; }
};
// Positive when b points to the left of a; the cosine of their angle times both lengths; the leading
// doubles of a point.
inline double cross(const Vector2& a, const Vector2& b) { return a.x * b.y - a.y * b.x; }
inline double dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }
inline Vector2 rounded(const FinePoint2& p) { return {p.x.hi, p.y.hi}; }
inline double size_of(const FinePoint2& p) { return std::fabs(p.x.hi) + std::fabs(p.y.hi); }

// The places of vertices and cells: x counts columns, so that cells are one wide, and y has the same unit.
//
//   (1) every coordinate of a vertex is within kFine of the real one, relative to the largest number that went into it
//   (2) scaling or moving scene and grid together changes nothing but roundings within these errors
// COST: 32 bytes a vertex; directions of vertices near each other, or far away, are made from exact differences.
class CellFrame2 {
 public:
  // REQUIRES that the vertices outlive it.
  CellFrame2(const Vertices2& vertices, const Grid2& grid);

  const FinePoint2& vertex(VertexId v) const { return places_[v.index()]; }
  // A vector of any length from a to b, good to kDirection of its length: near each other or far from the grid, too.
  // REQUIRES two vertices at different places.
  FinePoint2 direction(VertexId a, VertexId b) const;
  // The middle of a cell; row 0 is the lowest. REQUIRES ix < nx() and iy < ny().
  FinePoint2 centre(std::uint32_t ix, std::uint32_t iy) const { return {{ix + 0.5, 0}, rows_[iy]}; }
  double height() const { return height_.hi; }  // of a cell, rounded
  std::uint32_t nx() const { return nx_; }
  std::uint32_t ny() const { return static_cast<std::uint32_t>(rows_.size()); }
  double extent() const { return extent_; }  // at least |x| + |y| of every place in the grid

 private:
  std::uint32_t nx_;
  DoubleDouble height_;
  std::vector<DoubleDouble> rows_;
  const Vertices2& vertices_;
  std::vector<FinePoint2> places_;
  double extent_;
};

}  // namespace hottel
