// Shares of beams in cones: closed forms, an oracle of another formula, borders decided exactly.
#include "geometry/space/visibility/beam.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/oracle/space/beam_share.h"

namespace hottel::beam_test {
namespace {

constexpr double kPi = std::numbers::pi;

// The cone around directions, counter-clockwise.
ExactCone3 cone_of(const std::vector<IntegerVector>& corners) {
  ExactCone3 cone{{}, corners};
  for (std::size_t k = 0; k < corners.size(); ++k)
    cone.inward.push_back(cross(corners[k], corners[k + 1 == corners.size() ? 0 : k + 1]));
  return cone;
}

IntegerVector vector(long x, long y, long z) { return {Integer(x), Integer(y), Integer(z)}; }

double share(const Beam3& beam, const ExactCone3& cone) {
  const Ball ball = BeamPower3(beam).share(cone);
  EXPECT_TRUE(ball.is_relatively_narrow(60));
  return ball.nearest_of_ends().lower;
}

const ExactCone3 kOctant = cone_of({vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)});

TEST(BeamPower3, AnOctantGetsItsPart) {
  EXPECT_EQ(share({}, kOctant), 0.125);
  for (const Rational& falloff : {Rational(0), Rational(1), Rational(2), Rational(5, 2), Rational(100),
                                  Rational(24691, 2), Rational(1'000'000)}) {
    EXPECT_DOUBLE_EQ(share({{0, 0, 1}, 90, falloff}, kOctant), 0.25) << falloff;  // the axis at a corner
    EXPECT_DOUBLE_EQ(share({{0, 0, 1}, 30, falloff}, kOctant), 0.25) << falloff;
    EXPECT_DOUBLE_EQ(share({{1, 0, 1}, 45, falloff}, kOctant), 0.5) << falloff;  // on an edge, to its ends
    EXPECT_DOUBLE_EQ(share({{1, 1, 1}, 10, falloff}, kOctant), 1) << falloff;
    EXPECT_TRUE(BeamPower3({{-1, -1, -1}, 30, falloff}).share(kOctant).is_relatively_narrow(1000)) << falloff;
    EXPECT_EQ(share({{-1, -1, -1}, 30, falloff}, kOctant), 0) << falloff;
  }
  // What is left of all directions when those within 45 degrees of -z, or of z, are taken away.
  EXPECT_DOUBLE_EQ(share({{0, 0, 1}, 135, 0}, kOctant), (kPi / 2) / (2 * kPi * (1 + std::sqrt(0.5))));
  EXPECT_DOUBLE_EQ(share({{0, 0, -1}, 135, 0}, kOctant), 0.25 * std::sqrt(0.5) / (1 + std::sqrt(0.5)));
}

// cos t = c0 cos u along an edge that comes as near to the axis as 35.26.. degrees: sin^2 = 1/3.
TEST(BeamPower3, TellsBordersFromWhatIsBesideThem) {
  const ExactCone3 below = cone_of({vector(-1, 1, 0), vector(1, 1, 0), vector(0, 0, -1)});
  for (const Rational& falloff : {Rational(0), Rational(1), Rational(1, 2)}) {
    EXPECT_EQ(share({{0, 1, 1}, 45, falloff}, below), 0);  // touches the edge
    EXPECT_EQ(share({{0, 1, 1}, Rational(44), falloff}, below), 0);
    const double little = share({{0, 1, 1}, Rational(45) + Rational(1, Integer(1) << 40), falloff}, below);
    EXPECT_GT(little, 0);
    EXPECT_LT(little, 1e-15);
  }
  EXPECT_EQ(BeamPower3({{0, 0, 1}, 45, 0}).side(vector(3, 4, 5)), 0);
  EXPECT_EQ(BeamPower3({{0, 0, 1}, 135, 0}).side(vector(3, 4, -5)), 0);
  EXPECT_EQ(BeamPower3({{0, 0, 1}, 60, 0}).side(vector(1, 1, 0)), -1);
  EXPECT_EQ(BeamPower3({{1, 1, 0}, 60, 0}).side(vector(1, 0, 1)), 0);
  EXPECT_EQ(BeamPower3({{0, 0, 1}, 90, 0}).side(vector(1, 1, 0)), 0);
  EXPECT_EQ(BeamPower3({}).side(vector(0, 0, -1)), 1);
}

Beam3 random_beam(std::mt19937_64& engine, const IntegerVector& near) {
  const auto number = [&engine](long most) {
    return static_cast<long>(engine() % static_cast<std::uint64_t>(2 * most + 1)) - most;
  };
  Beam3 beam;
  do {
    beam.axis = {number(9), number(9), number(9)};
  } while (beam.axis.is_zero());
  const auto choice = engine() % 8;
  if (choice < 2) beam.axis = {near.x, near.y, near.z};
  const Rational angles[] = {5, 20, Rational(77, 2), 45, 60, Rational(89), 90, Rational(1, 7)};
  beam.half_angle = angles[engine() % 8];
  const Rational falloffs[] = {0, 0, 1, 2, 3, Rational(5, 2), Rational(1, 3), 7, 12, 70, Rational(141, 10)};
  beam.falloff = falloffs[engine() % 11];
  if (beam.falloff == 0 && engine() % 3 == 0) beam.half_angle = 180 - beam.half_angle;
  return beam;
}

template <class Real>
Real to_real(const Rational& value) {
  return Real(value.get_num().get_str()) / Real(value.get_den().get_str());
}
template <>
long double to_real<long double>(const Rational& value) {
  return std::stold(value.get_num().get_str()) / std::stold(value.get_den().get_str());
}

template <class Real>
std::array<Real, 3> to_reals(const IntegerVector& a) {
  return {to_real<Real>(a.x), to_real<Real>(a.y), to_real<Real>(a.z)};
}

template <class Real>
Real oracle_share(const Beam3& beam, const ExactCone3& cone) {
  const Real f = to_real<Real>(beam.half_angle / 180) * boost::math::constants::pi<Real>();
  const oracle::BeamShare<Real> oracle(
      {to_real<Real>(beam.axis.x), to_real<Real>(beam.axis.y), to_real<Real>(beam.axis.z)}, f,
      to_real<Real>(beam.falloff));
  std::vector<std::array<Real, 3>> inward, corners;
  for (const IntegerVector& m : cone.inward) inward.push_back(to_reals<Real>(m));
  for (const IntegerVector& c : cone.corners) corners.push_back(to_reals<Real>(c));
  return oracle(inward, corners);
}

ExactCone3 random_cone(std::mt19937_64& engine, long size, long spread) {
  for (;;) {
    const auto number = [&engine](long most) {
      return static_cast<long>(engine() % static_cast<std::uint64_t>(2 * most + 1)) - most;
    };
    const IntegerVector middle = vector(number(size), number(size), number(size));
    std::vector<IntegerVector> corners;
    for (int k = 0; k < 3; ++k) corners.push_back(sum(middle, vector(number(spread), number(spread), number(spread))));
    const int sign = determinant_sign(corners[0], corners[1], corners[2]);
    if (sign == 0) continue;
    if (sign < 0) std::swap(corners[0], corners[1]);
    return cone_of(corners);
  }
}

TEST(BeamPower3, AgreesWithAnIntegralOverCircles) {
  std::mt19937_64 engine(7);
  int lit = 0;
  for (int n = 0; n < 400; ++n) {
    const ExactCone3 cone = n % 3 == 0   ? random_cone(engine, 0, 9)
                            : n % 3 == 1 ? random_cone(engine, 9, 5)
                                         : random_cone(engine, 40, 3);
    const Beam3 beam = random_beam(engine, sum(cone.corners[0], cone.corners[n % 2]));
    const double value = share(beam, cone);
    EXPECT_NEAR(value, static_cast<double>(oracle_share<long double>(beam, cone)), 2e-15)
        << n << " f " << beam.half_angle << " n " << beam.falloff;
    lit += value > 0 && value < 1;
  }
  EXPECT_GT(lit, 150);
}

TEST(BeamPower3, BallsHoldWhatTheOracleFindsInFiftyDigits) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  std::mt19937_64 engine(8);
  for (int n = 0; n < 12; ++n) {
    const ExactCone3 cone = random_cone(engine, 9, 5);
    const Beam3 beam = random_beam(engine, sum(cone.corners[0], cone.corners[1]));
    const Ball ball = BeamPower3(beam).share(cone, 120);
    const Real expected = oracle_share<Real>(beam, cone);
    const Integer scaled(Real(expected * pow(Real(2), 150)).convert_to<boost::multiprecision::cpp_int>().str());
    const Ball difference = ball.minus(Ball::of(Rational(scaled) / Rational(Integer(1) << 150), 200), 200);
    const Enclosure bounds = difference.bounds();
    EXPECT_LT(std::max(std::fabs(bounds.lower), std::fabs(bounds.upper)), 1e-30)
        << n << " f " << beam.half_angle << " n " << beam.falloff;
  }
}

// Two formulas: sums of powers, and a quadrature for what is next to a whole number by 1e-40.
TEST(BeamPower3, WholeFalloffsAreNextToOthers) {
  std::mt19937_64 engine(9);
  const Rational little = Rational(1) / Rational(Integer("10000000000000000000000000000000000000000"));
  int lit = 0;
  for (int n = 0; n < 60; ++n) {
    const ExactCone3 cone = random_cone(engine, 9, 5);
    Beam3 beam = random_beam(engine, sum(cone.corners[0], cone.corners[1]));
    const Rational wholes[] = {1, 2, 3, 20, 301, 1000};
    beam.falloff = wholes[n % 6];
    const Ball whole = BeamPower3(beam).share(cone, 120);
    beam.falloff += little;
    const Ball other = BeamPower3(beam).share(cone, 120);
    const Enclosure bounds = whole.minus(other, 200).bounds();
    EXPECT_LT(std::max(std::fabs(bounds.lower), std::fabs(bounds.upper)), 1e-34)
        << n << " f " << beam.half_angle << " n " << beam.falloff.get_d();
    lit += whole.sign() > 0 && whole.compare(1) < 0;
  }
  EXPECT_GT(lit, 15);
}

// With an angle that is not cut to 90, where n is next to 0 and the beam is of 90 degrees.
TEST(BeamPower3, NoFalloffIsTheLimitOfLittle) {
  std::mt19937_64 engine(10);
  for (int n = 0; n < 40; ++n) {
    const ExactCone3 cone = random_cone(engine, 9, 5);
    Beam3 beam = random_beam(engine, sum(cone.corners[0], cone.corners[1]));
    if (beam.half_angle > 90) beam.half_angle = 90;
    beam.falloff = 0;
    const double none = share(beam, cone);
    beam.falloff = Rational(1) / Rational(Integer("100000000000000000000"));
    EXPECT_NEAR(share(beam, cone), none, 2e-16) << n << " f " << beam.half_angle;
  }
}

// A square of side 2^(1-k) at the distance 1 is as good as flat: its share is I0 times its area.
TEST(BeamPower3, TinyConesHaveAllTheirDigits) {
  for (const int k : {20, 60, 200}) {
    const Integer far = Integer(1) << k;
    const ExactCone3 cone = cone_of({{Integer(-1), Integer(-1), far},
                                     {Integer(1), Integer(-1), far},
                                     {Integer(1), Integer(1), far},
                                     {Integer(-1), Integer(1), far}});
    const double area = std::ldexp(1.0, 2 - 2 * k), off = std::ldexp(1.0, 4 - 2 * k);
    const auto expect = [&](const Beam3& beam, double intensity) {
      const double value = share(beam, cone);
      EXPECT_NEAR(value / (intensity * area), 1, 1e-15 + off * 10)
          << k << " f " << beam.half_angle << " n " << beam.falloff;
    };
    expect({}, 1 / (4 * kPi));
    for (const Rational& n : {Rational(0), Rational(1), Rational(2), Rational(5, 2)}) {
      const double exponent = to_double(n);
      expect({{0, 0, 1}, 90, n}, (exponent + 1) / (2 * kPi));
      expect({{1, 0, 1}, 60, n},
             std::pow(0.5, exponent / 2) * (exponent + 1) / (2 * kPi * (1 - std::pow(0.5, exponent + 1))));
    }
  }
}

// Cones of a few beam widths beside the axis: what leaves beyond the angle t is cos^(n+1) t, less what is cut off.
TEST(BeamPower3, LargeFalloffsHaveTheirShares) {
  for (const Rational& falloff : {Rational(1001), Rational(24691, 2), Rational(1'000'000)}) {
    const double k = to_double(falloff) + 1;
    for (const long reach : {1, 3, 10, 30}) {
      // A quadrant around (0, 0, 1) beyond a plane: by symmetry four of them are what a square leaves out, which holds
      // the circle within it and is within the circle around it.
      const long far = static_cast<long>(1000 * std::sqrt(k)), near = 1000 * reach;
      double outside = 0;
      for (const auto& [x, y] : {std::pair{1L, 1L}, {-1L, 1L}, {-1L, -1L}, {1L, -1L}}) {
        const IntegerVector a = vector(near * x, near * y, far), b = vector(-near * y, near * x, far);
        const Ball ball = BeamPower3({{0, 0, 1}, 90, falloff})
                              .share(cone_of({a, vector(far * x, far * y, 0), vector(-far * y, far * x, 0), b}));
        EXPECT_TRUE(ball.is_relatively_narrow(50)) << falloff << " " << reach;
        outside += ball.nearest_of_ends().lower;
      }
      const double inside =
          share({{0, 0, 1}, 90, falloff}, cone_of({vector(near, near, far), vector(-near, near, far),
                                                   vector(-near, -near, far), vector(near, -near, far)}));
      EXPECT_NEAR(inside + outside, 1, 1e-15) << falloff << " " << reach;
      const auto beyond = [&](double slope) { return std::exp(-k / 2 * std::log1p(slope * slope)); };
      const double slope = static_cast<double>(near) / static_cast<double>(far);
      EXPECT_LT(outside, beyond(slope)) << falloff << " " << reach;
      EXPECT_GT(outside, beyond(slope * std::sqrt(2))) << falloff << " " << reach;
    }
  }
}

TEST(BeamPower3, WhatIsFarBelowDoublesIsBounded) {
  for (const Rational& falloff : {Rational(1'000'000), Rational(1'999'999, 2)})
    for (const Vector3& axis : {Vector3{-1, -1, -1}, Vector3{-1, 2, 2}, Vector3{-1, 3, 5}}) {
      const BeamPower3 power({axis, 90, falloff});
      const Enclosure bounds = power.share(kOctant).bounds();
      EXPECT_GE(bounds.lower, 0);
      EXPECT_LE(bounds.upper, 0x1p-960);
      EXPECT_EQ(bounds.upper > 0, power.meets(kOctant) != BeamPower3::Meets::kNothing);
    }
}

TEST(BeamPower3, DirectionsAreOfAnyLength) {
  for (const Rational& falloff : {Rational(0), Rational(1, 2), Rational(1'000'000)}) {
    const Beam3 plain{{3, 4, 5}, 50, falloff};
    for (const char* length : {"1e300", "1e308", "1e-330", "1e400", "1e-4000"}) {
      const Rational by = *parse_rational(length);
      const BeamPower3 power({{3 * by, 4 * by, 5 * by}, 50, falloff});
      EXPECT_EQ(power.share(kOctant).bounds(), BeamPower3(plain).share(kOctant).bounds()) << length;
      EXPECT_EQ(power.intensity(vector(2, 3, 4)), BeamPower3(plain).intensity(vector(2, 3, 4))) << length;
    }
  }
}

TEST(BeamPower3, RightAnglesToTheAxisAreDarkWhereTheIntensityFalls) {
  for (const Rational& falloff : {Rational(1, 1000), Rational(1, 2), Rational(1), Rational(1'000'000)}) {
    const BeamPower3 power({{3, 7, 11}, 180, falloff});
    for (const IntegerVector& way : {vector(7, -3, 0), vector(0, 11, -7), vector(-7, 3, 0)}) {
      EXPECT_EQ(power.side(way), 0);
      EXPECT_EQ(power.intensity(way), 0) << falloff;
      EXPECT_EQ(power.uncut_intensity(way), 0) << falloff;
    }
    EXPECT_EQ(power.uncut_intensity(vector(-3, -7, -11)), 0);
  }
  // Beside them the cosine has all its digits: 1 / 10^k.
  for (const int k : {3, 9, 20, 300}) {
    Integer far;
    mpz_ui_pow_ui(far.get_mpz_t(), 10, static_cast<unsigned long>(k));
    const BeamPower3 power({{0, 0, 1}, 90, Rational(1, 2)});
    const double expected = std::pow(10.0, -k / 2.0) * power.intensity(vector(0, 0, 1));
    EXPECT_NEAR(power.intensity({far, Integer(0), Integer(1)}), expected, 1e-6 * expected) << k;
    EXPECT_GT(power.intensity({far, Integer(0), Integer(1)}), 0.999999 * expected);
  }
}

// A beam of 10^-1000 degrees, half of it in the cone.
TEST(BeamPower3, BeamsMayBeAsNarrowAsTheyLike) {
  Integer large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 1000);
  for (const Rational& n : {Rational(0), Rational(1), Rational(5, 2)})
    EXPECT_DOUBLE_EQ(share({{1, 1, 0}, Rational(1) / Rational(large), n}, kOctant), 0.5) << n;
  // Beside its edge by as much as it is wide, nearly: in radians 10^-1000 of a degree is 0.0174.. of this unit.
  EXPECT_EQ(share({{large, large, -1}, Rational(1) / Rational(large), 0}, kOctant), 0);
  const double part = share({{large * 1000, large * 1000, -10}, Rational(1) / Rational(large), 0}, kOctant);
  // The segment of a disc of radius 1 beyond the distance d.
  const double d = 0.01 / std::sqrt(2.0) / (kPi / 180);
  EXPECT_NEAR(part, (std::acos(d) - d * std::sqrt(1 - d * d)) / kPi, 1e-15);
}

TEST(BeamPower3, TurnsWithItsAxis) {
  std::mt19937_64 engine(11);
  // A rotation by 3/5, 4/5 about z and then about x, times 25.
  const auto turned = [](const IntegerVector& a) -> IntegerVector {
    const Integer x = 3 * a.x - 4 * a.y, y = 4 * a.x + 3 * a.y, z = 5 * a.z;
    return {5 * x, 3 * y - 4 * z, 4 * y + 3 * z};
  };
  for (int n = 0; n < 60; ++n) {
    const ExactCone3 cone = random_cone(engine, 9, 5);
    Beam3 beam = random_beam(engine, cone.corners[0]);
    const double before = share(beam, cone);
    std::vector<IntegerVector> corners;
    for (const IntegerVector& c : cone.corners) corners.push_back(turned(c));
    const IntegerVector axis = turned({beam.axis.x.get_num(), beam.axis.y.get_num(), beam.axis.z.get_num()});
    beam.axis = {axis.x, axis.y, axis.z};
    EXPECT_DOUBLE_EQ(share(beam, cone_of(corners)), before) << n;
  }
}

TEST(BeamPower3, ItsIntensityIsThatOfItsPower) {
  EXPECT_DOUBLE_EQ(BeamPower3({}).intensity(vector(1, 2, 3)), 1 / (4 * kPi));
  EXPECT_DOUBLE_EQ(BeamPower3({{0, 0, 2}, 60, 0}).intensity(vector(0, 1, 1)), 1 / kPi);
  EXPECT_EQ(BeamPower3({{0, 0, 2}, 60, 0}).intensity(vector(0, 2, 1)), 0);
  EXPECT_DOUBLE_EQ(BeamPower3({{0, 0, 2}, 60, 2}).intensity(vector(0, 1, 1)), 0.5 * 3 / (2 * kPi * (1 - 1.0 / 8)));
  EXPECT_DOUBLE_EQ(BeamPower3({{0, 0, 2}, 180, 2}).intensity(vector(0, 1, 1)), 0.5 * 3 / (2 * kPi));  // cut to 90
  EXPECT_EQ(BeamPower3({{0, 0, 2}, 180, 2}).intensity(vector(0, 1, 0)), 0);
  EXPECT_EQ(BeamPower3({{0, 0, 2}, 180, 2}).intensity(vector(0, 1, -1)), 0);
  EXPECT_DOUBLE_EQ(BeamPower3({{0, 0, 2}, 120, 0}).intensity(vector(0, 3, -1)), 1 / (3 * kPi));
}

TEST(Beam3, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(beam_problem({}), "");
  EXPECT_NE(beam_problem({{0, 0, 0}, 20, 0}), "");
  EXPECT_NE(beam_problem({{0, 0, 1}, 0, 0}), "");
  EXPECT_NE(beam_problem({{0, 0, 1}, Rational(361, 2), 0}), "");
  EXPECT_NE(beam_problem({{0, 0, 1}, 20, Rational(-1, 2)}), "");
  EXPECT_EQ((Beam3{{0, 0, 1}, 120, 1}.reach()), 90);
  EXPECT_EQ((Beam3{{0, 0, 1}, 120, 0}.reach()), 120);
}

}  // namespace
}  // namespace hottel::beam_test
