#include "geometry/space/visibility/point_bounds.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/space/visibility/seen_faces.h"
#include "kernel/ball.h"
#include "kernel/coprime_integers.h"

namespace hottel {
namespace {

// How many bits are begun with, how many of a number are enough, and after how many no more are tried.
constexpr long kBits = 192, kEnough = 128, kMostBits = 1L << 16;

// Between 0 and pi.
Ball angle_between(const IntegerVector& a, const IntegerVector& b, long bits) {
  const IntegerVector across = cross(a, b);
  return Ball::atan2(Ball::root(dot(across, across), bits), Ball::of(Rational(dot(a, b)), bits), bits);
}

// n . m / |m|
Ball along_unit(const IntegerVector& n, const IntegerVector& m, long bits) {
  return Ball::of(Rational(dot(n, m)), bits).over(Ball::root(dot(m, m), bits), bits);
}

// number / (turns * 2 pi)
Ball over_turns(const Ball& number, int turns, long bits) {
  return number.over(Ball::pi(bits).times(Ball::of(Rational(2 * turns), bits), bits), bits);
}

// What some directions are of the full sphere, and the integral of their cosines over pi.
struct Measures {
  Ball fraction, factor;

  void add(const Measures& other) {
    fraction = fraction.plus(other.fraction, kBits);
    factor = factor.plus(other.factor, kBits);
  }
  Measures rest_of(const Rational& all_fractions, const Rational& all_factors) const {
    return {Ball::of(all_fractions, kBits).minus(fraction, kBits), Ball::of(all_factors, kBits).minus(factor, kBits)};
  }
};

// Where sides turn by t_k from one inward normal to the next the solid angle is 2 pi less their sum.
Ball fraction_of(const ExactCone3& cone, long bits) {
  Ball turns;
  for (std::size_t k = 0; k < cone.inward.size(); ++k)
    turns = turns.plus(angle_between(cone.inward[k], cone.inward[(k + 1) % cone.inward.size()], bits), bits);
  return Ball::of(Rational(1) / 2, bits).minus(over_turns(turns, 2, bits), bits);
}

// With the angle w_k that edge k takes, the integral of n . w is half the sum of w_k n . m_k / |m_k|. SEE: Lambert
// 1760.
Ball factor_of(const ExactCone3& cone, const IntegerVector& normal, long bits) {
  Ball sum;
  for (std::size_t k = 0; k < cone.inward.size(); ++k) {
    const Ball width = angle_between(cone.corners[k], cone.corners[(k + 1) % cone.inward.size()], bits);
    sum = sum.plus(width.times(along_unit(normal, cone.inward[k], bits), bits), bits);
  }
  return over_turns(sum.over(Ball::root(dot(normal, normal), bits), bits), 1, bits);
}

// With more bits until enough are left.
template <class Measure>
Ball narrow(const Measure& measure) {
  for (long bits = kBits;; bits *= 2) {
    Ball ball = measure(bits);
    if (ball.is_relatively_narrow(kEnough) || bits >= kMostBits) return ball;
  }
}

Measures measures_of(const ExactCone3& cone, const IntegerVector* normal) {
  return {narrow([&](long bits) { return fraction_of(cone, bits); }),
          normal == nullptr ? Ball() : narrow([&](long bits) { return factor_of(cone, *normal, bits); })};
}

Enclosure bounds_within(const Ball& ball, double most) {
  const Enclosure bounds = ball.bounds();
  return {std::clamp(bounds.lower, 0.0, most), std::clamp(bounds.upper, 0.0, most)};
}

class Measuring {
 public:
  Measuring(const ExactVisibilityMap3& map, const Arrangement3& arrangement, const std::optional<Vector3>& normal)
      : map_(map), arrangement_(arrangement) {
    if (!normal) return;
    const auto [x, y, z] = coprime_integers<3>({normal->x, normal->y, normal->z});
    normal_ = IntegerVector{x, y, z};
  }

  PointBounds3 operator()() {
    // From a face everything before it is looked at; else what leads into solids is not.
    const bool is_on_border = !normal_ && !solids_at(arrangement_.solids(), map_.eye()).empty();
    for (std::size_t k = 0; k < map_.size(); ++k) {
      const Face& side = map_.map().fragments[k].face;
      const Piece3::Side& found = arrangement_.pieces()[side.surface].side(side.is_back);
      add(map_.cone(k), is_on_border && found.cover != Piece3::Cover::kFree ? nullptr : &found.owner);
      if (!is_on_border || found.cover == Piece3::Cover::kFree) continue;
      for (const Polygon3& free : found.free)
        if (const auto part = common_cone(map_.cone(k), map_.cone_of(free.points))) add_share(*part, found.owner);
    }
    return result();
  }

 private:
  // What is seen in a cone, or is not the sky's at least.
  void add(const ExactCone3& cone, const Face* owner) {
    const std::optional<ExactCone3> seen = normal_ ? common_cone(cone, ExactCone3{{*normal_}, {}}) : cone;
    if (!seen) return;
    const Measures measures = measures_of(*seen, normal_ ? &*normal_ : nullptr);
    all_.add(measures);
    if (owner != nullptr) of_faces_[*owner].add(measures);
  }
  void add_share(const ExactCone3& cone, const Face& owner) { of_faces_[owner].add(measures_of(cone, nullptr)); }

  PointBounds3 result() const {
    const double most = normal_ ? 0.5 : 1;
    PointBounds3 bounds;
    for (const auto& [face, measures] : of_faces_)
      bounds.shares.push_back({face, bounds_within(measures.fraction, most), bounds_within(measures.factor, 1)});
    const Measures rest = all_.rest_of(normal_ ? Rational(1) / 2 : Rational(1), normal_ ? 1 : 0);
    bounds.sky_fraction = bounds_within(rest.fraction, most);
    bounds.sky_factor = bounds_within(rest.factor, 1);
    return bounds;
  }

  const ExactVisibilityMap3& map_;
  const Arrangement3& arrangement_;
  std::optional<IntegerVector> normal_;
  std::map<Face, Measures> of_faces_;
  Measures all_;
};

}  // namespace

PointBounds3 point_bounds(const ExactVisibilityMap3& map, const Arrangement3& arrangement,
                          const std::optional<Vector3>& normal) {
  return Measuring(map, arrangement, normal)();
}

}  // namespace hottel
