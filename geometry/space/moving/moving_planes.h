// Planes through a point that moves along a line, and the signs of directions beside them. Internal to
// geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/moving/known_zeros.h"
#include "geometry/space/moving/moving_corner.h"
#include "geometry/space/stretches/stretch.h"
#include "geometry/space/vectors/moving_vector.h"
#include "geometry/space/vectors/wide_vector.h"
#include "geometry/space/visibility/eye_plane.h"
#include "kernel/wide_sum.h"

namespace hottel {

struct SightCorner3;

// Signs of directions from a point p(t) = (from + t way) / weight beside planes through it, at one t after another, and
// how far t may move until one of those that were relied on changes.
//
//   (1) every sign is exact, at the very double t
//   (2) each sign is that of a polynomial in t of degree 2 at most: every normal moves at right angles to `way`, so the
//       determinant of three has no cubic term
//   (3) left() and right() say how far all signs that were relied on keep: up to the nearest root on each side, in
//       doubles. A double root changes no sign and is none, by an exact discriminant. Roots that doubles leave
//       uncertain beyond 2^-46 of the stretch, or 2^-50 where the point passes the plane of a body, are those of two
//       linear factors, where it has these, or are found from integers
//   (4) a zero that is relied on is one for every t, or is_unlucky() says that it is not: then nothing holds, and
//       another t is to be taken
//
// The planes of a pair have numbers that hold for all its stretches. For one thread.
class MovingPlanes3 {
 public:
  explicit MovingPlanes3(const PairGeometry3& bodies);

  const PairGeometry3& bodies() const { return bodies_; }

  // Takes another line. REQUIRES: it outlives this, or the next call.
  void take(const Stretch3& stretch);
  // Moves to t, 0 <= t <= 1, and forgets what was relied on: left() and right() are `left` and `right`.
  // COST: that of the points; fewer bits in t make exact signs cheaper.
  void move_to(double t, double left, double right);
  double left() const { return left_; }
  double right() const { return right_; }
  bool is_unlucky() const { return is_unlucky_; }
  // The ways to all points, each times a positive number.
  std::span<const BoundedVector> toward() const { return toward_; }

  // The planes.
  // The plane of a body. REQUIRES: the point is in it.
  PlaneSide3 face(std::uint32_t body) const { return {PlaneId3(first_face_ + body), false}; }
  // Where body k is nearer than patch 0 or 1, among the directions in which both planes are met.
  // REQUIRES: the point is in front of the patch, and not in the plane of k.
  PlaneSide3 crossing(std::uint32_t k, std::uint32_t patch) const {
    return {PlaneId3(first_crossing_ + 2 * k + patch), false};
  }
  // The sides of planes that bound the cone of a body, the inside positive. `facing`: as facing() says.
  void cone_sides(std::uint32_t body, int facing, bool is_antipodal, std::vector<PlaneSide3>& result) const;
  // That of one side of the body.
  PlaneSide3 cone_side(std::uint32_t body, std::uint32_t side, int facing, bool is_antipodal) const {
    const PlaneSide3 plane = sides_[body][side];
    return (facing > 0) != is_antipodal ? plane.opposite() : plane;
  }

  // Adds what a plane is through: the ends of an edge, or the bodies whose plane it is, or that cross there.
  void tell(PlaneId3 plane, SightCorner3& corner) const;

  // Which side of a body the point sees: +1 its front, -1 its back, 0 neither. Relied on.
  int facing(std::uint32_t body);

  MovingCorner3 corner_at(std::uint32_t point, bool is_antipode, PlaneSide3 plane) const;
  MovingCorner3 corner(PlaneSide3 first, PlaneSide3 second);

  // Whether some point is on the positive side. Not relied on.
  bool is_any_positive(std::span<const std::uint32_t> points, PlaneSide3 side);
  // The signs of corners. Relied on, each.
  void find_signs(std::span<const MovingCorner3> corners, PlaneSide3 side, std::vector<signed char>& signs);
  // Relies on the signs of all corners, or points, where none is positive. False where one is: then on nothing.
  bool rely_if_none_is_positive(std::span<const MovingCorner3> corners, PlaneSide3 side);
  bool rely_if_none_is_positive(std::span<const std::uint32_t> points, PlaneSide3 side);
  // Relies on those of points.
  void rely(std::span<const std::uint32_t> points, PlaneSide3 side);
  // The sign of the angle from one direction to another, about the normal of a plane in which both are: +1 where it is
  // less than half a turn, -1 where it is more, 0 where it is just that or none. Exact; not relied on.
  int angle_sign(const MovingCorner3& from, PlaneId3 plane, const MovingCorner3& to);

  // The normal of a plane, and the direction of a corner, good to the last digits for all t between low and high, but
  // for what is close to an end: where doubles lose them, taken from integers, about the t at which they are shortest.
  MovingVector3 fine_normal(PlaneId3 plane, double low, double high);
  MovingVector3 fine_direction(const MovingCorner3& corner, double low, double high);
  // The same from integers, in long doubles, LongerReal or WideReal.
  template <class Real>
  WideVector3<Real> wide_normal(PlaneId3 plane, double low, double high);
  template <class Real>
  WideVector3<Real> wide_direction(const MovingCorner3& corner, double low, double high);

  // From now on keeps what proves signs that are relied on.
  void keep_signs() { keeps_signs_ = true; }
  // An interval of t, from no further than `left` below to no further than `right` above, on which all signs that were
  // relied on since move_to() are proven to be those at t: nothing of it rests on how well roots are told. None where
  // that fails, which is never wrong. REQUIRES keep_signs(), not is_unlucky(), and no further than move_to() was given.
  // COST: that of the integers of those that are zero at its ends.
  struct ProvenInterval {
    double low, high;
  };
  std::optional<ProvenInterval> prove_signs(double left, double right);
  // The normal of a plane, and the direction of a corner, as fine_normal() and fine_direction(), or times something
  // that is positive between low and high: where they are zero at an end, they are divided by what is zero there.
  template <class Real>
  using WholeVector = std::conditional_t<std::is_same_v<Real, double>, MovingVector3, WideVector3<Real>>;
  template <class Real>
  WholeVector<Real> whole_normal(PlaneId3 plane, double low, double high);
  template <class Real>
  WholeVector<Real> whole_direction(const MovingCorner3& corner, double low, double high);

  const SignCounts& counts() const { return counts_; }
  // How many signs were relied on.
  std::uint32_t relied_polynomials() const { return relied_; }

 private:
  static constexpr std::uint32_t kNoBody = 0xffffffff;
  // A vector that depends on s, exactly.
  struct ExactPolynomial {
    std::array<IntegerVector, 3> powers;  // of s, the third zero for planes
  };
  struct ExactNormal {
    std::uint64_t stamps[2] = {0, 0};
    IntegerVector powers[2];
  };
  enum class Kind : unsigned char { kLine, kFace, kCrossing };
  struct Plane {
    Kind kind;
    std::uint32_t a = 0, b = 0;                             // points; body; body and patch
    std::array<std::uint32_t, 2> bodies{kNoBody, kNoBody};  // whose planes contain the line that moves it
    // Of lines: from a to b.
    BoundedVector edge;
    std::unique_ptr<IntegerVector> exact_edge;
    // At t.
    std::uint64_t stamp = 0;
    MovingVector3 normal;
    std::unique_ptr<ExactNormal> exact;
  };
  struct Values {
    double value, error;
  };
  // How far a corner is beside a plane, times some number, and on which side.
  struct Beside {
    BoundedValue value;
    int sign;
  };
  // c[0] + c[1] s + c[2] s^2, whose coefficients are off by e at most.
  struct Quadratic {
    std::array<double, 3> c, e;
  };

  void add_lines();
  void find_met_points();
  PlaneSide3 line(std::uint32_t a, std::uint32_t b) const;  // through two points that are ends of an edge of a body
  void look_from(const Stretch3& stretch);
  const MovingVector3& normal(PlaneId3 plane);
  void find_line(Plane& plane);
  void find_crossing(Plane& plane);
  const IntegerVector& exact_edge(Plane& plane);
  const IntegerVector& exact_normal(PlaneId3 plane);  // at t
  const IntegerVector& exact_turn(PlaneId3 plane);    // by how much it changes with t
  IntegerVector exact_height_vector(const Plane& plane, const Integer& of_body, const Integer& of_patch);
  const IntegerVector& exact_first(const MovingCorner3& corner);        // holds until the next call
  const ExactPolynomial& exact_direction(const MovingCorner3& corner);  // holds until the next call
  ExactNormal& exact_of(Plane& plane);
  const IntegerVector& exact_toward(std::uint32_t point);
  IntegerVector exact_drift(std::uint32_t point);
  Values height(std::uint32_t body);
  Integer exact_height(std::uint32_t body);
  bool passes_through(const Plane& plane, std::uint32_t point) const;
  std::uint32_t shared_point(PlaneId3 a, PlaneId3 b) const;
  bool is_about_one_body(const MovingCorner3& corner, PlaneId3 plane) const;
  bool is_one_face(PlaneId3 a, PlaneId3 b) const;
  bool is_zero_by_identity(const MovingCorner3& corner, PlaneId3 plane) const;
  Beside beside(const MovingCorner3& corner, PlaneId3 plane, const MovingVector3& normal);
  int settled_sign(const MovingCorner3& corner, PlaneId3 plane);
  int sign(std::uint32_t point, PlaneId3 plane, const BoundedVector& normal);
  // Relies on a sign; `value` is the product of direction and normal.
  void rely(const MovingCorner3& corner, PlaneId3 plane, const MovingVector3& normal, BoundedValue value, int sign);
  void rely_closely(const MovingCorner3& corner, PlaneId3 plane, const Quadratic& near, int sign);
  bool is_point_far(std::uint32_t point, const MovingVector3& normal, BoundedValue value);
  static Quadratic quadratic(const MovingCorner3& corner, const MovingVector3& normal, BoundedValue value);
  // Three planes of which two are lines with an end in common: the determinant is that of a point beside a plane times
  // that of another one, but for its sign.
  struct Factors {
    PlaneId3 plane[2];
    std::uint32_t point[2];
  };
  std::optional<Factors> factors(PlaneId3 a, PlaneId3 b, PlaneId3 c) const;
  bool rely_on_factors(const MovingCorner3& corner, PlaneId3 plane);
  // The determinant's powers of s, where doubles hold all that they are made of. False where they do not.
  bool sum_whole(const MovingCorner3& corner, PlaneId3 plane, std::array<WideSum, 3>& powers) const;
  const std::array<Integer, 3>& exact_determinant(const MovingCorner3& corner, PlaneId3 plane);  // until the next call
  bool is_zero_for_every_t(const MovingCorner3& corner, PlaneId3 plane);
  // Whether c[0] + c[1] s + c[2] s^2, which are off by e, has no root between left and right, as a simple bound tells.
  bool is_far_from_zero(const std::array<double, 3>& c, const std::array<double, 3>& e);
  // Narrows left and right to the nearest roots of c[0] + c[1] s + c[2] s^2, which are off by e. False where there may
  // be roots that are less sure than `accuracy`: then nothing is narrowed, and integers are to be asked.
  bool narrow(const std::array<double, 3>& c, const std::array<double, 3>& e, int sign, double accuracy);
  // The same with integers, up to one positive factor.
  void narrow_exactly(const std::array<Integer, 3>& c, int sign);
  void take_root(double root);
  // A polynomial whose sign was relied on: of a corner beside a plane, or of a body's plane over the point.
  struct KeptSign {
    MovingCorner3 corner;
    PlaneId3 plane{0};
    std::uint32_t body = kNoBody;
    Quadratic near;
    int sign;
  };
  void keep(const MovingCorner3& corner, PlaneId3 plane, const Quadratic& near, int sign);
  void keep(std::uint32_t body, const Quadratic& near, int sign);
  bool is_surely_far_from_zero(const Quadratic& near) const;
  std::array<Integer, 3> exact_powers(const KeptSign& kept);
  bool proves(const KeptSign& kept, double& left, double& right);
  // The powers divided by what they have in common that is zero at no t between low and high.
  ExactPolynomial without_zeros(const ExactPolynomial& exact, double low, double high) const;
  bool is_short_somewhere(const MovingVector3& vector, double low, double high) const;
  template <class Real>
  WholeVector<Real> whole_vector(const ExactPolynomial& exact, double low, double high) const;
  bool is_fine(const MovingVector3& vector, double low, double high) const;
  // The powers about the t where it is shortest between low and high, multiplied with one number, and t.
  std::pair<ExactPolynomial, double> about_shortest(const ExactPolynomial& exact, double low, double high) const;

  const PairGeometry3& bodies_;
  std::vector<Plane> planes_;
  std::unordered_map<std::uint64_t, std::uint32_t> line_numbers_;
  std::vector<std::vector<PlaneSide3>> sides_;  // of the cones of bodies whose back is seen
  std::uint32_t first_face_ = 0, first_crossing_ = 0;

  // Of the line: weight * point - weight of the point * from, and weight of the point * way; times a power of two, the
  // same but for what weights are longer than doubles.
  const Stretch3* stretch_ = nullptr;
  std::vector<BoundedVector> offsets_, drifts_;
  bool is_small_ = false;
  double largest_offset_ = 0, largest_drift_ = 0;

  // At t = mantissa * 2^-places.
  double t_ = 0;
  Integer mantissa_;
  unsigned places_ = 0;
  double unit_ = 1;  // doubles are those of the line, times this
  std::vector<BoundedVector> toward_;
  std::vector<Direction3> moves_;          // by how much they change with t
  double unit_of_moves_ = 0;               // the unit in which they are; 0: they are those of another line
  std::vector<std::uint32_t> met_points_;  // corners of bodies: others belong to what was found to hide nothing
  std::uint64_t stamp_ = 0;
  struct ExactToward {
    std::uint64_t stamp = 0;
    IntegerVector vector;
  };
  std::vector<ExactToward> exact_toward_;
  KnownZeros3 known_zeros_;
  // What facing() told of a body at this t, and how it was decided.
  struct ToldFacing {
    std::uint64_t stamp = 0;
    int facing = 0;
    SignTier tier = SignTier::kFilter;
  };
  std::vector<ToldFacing> told_facings_;
  std::vector<std::uint64_t> in_face_;  // of bodies: the stamp of a stretch that is in the plane of its face
  std::uint64_t stretch_stamp_ = 0;
  std::vector<Beside> beside_;
  IntegerVector product_;
  ExactPolynomial polynomial_;
  std::array<Integer, 3> determinant_;

  double left_ = 0, right_ = 0;
  bool is_unlucky_ = false;
  SignCounts counts_;
  std::uint32_t relied_ = 0;
  bool keeps_signs_ = false;
  std::vector<KeptSign> kept_signs_;
};

}  // namespace hottel
