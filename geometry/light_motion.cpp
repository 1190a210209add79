#include "geometry/light_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/ball.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Of what cannot be told from 0, 0.
double nearest(const Ball& ball) { return ball.sign() == 0 ? 0 : ball.nearest_of_ends().lower; }

Ball distance(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational squared = 0;
  for (std::size_t k = 0; k < a.size(); ++k) squared += (b[k] - a[k]) * (b[k] - a[k]);
  const Integer radicand = squared.get_num() * squared.get_den();
  return Ball::root(radicand, kMotionPrecision)
      .over(Ball::of(Rational(squared.get_den()), kMotionPrecision), kMotionPrecision);
}

// (a, b) turned by an angle from a to b.
void turn(Ball& a, Ball& b, const Rational& degrees) {
  const Ball sine = Ball::sine_of_degrees(degrees, kMotionPrecision);
  const Ball cosine = Ball::sine_of_degrees(Rational(90 + degrees), kMotionPrecision);
  const auto times = [](const Ball& x, const Ball& y) { return x.times(y, kMotionPrecision); };
  Ball first = times(cosine, a).minus(times(sine, b), kMotionPrecision);
  b = times(sine, a).plus(times(cosine, b), kMotionPrecision);
  a = std::move(first);
}

}  // namespace

PathPlace place_on_path(const std::vector<std::vector<Rational>>& points, bool is_closed, const Rational& part) {
  HOTTEL_REQUIRE(points.size() > 1 && part >= 0 && part <= 1);
  const std::size_t segments = is_closed ? points.size() : points.size() - 1;
  const auto end_of = [&](std::size_t k) -> const std::vector<Rational>& { return points[(k + 1) % points.size()]; };
  std::vector<Ball> length;
  Ball all;
  for (std::size_t k = 0; k < segments; ++k) {
    length.push_back(distance(points[k], end_of(k)));
    all = all.plus(length.back(), kMotionPrecision);
  }
  Ball rest = all.times(Ball::of(part, kMotionPrecision), kMotionPrecision);
  PathPlace place;
  while (place.segment + 1 < segments && (points[place.segment] == end_of(place.segment) ||
                                          rest.minus(length[place.segment], kMotionPrecision).sign() > 0))
    rest = rest.minus(length[place.segment++], kMotionPrecision);
  const auto &from = points[place.segment], &to = end_of(place.segment);
  const bool is_at_end = part == 1 || from == to;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (is_at_end) {
      place.point.push_back(to_double(to[k]));
      continue;
    }
    const Ball way = rest.over(length[place.segment], kMotionPrecision)
                         .times(Ball::of(Rational(to[k] - from[k]), kMotionPrecision), kMotionPrecision);
    place.point.push_back(nearest(Ball::of(from[k], kMotionPrecision).plus(way, kMotionPrecision)));
  }
  for (const double coordinate : place.point)
    if (!std::isfinite(coordinate)) throw RequestError("its place on its path is beyond the range of doubles");
  return place;
}

Rational part_of_way(const Rational& time, const Rational& seconds, bool is_closed) {
  const Rational part = time / seconds;
  if (!is_closed) return std::min<Rational>(part, 1);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), part.get_num_mpz_t(), part.get_den_mpz_t());
  return part - whole;
}

Rational within_a_turn(const Rational& degrees) {
  const Rational turns = degrees / 360;
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), turns.get_num_mpz_t(), turns.get_den_mpz_t());
  return degrees - 360 * Rational(whole);
}

std::vector<double> turned(const std::vector<Rational>& vector, const std::vector<Rational>& degrees) {
  HOTTEL_REQUIRE(vector.size() == 3 && degrees.size() == 3);
  Rational size = 0;
  for (const Rational& component : vector) size = std::max<Rational>(size, abs(component));
  HOTTEL_REQUIRE(size > 0);
  std::vector<Ball> v;
  for (const Rational& component : vector) v.push_back(Ball::of(Rational(component / size), kMotionPrecision));
  turn(v[1], v[2], degrees[0]);
  turn(v[2], v[0], degrees[1]);
  turn(v[0], v[1], degrees[2]);
  return {nearest(v[0]), nearest(v[1]), nearest(v[2])};
}

}  // namespace hottel
