// The vertices of a scene in integer form, and everything that is decided or measured from them.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "geometry/plane/point.h"
#include "kernel/int128.h"
#include "kernel/rational.h"
#include "kernel/rounding.h"
#include "kernel/support/id.h"

namespace hottel {

using VertexId = Id<struct VertexTag>;

// A length in fixed point, in units of Vertices2::fixed_unit().
struct FixedLength2 {
  Int128 value;
  bool is_exact;  // otherwise the real length lies within Vertices2::length_error() of value
};

// The vertices of a scene, translated by the first one and scaled to integers where that keeps them small.
//
//   (1) every predicate has the sign of the exact one, whatever the coordinates
//   (2) predicates, lengths and all that follows from them are invariant under translation and scaling of the scene
//   (3) distance(i, j) == distance(j, i), and equals distance(k, l) when the integer coordinate differences agree
//
// Small form: every coordinate is an integer below 2^60; exact arithmetic is 128-bit. Large form: big rationals with
// double-double approximations; the same filters, a slower exact step.
// COST: orientation about 3 ns when the filter decides; distance about 15 ns.
class Vertices2 {
 public:
  Vertices2() = default;
  // The points are scaled by the least common denominator of all of them when the result has the small form, else by
  // that of the first `typed` ones (those that were typed, not constructed).
  Vertices2(const std::vector<Point2>& points, std::size_t typed);

  std::size_t size() const { return approximate_.size(); }
  IdRange<VertexId> ids() const { return IdRange<VertexId>(size()); }
  bool is_small() const { return !small_.empty() || size() == 0; }

  // Sign of the area of the triangle i j k: +1 counter-clockwise, -1 clockwise, 0 collinear or where two are one
  // point. It is the same for j k i and the opposite for i k j.
  int orientation(VertexId i, VertexId j, VertexId k) const {
    const Approximate &p = approximate_[i.index()], &q = approximate_[j.index()], &r = approximate_[k.index()];
    const double ax = q.x - p.x, ay = q.y - p.y, bx = r.x - p.x, by = r.y - p.y;
    const double left = ax * by, right = ay * bx, determinant = left - right;
    const double bound =
        kOrientationError * (std::fabs(left) + std::fabs(right)) +
        input_error_ * (std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by) + 2 * input_error_);
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exact_orientation(i, j, k);
  }

  // True iff vertex k, collinear with i and j, lies strictly between them. REQUIRES orientation(i, j, k) == 0.
  bool is_between(VertexId i, VertexId j, VertexId k) const;

  // Sign of the scalar product (j - i) . (k - i): 0 also where j or k is i.
  int direction_sign(VertexId i, VertexId j, VertexId k) const;

  // Where vertex l lies of the circle through the counter-clockwise triangle i j k: +1 inside, -1 outside, 0 on it.
  int side_of_circle(VertexId i, VertexId j, VertexId k, VertexId l) const;

  // Sign of the difference of exact coordinates, i minus j.
  int compare_x(VertexId i, VertexId j) const;
  int compare_y(VertexId i, VertexId j) const;
  // Lexicographic order of exact coordinates.
  bool precedes(VertexId i, VertexId j) const;

  // The length from i to j, in units of fixed_unit(), off by at most length_error() of them. Only the small form has
  // exact ones: those whose length in integer form is an integer.
  FixedLength2 distance(VertexId i, VertexId j) const;
  double length_error() const { return length_error_; }

  // Chooses the fixed-point unit so that any sum of lengths up to this many times the largest coordinate fits. Lengths
  // measured before it are in another unit.
  void set_total_length(double diameters);

  // Exact values in integer form.
  Point2 exact(VertexId i) const;
  Rational squared_distance(VertexId i, VertexId j) const;

  // Coordinates in integer form divided by 2^k for some k, each within approximation_error() of the exact one.
  struct Approximate {
    double x, y;
  };
  const Approximate& approximate(VertexId i) const { return approximate_[i.index()]; }
  double approximation_error() const { return input_error_; }

  // Every coordinate in integer form is below 2^exponent() in absolute value.
  int exponent() const { return coordinate_bits_; }

  // scene coordinate = origin + scale * integer form
  const Rational& scale() const { return scale_; }
  const Point2& origin() const { return origin_; }
  Point2 to_scene(const Point2& integer_form) const;
  Point2 from_scene(const Point2& point) const;

  // One unit of FixedLength2::value, in integer form.
  Rational fixed_unit() const;

 private:
  friend class EyeCoordinate2;
  friend class Eye2;
  friend class EyeLine2;
  friend class EyeTile2;
  friend class VertexEye2;
  struct Small {
    std::int64_t x, y;
  };
  struct Low {
    double x, y;
  };
  // Rounding of the differences, products and their difference: (3 + 16 u) u with u = 2^-53 (Shewchuk 1997, 4.1).
  static constexpr double kOrientationError = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;

  // Where all coordinates are doubles they are read where predicates have read them already.
  Small small(VertexId i) const {
    const Approximate& p = approximate_[i.index()];
    return input_error_ == 0 ? Small{static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)}
                             : small_[i.index()];
  }
  void set_small(std::span<const std::int64_t> coordinates);
  void scale_big(const std::vector<Point2>& points, std::size_t typed);
  int exact_orientation(VertexId i, VertexId j, VertexId k) const;
  FixedLength2 small_distance(VertexId i, VertexId j) const;
  FixedLength2 large_distance(VertexId i, VertexId j) const;

  std::vector<Approximate> approximate_;
  int coordinate_bits_ = 0;      // every |coordinate| in integer form is below 2^this
  double input_error_ = 0;       // twice the error of an approximate coordinate, rounded up
  double error_anywhere_ = 0;    // of any approximate determinant of three of them
  std::vector<Small> small_;     // small form
  std::vector<Point2> large_;    // large form
  std::vector<Low> low_;         // large form: what approximate_ leaves out
  int approximation_shift_ = 0;  // approximate_ = integer form / 2^shift
  int fixed_bits_ = 0;           // unit of a fixed length = 2^-fixed_bits_ of approximate_'s unit
  double length_error_ = 2;
  Rational scale_ = 1;
  Point2 origin_;
};

// A vertex to look from: the same signs, from the differences to it, which the caller keeps.
class VertexEye2 {
 public:
  // From the eye to a vertex.
  struct Ray {
    VertexId vertex;
    double x, y;
  };

  // REQUIRES: the vertices outlive the eye.
  VertexEye2(const Vertices2& vertices, VertexId at)
      : vertices_(&vertices),
        approximate_(vertices.approximate_.data()),
        at_(at),
        x_(approximate_[at.index()].x),
        y_(approximate_[at.index()].y),
        error_(vertices.error_anywhere_) {}

  Ray ray(VertexId j) const {
    const Vertices2::Approximate& p = approximate_[j.index()];
    return {j, p.x - x_, p.y - y_};
  }

  // Sign of the area of the triangle eye, j, k, exactly. COST: about 1 ns where any determinant as large has that sign.
  int orientation(const Ray& j, const Ray& k) const {
    const double determinant = j.x * k.y - j.y * k.x;
    if (determinant > error_) return 1;
    if (determinant < -error_) return -1;
    return vertices_->orientation(at_, j.vertex, k.vertex);
  }
  // True iff orientation(j, k) > 0: for those who ask no more it is faster.
  bool turns_left(const Ray& j, const Ray& k) const {
    const double determinant = j.x * k.y - j.y * k.x;
    return determinant > error_ || (determinant >= -error_ && vertices_->orientation(at_, j.vertex, k.vertex) > 0);
  }

 private:
  const Vertices2* vertices_;
  const Vertices2::Approximate* approximate_;
  VertexId at_;
  double x_, y_, error_;
};

// One coordinate of a point to look from, prepared once for all the points that share it.
class EyeCoordinate2 {
 public:
  // The value is given in integer form.
  EyeCoordinate2(const Vertices2& vertices, const Rational& value);
  const Rational& exact() const { return exact_; }

 private:
  friend class Eye2;
  friend class EyeLine2;
  friend class EyeTile2;
  Rational exact_;
  double approximate_, error_;
  std::int64_t numerator_ = 0, denominator_ = 0;  // when 128 bits suffice for a product of two differences, else 0
};

// A point to look from that need not be a vertex: the same predicates with the eye as first point.
class Eye2 {
 public:
  // The point is given in integer form. REQUIRES: the vertices outlive the eye.
  Eye2(const Vertices2& vertices, const Point2& point);
  // REQUIRES that both coordinates outlive the eye. COST: a few ns.
  Eye2(const Vertices2& vertices, const EyeCoordinate2& x, const EyeCoordinate2& y)
      : vertices_(&vertices),
        exact_x_(&x),
        exact_y_(&y),
        x_(x.approximate_),
        y_(y.approximate_),
        error_(x.error_ > y.error_ ? x.error_ : y.error_) {}

  // Sign of the area of the triangle eye j k, exactly.
  int orientation(VertexId j, VertexId k) const {
    const auto &q = vertices_->approximate_[j.index()], &r = vertices_->approximate_[k.index()];
    const double ax = q.x - x_, ay = q.y - y_, bx = r.x - x_, by = r.y - y_;
    const double left = ax * by, right = ay * bx, determinant = left - right;
    const double bound = Vertices2::kOrientationError * (std::fabs(left) + std::fabs(right)) +
                         error_ * (std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by) + 2 * error_);
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exact_orientation(j, k);
  }

  // Sign of the scalar product (j - eye) . (k - eye).
  int direction_sign(VertexId j, VertexId k) const;
  bool coincides_with(VertexId j) const;
  Point2 exact() const { return {exact_x_->exact_, exact_y_->exact_}; }
  double x() const { return x_; }
  double y() const { return y_; }

 private:
  friend class EyeLine2;
  Eye2(const Vertices2& vertices, std::shared_ptr<const std::pair<EyeCoordinate2, EyeCoordinate2>> own);
  int exact_orientation(VertexId j, VertexId k) const;

  std::shared_ptr<const std::pair<EyeCoordinate2, EyeCoordinate2>> own_;  // unless they are somebody else's
  const Vertices2* vertices_;
  const EyeCoordinate2 *exact_x_, *exact_y_;
  double x_, y_, error_;
};

}  // namespace hottel
