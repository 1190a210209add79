// The ends of colour bars.
#include "viewer/picture/fitted_scale.h"

#include <gtest/gtest.h>

#include <vector>

#include "viewer/picture/colour_map.h"

namespace hottel::fitted_scale_test {
namespace {

// A hundred walls of area 1 with values from 1 to 2, and a lamp.
std::vector<AreaValue> room(double lamp, double area) {
  std::vector<AreaValue> values{{lamp, area}};
  for (int k = 0; k <= 100; ++k) values.push_back({1 + k / 100.0, 1});
  return values;
}

TEST(FittedScale, RunsFromTheLeastToTheGreatest) {
  const FittedScale fitted = fitted_scale({{3, 1}, {1, 1}, {2, 5}}, {}, {});
  EXPECT_EQ(fitted.scale.lower, 1);
  EXPECT_EQ(fitted.scale.upper, 3);
  EXPECT_FALSE(fitted.scale.cuts_lower || fitted.scale.cuts_upper);
}

TEST(FittedScale, ALampDoesNotFlattenARoom) {
  const FittedScale fitted = fitted_scale(room(1000, 2), {}, {});
  EXPECT_EQ(fitted.scale.lower, 1);
  EXPECT_EQ(fitted.scale.upper, 1.97) << "beyond lie three walls and the lamp: 5 of 103, and a fourth is too much";
  EXPECT_TRUE(fitted.scale.cuts_upper);
  EXPECT_FALSE(fitted.scale.cuts_lower);
  EXPECT_EQ(fitted.least, 1);
  EXPECT_EQ(fitted.greatest, 1000);
  const FittedScale cold = fitted_scale(room(-1000, 2), {}, {});
  EXPECT_EQ(cold.scale.lower, 1.03);
  EXPECT_EQ(cold.scale.upper, 2);
  EXPECT_TRUE(cold.scale.cuts_lower);
}

TEST(FittedScale, AnEndIsCutOnlyWhereThatGivesMoreThanHalfOfTheBar) {
  EXPECT_EQ(fitted_scale(room(2.8, 2), {}, {}).scale.upper, 2.8);
  EXPECT_EQ(fitted_scale(room(3, 2), {}, {}).scale.upper, 1.97);
}

TEST(FittedScale, TheLargerALampTheMoreItMustStandOut) {
  EXPECT_EQ(fitted_scale(room(1000, 8), {}, {}).scale.upper, 1.98) << "two walls and the lamp are 10 of 109";
  EXPECT_EQ(fitted_scale(room(4, 8), {}, {}).scale.upper, 1.98);
  EXPECT_EQ(fitted_scale(room(3.8, 8), {}, {}).scale.upper, 3.8)
      << "what is cut off is to be twice as long as the rest";
  EXPECT_LE(fitted_scale(room(1000, 20), {}, {}).scale.upper, 2);
  EXPECT_EQ(fitted_scale(room(-1000, 8), {}, {}).scale.lower, 1.02);
  EXPECT_EQ(fitted_scale(room(1000, 8), {}, {.has_sign = true}).scale.upper, 1.98);
}

TEST(FittedScale, WhatHasMoreThanAFifthOfTheAreaIsShown) {
  EXPECT_EQ(fitted_scale(room(1000, 30), {}, {}).scale.upper, 1000);
  // It is the area that counts, however finely it is divided.
  std::vector<AreaValue> divided;
  for (const AreaValue& each : room(1000, 2)) divided.insert(divided.end(), 4, {each.value, each.area / 4});
  EXPECT_EQ(fitted_scale(divided, {}, {}).scale.upper, 1.97);
}

TEST(FittedScale, IsNotCutToOneColour) {
  std::vector<AreaValue> values{{900, 1}};
  values.insert(values.end(), 100, {300, 1});
  EXPECT_EQ(fitted_scale(values, {}, {}).scale.upper, 900);
}

TEST(FittedScale, WhatSixDigitsDoNotTellApartHasOneColour) {
  const FittedScale fitted = fitted_scale({{2, 1}, {2 + 1e-12, 1}}, {}, {});
  EXPECT_EQ(fitted.scale.lower, 2);
  EXPECT_EQ(fitted.scale.upper, 2);
  EXPECT_EQ(fitted.greatest, 2);
  EXPECT_FALSE(fitted.scale.cuts_upper);
}

TEST(FittedScale, OfASignIsAsFarOnBothSides) {
  const FittedScale fitted = fitted_scale({{-3, 1}, {1, 1}}, {}, {.has_sign = true});
  EXPECT_EQ(fitted.scale.lower, -3);
  EXPECT_EQ(fitted.scale.upper, 3);
  EXPECT_EQ(fitted.greatest, 1);
  const FittedScale lit = fitted_scale(room(1000, 2), {}, {.has_sign = true});
  EXPECT_EQ(lit.scale.lower, -1.97);
  EXPECT_EQ(lit.scale.upper, 1.97);
  EXPECT_TRUE(lit.scale.cuts_upper);
  EXPECT_FALSE(lit.scale.cuts_lower);
  const FittedScale nothing = fitted_scale({{-1e-12, 1}, {1e-13, 1}}, {}, {.has_sign = true, .noise = 1e-9});
  EXPECT_EQ(nothing.scale.lower, 0);
  EXPECT_EQ(nothing.scale.upper, 0);
  EXPECT_EQ(nothing.least, 0);
}

TEST(FittedScale, LogarithmicOnesAreWhole) {
  std::vector<AreaValue> values = room(1000, 2);
  values.push_back({0, 1});
  const FittedScale fitted = fitted_scale(values, {.is_logarithmic = true}, {});
  EXPECT_EQ(fitted.scale.lower, 1);
  EXPECT_EQ(fitted.scale.upper, 1000);
  EXPECT_TRUE(fitted.scale.has_zero);
  EXPECT_FALSE(fitted.scale.cuts_lower);
}

TEST(FittedScale, WhatIsAskedForWins) {
  const FittedScale fitted = fitted_scale(room(1000, 2), {.lower = 0, .upper = 500}, {});
  EXPECT_EQ(fitted.scale.lower, 0);
  EXPECT_EQ(fitted.scale.upper, 500);
  EXPECT_TRUE(fitted.scale.cuts_upper);
  EXPECT_FALSE(fitted.scale.cuts_lower);
  EXPECT_EQ(fitted_scale(room(3, 2), {.upper = 0.5}, {}).scale.lower, 0.5);
  const ScaleSense with_sign{.has_sign = true};
  EXPECT_EQ(fitted_scale(room(3, 2), {.upper = 7}, with_sign).scale.lower, -7);
  EXPECT_EQ(fitted_scale(room(3, 2), {.lower = -7}, with_sign).scale.upper, 7);
  EXPECT_EQ(fitted_scale({{1, 1}, {5, 1}}, {.lower = 0}, with_sign).scale.upper, 5);
}

TEST(FittedScale, OfNothingIsEmpty) {
  EXPECT_EQ(fitted_scale({}, {}, {}).scale.upper, 0);
  EXPECT_EQ(fitted_scale({}, {.is_logarithmic = true}, {}).scale.lower, 1);
}

}  // namespace
}  // namespace hottel::fitted_scale_test
