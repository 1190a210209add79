// Planes through a point that moves, and directions, in integers (MovingPlanes3).
#include <array>
#include <cstdint>
#include <memory>

#include "geometry/space/moving/moving_planes.h"

namespace hottel {
namespace {

// Doubles that are whole numbers up to this, and their products summed in threes, are exact in what follows.
constexpr double kMostWhole = 0x1p51;

struct Whole {
  std::int64_t x, y, z;
};
struct Wide {
  Int128 x = 0, y = 0, z = 0;
};

bool is_whole(const MovingVector3& v) {
  return v.first.error == 0 && v.first.size <= kMostWhole && v.terms[1] <= kMostWhole;
}

Whole whole(const Direction3& d) {
  return {static_cast<std::int64_t>(d.x), static_cast<std::int64_t>(d.y), static_cast<std::int64_t>(d.z)};
}

void add_cross(const Whole& a, const Whole& b, Wide& sum) {
  const auto product = [](std::int64_t p, std::int64_t q) { return static_cast<Int128>(p) * q; };
  sum.x += product(a.y, b.z) - product(a.z, b.y);
  sum.y += product(a.z, b.x) - product(a.x, b.z);
  sum.z += product(a.x, b.y) - product(a.y, b.x);
}

void add_dot(const Wide& a, const Whole& b, WideSum& sum) {
  sum.add(a.x, b.x);
  sum.add(a.y, b.y);
  sum.add(a.z, b.z);
}

}  // namespace

bool MovingPlanes3::sum_whole(const MovingCorner3& corner, PlaneId3 plane, std::array<WideSum, 3>& powers) const {
  const MovingVector3& beside = planes_[plane.index()].normal;
  if (!is_whole(beside)) return false;
  std::array<Wide, 3> direction;
  if (corner.point != MovingCorner3::kNoPoint) {
    if (!is_whole(corner.direction)) return false;
    const Whole first = whole(plain(corner.direction.first)), second = whole(corner.direction.second);
    direction[0] = {first.x, first.y, first.z};
    direction[1] = {second.x, second.y, second.z};
  } else {
    const bool is_turned = corner.first.is_opposite != corner.second.is_opposite;
    const MovingVector3& p = planes_[(is_turned ? corner.second : corner.first).plane.index()].normal;
    const MovingVector3& q = planes_[(is_turned ? corner.first : corner.second).plane.index()].normal;
    if (!is_whole(p) || !is_whole(q)) return false;
    const Whole p0 = whole(plain(p.first)), p1 = whole(p.second), q0 = whole(plain(q.first)), q1 = whole(q.second);
    add_cross(p0, q0, direction[0]);
    add_cross(p1, q0, direction[1]);
    add_cross(p0, q1, direction[1]);
    add_cross(p1, q1, direction[2]);
  }
  const Whole n0 = whole(plain(beside.first)), n1 = whole(beside.second);
  for (std::size_t k = 0; k < 3; ++k) {
    add_dot(direction[k], n0, powers[k]);
    if (k > 0) add_dot(direction[k - 1], n1, powers[k]);
  }
  return true;
}

const IntegerVector& MovingPlanes3::exact_edge(Plane& plane) {
  if (!plane.exact_edge) {
    const PairGeometry3::Point &p = bodies_.points[plane.a], &q = bodies_.points[plane.b];
    plane.exact_edge = std::make_unique<IntegerVector>(
        p.is_far() ? difference(q.exact(), p.exact())
                   : difference(multiple(p.weight(), q.exact()), multiple(q.weight(), p.exact())));
  }
  return *plane.exact_edge;
}

Integer MovingPlanes3::exact_height(std::uint32_t body) {
  const PairGeometry3::Body& b = bodies_.bodies[body];
  return dot(b.exact_normal(), exact_toward(b.corners.front()));
}

const IntegerVector& MovingPlanes3::exact_toward(std::uint32_t point) {
  ExactToward& kept = exact_toward_[point];
  if (kept.stamp == stamp_) return kept.vector;
  kept.stamp = stamp_;
  const PairGeometry3::Point& p = bodies_.points[point];
  if (p.is_far()) return kept.vector = p.exact();
  thread_local Integer step;
  step = mantissa_ * p.weight();
  const auto set = [&](Integer& result, const Integer& corner, const Integer& from, const Integer& way) {
    mpz_mul(result.get_mpz_t(), stretch_->weight.get_mpz_t(), corner.get_mpz_t());
    mpz_submul(result.get_mpz_t(), p.weight().get_mpz_t(), from.get_mpz_t());
    mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), places_);
    mpz_submul(result.get_mpz_t(), step.get_mpz_t(), way.get_mpz_t());
  };
  set(kept.vector.x, p.exact().x, stretch_->from.x, stretch_->way.x);
  set(kept.vector.y, p.exact().y, stretch_->from.y, stretch_->way.y);
  set(kept.vector.z, p.exact().z, stretch_->from.z, stretch_->way.z);
  return kept.vector;
}

IntegerVector MovingPlanes3::exact_drift(std::uint32_t point) {
  Integer factor = -bodies_.points[point].weight();
  factor <<= places_;
  return multiple(factor, stretch_->way);
}

MovingPlanes3::ExactNormal& MovingPlanes3::exact_of(Plane& plane) {
  if (!plane.exact) plane.exact = std::make_unique<ExactNormal>();
  return *plane.exact;
}

// sign(h_k) (h_k w_patch N_patch - h_patch w_k N_k) for heights or their changes.
IntegerVector MovingPlanes3::exact_height_vector(const Plane& plane, const Integer& of_body, const Integer& of_patch) {
  const PairGeometry3::Body &k = bodies_.bodies[plane.a], &patch = bodies_.bodies[plane.b];
  const Integer &wk = bodies_.points[k.corners.front()].weight(), &wp = bodies_.points[patch.corners.front()].weight();
  const int sign = sgn(exact_height(plane.a));
  return difference(multiple(sign * of_body * wp, patch.exact_normal()),
                    multiple(sign * of_patch * wk, k.exact_normal()));
}

const IntegerVector& MovingPlanes3::exact_normal(PlaneId3 id) {
  Plane& plane = planes_[id.index()];
  if (plane.kind == Kind::kFace) return bodies_.bodies[plane.a].exact_normal();
  ExactNormal& exact = exact_of(plane);
  if (exact.stamps[0] == stamp_) return exact.powers[0];
  exact.stamps[0] = stamp_;
  if (plane.kind == Kind::kLine)
    set_cross(exact.powers[0], exact_toward(plane.a), exact_edge(plane));
  else
    exact.powers[0] = exact_height_vector(plane, exact_height(plane.a), exact_height(plane.b));
  return exact.powers[0];
}

const IntegerVector& MovingPlanes3::exact_turn(PlaneId3 id) {
  static const IntegerVector kZero;
  Plane& plane = planes_[id.index()];
  if (plane.kind == Kind::kFace) return kZero;
  ExactNormal& exact = exact_of(plane);
  if (exact.stamps[1] == stamp_) return exact.powers[1];
  exact.stamps[1] = stamp_;
  const auto slope = [this](std::uint32_t body) -> Integer {
    const PairGeometry3::Body& b = bodies_.bodies[body];
    return dot(b.exact_normal(), exact_drift(b.corners.front()));
  };
  exact.powers[1] = plane.kind == Kind::kLine ? cross(exact_drift(plane.a), exact_edge(plane))
                                              : exact_height_vector(plane, slope(plane.a), slope(plane.b));
  return exact.powers[1];
}

const IntegerVector& MovingPlanes3::exact_first(const MovingCorner3& corner) {
  if (corner.point != MovingCorner3::kNoPoint) {
    const IntegerVector& w = exact_toward(corner.point);
    if (!corner.is_antipode) return w;
    return product_ = opposite(w);
  }
  const bool is_turned = corner.first.is_opposite != corner.second.is_opposite;
  const IntegerVector &a = exact_normal(corner.first.plane), &b = exact_normal(corner.second.plane);
  if (is_turned)
    set_cross(product_, b, a);
  else
    set_cross(product_, a, b);
  return product_;
}

int MovingPlanes3::angle_sign(const MovingCorner3& from, PlaneId3 plane, const MovingCorner3& to) {
  const IntegerVector first = exact_first(from);
  return determinant_sign(first, exact_first(to), exact_normal(plane));
}

const MovingPlanes3::ExactPolynomial& MovingPlanes3::exact_direction(const MovingCorner3& corner) {
  auto& powers = polynomial_.powers;
  if (corner.point != MovingCorner3::kNoPoint) {
    powers[0] = exact_first(corner);
    powers[1] = exact_drift(corner.point);
    if (corner.is_antipode) powers[1] = opposite(powers[1]);
    powers[2] = {};
    return polynomial_;
  }
  const bool is_turned = corner.first.is_opposite != corner.second.is_opposite;
  const PlaneId3 p = is_turned ? corner.second.plane : corner.first.plane;
  const PlaneId3 q = is_turned ? corner.first.plane : corner.second.plane;
  const IntegerVector &a = exact_normal(p), &b = exact_normal(q), &a1 = exact_turn(p), &b1 = exact_turn(q);
  set_cross(powers[0], a, b);
  set_cross(powers[1], a1, b);
  set_cross(product_, a, b1);
  powers[1].x += product_.x;
  powers[1].y += product_.y;
  powers[1].z += product_.z;
  set_cross(powers[2], a1, b1);
  return polynomial_;
}

}  // namespace hottel
