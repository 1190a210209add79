#include "solver/radiosity/radiosity_sources.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include "kernel/support/failure.h"
#include "solver/radiosity/lazy.h"
#include "solver/radiosity/printed_number.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel::radiosity_sources_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(SourceSpectrum, LosesNothingOfNumbersThatAreKnown) {
  const Rational third(1, 3), huge = *parse_rational("1e400");
  const SourceSpectrum spectrum = Spectrum{{third, huge, 0}, false};
  EXPECT_EQ(spectrum[0], (RationalEnclosure{third, third}));
  EXPECT_EQ(spectrum[1], (RationalEnclosure{huge, huge}));
  EXPECT_EQ(spectrum[2], RationalEnclosure{});
  EXPECT_FALSE(spectrum.is_scalar());
  for (const End end : {End::kLower, End::kMiddle, End::kUpper}) EXPECT_EQ(spectrum.at(end), spectrum);
  EXPECT_TRUE(SourceSpectrum(Spectrum::scalar(third)).is_scalar());
}

TEST(SourceSpectrum, IsNothingByDefault) {
  const SourceSpectrum nothing;
  EXPECT_TRUE(nothing.is_scalar());
  EXPECT_EQ(nothing, SourceSpectrum(Spectrum::scalar(0)));
  EXPECT_EQ(nothing, SourceSpectrum::scalar({0, 0}));
  EXPECT_EQ(nothing.at(End::kUpper), nothing);
}

TEST(SourceSpectrum, HasThreeNumbersOfAnEnclosure) {
  const SourceSpectrum spectrum = SourceSpectrum::of({Enclosure{1, 2}, {3, 3}, {0, 1}});
  EXPECT_EQ(spectrum.at(End::kLower)[0].upper, 1);
  EXPECT_EQ(spectrum.at(End::kMiddle)[0].lower, Rational(3, 2));
  EXPECT_EQ(spectrum.at(End::kUpper)[2].lower, 1);
  EXPECT_EQ(spectrum.at(End::kMiddle)[1], spectrum[1]);
  EXPECT_FALSE(spectrum.at(End::kLower).is_scalar());
  EXPECT_EQ(SourceSpectrum::scalar({1, 2})[2], (RationalEnclosure{1, 2}));
}

TEST(SourceSpectrum, RefusesWhatIsNoSource) {
  EXPECT_THROW(SourceSpectrum::scalar({-1, 1}), ContractViolation);
  EXPECT_THROW(SourceSpectrum::scalar({2, 1}), ContractViolation);
  EXPECT_THROW(SourceSpectrum::scalar({0, kInfinity}), ContractViolation);
  EXPECT_THROW(SourceSpectrum::scalar({NAN, NAN}), ContractViolation);
  EXPECT_THROW(SourceSpectrum(Spectrum::scalar(-1)), ContractViolation);
}

TEST(RadiositySources, KeepWhatIsSharedAtTheirEnds) {
  const SourceSpectrum within = SourceSpectrum::scalar({1, 2}), other = SourceSpectrum::scalar({1, 3});
  const RadiositySources sources{{within, other, within}, {{}, within, {}}, other, {}, true, {}, false};
  const RadiositySources upper = sources.at(End::kUpper);
  EXPECT_EQ(upper.emission[0][0].lower, 2);
  EXPECT_EQ(upper.emission[1][0].lower, 3);
  EXPECT_EQ(&upper.emission[0][0], &upper.emission[2][0]);
  EXPECT_EQ(&upper.emission[0][0], &upper.direct_irradiance[1][0]);
  EXPECT_EQ(upper.direct_irradiance[0], SourceSpectrum());
  EXPECT_EQ(upper.sky[0].upper, 3);
  EXPECT_TRUE(upper.has_channels);
}

TEST(ScaledBall, AroundTwoNumbersEnclosesAllBetween) {
  std::mt19937_64 random(1);
  const auto draw = [&] {
    const Rational part(static_cast<unsigned long>(random() >> 12), static_cast<unsigned long>(random() >> 30) + 1);
    return scaled_by_power_of_two(part, static_cast<long>(random() % 3000) - 1500);
  };
  const auto exact = [](double value, int exponent) { return scaled_by_power_of_two(Rational(value), exponent); };
  for (int k = 0; k < 10'000; ++k) {
    const Rational lower = k % 10 == 0 ? Rational(0) : draw();
    const Rational wider = k % 3 == 0   ? Rational(0)
                           : k % 3 == 1 ? Rational(scaled_by_power_of_two(lower, -static_cast<long>(random() % 120)))
                                        : draw();
    const Rational upper = lower + wider;
    const ScaledBall ball = ScaledBall::around(lower, upper);
    const DoubleDoubleBall& m = ball.mantissa;
    const Rational middle = exact(m.hi, ball.exponent) + exact(m.lo, ball.exponent);
    const Rational radius = exact(m.radius, ball.exponent);
    EXPECT_LE(middle - radius, lower);
    EXPECT_GE(middle + radius, upper);
    EXPECT_LE(2 * radius, wider * (1 + Rational(1, Integer(1) << 45)) + scaled_by_power_of_two(upper, -100));
    if (wider == 0) {
      EXPECT_EQ(m.radius, ScaledBall::of(lower).mantissa.radius);
    }
  }
}

TEST(PrintedNumbers, AreTheNearestDoublesAround) {
  const Rational third(1, 3), huge = *parse_rational("1e400");
  EXPECT_EQ(rounded_up(third), std::nextafter(rounded_down(third), 1));
  EXPECT_LT(Rational(rounded_down(third)), third);
  EXPECT_EQ(rounded_down(-third), -rounded_up(third));
  EXPECT_EQ(rounded_down(Rational(1, 2)), 0.5);
  EXPECT_EQ(rounded_up(Rational(1, 2)), 0.5);
  EXPECT_EQ(rounded_up(huge), kInfinity);
  EXPECT_EQ(rounded_down(huge), std::numeric_limits<double>::max());
  EXPECT_EQ(rounded_up(-huge), -std::numeric_limits<double>::max());
  EXPECT_EQ(rounded_down(-huge), -kInfinity);
  EXPECT_EQ(rounded_up(1 / huge), std::numeric_limits<double>::denorm_min());
  const Printed printed({third, 1});
  EXPECT_EQ(printed.nearest, to_double(Rational(2, 3)));
  EXPECT_EQ(printed.lower, rounded_down(third));
  EXPECT_EQ(printed.upper, 1);
}

TEST(Lazy, IsMadeByOneOfManyThreadsAndAnewAfterAFailure) {
  const Lazy<int> value;
  EXPECT_THROW(value.get([]() -> std::unique_ptr<int> { throw std::runtime_error("not yet"); }), std::runtime_error);
  std::atomic<int> made{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
    threads.emplace_back([&] {
      EXPECT_EQ(value.get([&] {
        ++made;
        return std::make_unique<int>(7);
      }),
                7);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace hottel::radiosity_sources_test
