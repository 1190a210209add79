#include "geometry/space/exchange/stretch_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hottel {
namespace {

// Corners this close to each other are taken by their differences.
constexpr double kClose = 0.25;
// What an angle or a product of unit vectors loses, in units of the vectors.
constexpr double kArcRounding = 0x1p-53;
// The sine of an angle of nearly half a turn from which doubles tell its sign.
constexpr double kSureSine = 1e-12;

// x / sin x - 1 by the square of half the chord, q = sin^2 (x / 2) <= kClose^2: sum of 2 4 .. 2k / (3 5 .. (2k + 1))
// q^k.
double angle_over_sine_less_one(double q) {
  constexpr int kTerms = 14;
  constexpr auto kFactors = [] {
    std::array<double, kTerms> factors{};
    for (int k = 0; k < kTerms; ++k) factors[k] = (2.0 * k + 2) / (2.0 * k + 3);
    return factors;
  }();
  double sum = 1;
  for (int k = kTerms - 1; k > 0; --k) sum = 1 + kFactors[k] * q * sum;
  return kFactors[0] * q * sum;
}

// An arc between unit vectors on a plane with some normal.
struct ArcShape {
  Direction3 normal;  // unit
  double sine, cosine;
};

// Of a vector that is zero, as it may be at an end of a piece, nothing.
Direction3 unit_or_zero(const Direction3& a) {
  const double square = dot(a, a);
  return square > 0 ? (1 / std::sqrt(square)) * a : Direction3{};
}

ArcShape shape_of(const Direction3& normal, const Direction3& b, const Direction3& e) {
  const Direction3 n = unit_or_zero(normal);
  return {n, dot(n, cross(b, e - b)), dot(b, e)};
}

Direction3 unit_at(const MovingVector3& vector, double from, double offset) {
  return unit_or_zero(vector.at(from, offset));
}

}  // namespace

// Where an arc is nearly half a turn doubles may not tell its sign: that is taken where they tell it best. Returns the
// arcs where they tell it nowhere.
std::vector<std::uint32_t> StretchPiece3::find_turns() {
  std::vector<double> most(arcs.size(), 0);
  std::vector<char> is_half(arcs.size(), 0);
  std::vector<Direction3> at(corners.size());
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double offset = share * (high - low);
    for (std::size_t k = 0; k < corners.size(); ++k) at[k] = unit_at(corners[k], low, offset);
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      Arc& arc = arcs[k];
      const Direction3 &b = at[arc.begin], &e = at[arc.end];
      if (dot(b, e) >= 0) continue;
      is_half[k] = 1;
      const double sine = shape_of(planes[arc.plane].at(low, offset), b, e).sine;
      if (!(std::fabs(sine) > most[k])) continue;
      most[k] = std::fabs(sine);
      arc.turn = sine > 0 ? 1 : -1;
    }
  }
  std::vector<std::uint32_t> unsure;
  for (std::uint32_t k = 0; k < arcs.size(); ++k)
    if (is_half[k] != 0 && most[k] < kSureSine) unsure.push_back(k);
  return unsure;
}

// The ellipse with the ends of the interval as foci and 1.3 as the sum of its half axes, in half lengths.
bool StretchPiece3::is_steep(double from, double to) const {
  constexpr double kSum = 1.3;
  constexpr double kLong = (kSum + 1 / kSum) / 2, kShort = (kSum - 1 / kSum) / 2;
  const double middle = (from + to) / 2, half = (to - from) / 2;
  return std::any_of(near_zeros.begin(), near_zeros.end(), [&](const NearZero& zero) {
    const double x = (zero.at - middle) / (kLong * half), y = zero.width / (kShort * half);
    return x * x + y * y < 1;
  });
}

// With unit vectors b and e the angle from b to e about the normal n is signed: atan2 of n . (b x e) and b . e.
// Close to a direction c, as the arcs close and so the sum of c x (e - b) is zero:
//   angle n = (angle / sine) b x e,   b x e = (b - c) x (e - c) + c x (e - b).
Direction3 StretchPiece3::lambda(double from, double offset, double* rounding) const {
  thread_local std::vector<Direction3> at;
  at.clear();
  double spread = 0;
  for (const MovingVector3& corner : corners) {
    at.push_back(unit_at(corner, from, offset));
    const Direction3 apart = at.back() - at.front();
    spread = std::max(spread, dot(apart, apart));
  }
  Direction3 sum;
  const bool is_close = spread < kClose * kClose;
  if (is_close) {
    const Direction3& c = at.front();
    for (const Arc& arc : arcs) {
      const Direction3 &b = at[arc.begin], &e = at[arc.end], way = e - b;
      const double more = angle_over_sine_less_one(dot(way, way) / 4);
      sum = sum + (arc.count / 2) * (cross(b - c, way) + more * cross(b, way));
    }
  } else {
    for (const Arc& arc : arcs) {
      const ArcShape shape = shape_of(planes[arc.plane].at(from, offset), at[arc.begin], at[arc.end]);
      double angle = std::atan2(shape.sine, shape.cosine);
      if (shape.cosine < 0 && arc.turn != 0) {  // the sine may have been lost, sign and all
        angle = std::atan2(arc.turn * shape.sine, shape.cosine);
        angle = arc.turn * (angle < 0 ? angle + 2 * std::numbers::pi : angle);
      }
      sum = sum + (arc.count * angle / 2) * shape.normal;
    }
  }
  if (rounding)
    *rounding =
        std::max(*rounding, kArcRounding * static_cast<double>(arcs.size()) * (is_close ? std::sqrt(spread) : 1.0));
  return sum;
}

}  // namespace hottel
