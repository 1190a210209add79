#include "geometry/space/unobstructed/log_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "kernel/wide_real.h"

namespace hottel::log_distance_test {
namespace {

using Vector = LocalVector3<double>;

template <class Real>
LocalVector3<Real> in(const Vector& a) {
  return {Real(a.x), Real(a.y), Real(a.z)};
}

struct Edges {
  Vector d, u, v;  // of few digits, so that differences of ends are exact
  EdgeContact3 contact = EdgeContact3::kNone;
};

template <class Real>
Approximation<Real> mean_of(const Edges& edges, double tolerance) {
  const EdgePair3<Real> pair{in<Real>(edges.d), in<Real>(edges.u), in<Real>(edges.v), 0};
  if (const auto mean = mean_log_of_distant(pair, tolerance)) return *mean;
  return mean_log_of_near(pair, edges.contact, tolerance);
}

class LogDistance3 : public ::testing::Test {
 protected:
  double number(int bits = 6) {
    const int most = 1 << bits;
    return std::ldexp(std::uniform_int_distribution<int>(-most, most)(engine_), -bits);
  }
  Vector vector() { return {number(), number(), number()}; }
  Vector vector_not_zero() {
    for (;;)
      if (const Vector a = vector(); square(a) > 0) return a;
  }
  // Two that are not parallel.
  Edges crossing() {
    for (;;)
      if (const Edges e{vector(), vector_not_zero(), vector_not_zero()}; square(cross(e.u, e.v)) > 0) return e;
  }
  Edges joint() {
    Edges e = crossing();
    e.d = {};
    e.contact = EdgeContact3::kJoint;
    return e;
  }
  Edges end_on() {
    Edges e = crossing();
    e.d = -0.25 * e.v;
    e.contact = EdgeContact3::kEndOn;
    return e;
  }
  Edges parallel(double apart) {
    Edges e{{0, 0, 0}, vector_not_zero(), {}, EdgeContact3::kParallel};
    e.v = (number(2) >= 0 ? 0.5 : -1.25) * e.u;
    e.d = number(2) * e.u + apart * vector();
    return e;
  }
  // Parallel ones, one of them tilted a little, beside each other, on one line or crossing.
  Edges nearly_parallel(double apart, double tilt) {
    Edges e = parallel(apart);
    e.contact = EdgeContact3::kNone;
    const Vector before = e.v;
    e.v = before + tilt * vector_not_zero();
    if (apart == 0) e.d = e.d - 0.5 * (e.v - before);
    return e;
  }
  // The lines come as near as `gap`, somewhere along both.
  Edges nearly_crossing(double gap) {
    Edges e = crossing();
    const Vector across = cross(e.u, e.v);
    e.d = 0.5 * e.u - 0.25 * e.v + gap * across;
    return e;
  }

 private:
  std::mt19937_64 engine_{5};
};

// Numbers in three precisions agree to within what they say of themselves, whatever the edges.
void expect_agreement(const Edges& edges, double tolerance, const std::string& what) {
  const auto fine = mean_of<WideReal>(edges, 1e-30);
  EXPECT_LE(fine.error, 1.01e-30) << what;
  const auto less = mean_of<long double>(edges, tolerance);
  const auto least = mean_of<double>(edges, tolerance);
  EXPECT_LE(static_cast<double>(abs(WideReal(less.value) - fine.value)), less.error + fine.error) << what;
  EXPECT_LE(static_cast<double>(abs(WideReal(least.value) - fine.value)), least.error + fine.error) << what;
}

TEST_F(LogDistance3, ErrorsAreProven) {
  for (int round = 0; round < 40; ++round)
    for (const double tolerance : {1e-6, 1e-12, 1e-18}) {
      const std::string number = " of round " + std::to_string(round);
      expect_agreement(crossing(), tolerance, "edges" + number);
      expect_agreement(joint(), tolerance, "edges from one point" + number);
      expect_agreement(end_on(), tolerance, "an edge that begins on the other one" + number);
      expect_agreement(parallel(1), tolerance, "parallel edges" + number);
      expect_agreement(parallel(0), tolerance, "edges on one line" + number);
      for (const int power : {-3, -12, -30})
        expect_agreement(nearly_crossing(std::ldexp(1, power)), tolerance,
                         "edges in the distance 2^" + std::to_string(power) + number);
      if (round % 8 != 0) continue;  // these take long in many digits
      for (const int power : {-12, -20, -30, -38})
        for (const double apart : {0.0, std::ldexp(1, power), 0.125})
          expect_agreement(nearly_parallel(apart, std::ldexp(1, power)), tolerance,
                           "edges tilted by 2^" + std::to_string(power) + number);
    }
}

// Edges that are one but for 2^-340, which no number here tells: the mean is that of one with itself, -3/2, within
// 1e-100.
TEST_F(LogDistance3, EdgesThatAreAllButOneAreTakenAsOne) {
  const Edges edges{{0, 0, 0x1p-341}, {1, 0, 0}, {1, 0, -0x1p-340}};
  const auto in_doubles = mean_of<double>(edges, 1e-12);
  EXPECT_LE(in_doubles.error, 2e-12);
  EXPECT_NEAR(in_doubles.value, -1.5, in_doubles.error);
  const auto wide = mean_of<WideReal>(edges, 1e-60);
  EXPECT_LE(wide.error, 2e-60);
  EXPECT_LE(static_cast<double>(abs(wide.value + 1.5)), wide.error);
}

// Two edges of length 1 on one line, from one point: J = the integral of ln(s + t) = 2 ln 2 - 3/2; of one with itself:
// -3/2.
TEST_F(LogDistance3, WideNumbersHaveManyDigits) {
  const WideReal away = mean_of<WideReal>({{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, EdgeContact3::kParallel}, 1e-90).value;
  EXPECT_LT(static_cast<double>(abs(away - (2 * log(WideReal(2)) - 1.5))), 1e-93);
  const WideReal same = mean_of<WideReal>({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, EdgeContact3::kParallel}, 1e-90).value;
  EXPECT_LT(static_cast<double>(abs(same + 1.5)), 1e-93);
}

// Across a gap h of 2^-150: J is that of edges that meet, and some h^2 ln(1/h). Halves from the point where they meet.
TEST_F(LogDistance3, GapsWhoseSquaresAreLostAreNoTrouble) {
  const auto apart = mean_of<WideReal>({{0.5, -0.5, 0x1p-150}, {1, 0, 0}, {0, 1, 0}}, 1e-60);
  const auto joint = mean_of<WideReal>({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, EdgeContact3::kJoint}, 1e-60);
  EXPECT_LE(apart.error, 1.01e-60);
  EXPECT_LT(static_cast<double>(abs(apart.value - joint.value)), 1.01e-60);
}

}  // namespace
}  // namespace hottel::log_distance_test
