// Temperatures read off what a material emits.
#include "geometry/gray_temperature.h"

#include <gtest/gtest.h>

namespace hottel::gray_temperature_test {
namespace {

Material grey(const Rational& emissivity, const Rational& temperature) {
  Material material;
  set_gray_body(Spectrum::scalar(emissivity), Spectrum::scalar(temperature), material);
  return material;
}

TEST(GrayTemperature, IsTheOneThatWasTyped) {
  for (const char* typed : {"300", "0.1", "1/3", "293.15", "1e-9", "5778", "0"})
    for (const char* emissivity : {"1", "0.3", "1/7", "1e-12"})
      EXPECT_EQ(gray_temperature(grey(*parse_rational(emissivity), *parse_rational(typed))), *parse_rational(typed))
          << typed;
}

TEST(GrayTemperature, IsNothingForALampOrAWhiteWall) {
  Material lamp;
  lamp.reflectivity = Spectrum::scalar(Rational(1, 10));
  lamp.emission = Spectrum::scalar(10);
  EXPECT_EQ(gray_temperature(lamp), std::nullopt);
  EXPECT_EQ(gray_temperature(grey(0, 300)), std::nullopt);
  lamp.reflectivity = Spectrum::scalar(1);  // emits and absorbs nothing
  EXPECT_EQ(gray_temperature(lamp), std::nullopt);
}

TEST(GrayTemperature, IsOneForAllChannels) {
  Material material;
  set_gray_body({{1, Rational(1, 2), 0}, false}, Spectrum::scalar(400), material);
  EXPECT_EQ(gray_temperature(material), Rational(400));
  set_gray_body(Spectrum::scalar(1), {{400, 400, 500}, false}, material);
  EXPECT_EQ(gray_temperature(material), std::nullopt);
}

}  // namespace
}  // namespace hottel::gray_temperature_test
