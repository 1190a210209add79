// Values of the finest elements from their parents.
#include "viewer/picture/shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace hottel::shading_test {
namespace {

// An element under a part of surface 0: digits of its path, and its area.
Element leaf(std::uint32_t part, const std::vector<int>& digits, double area = 1) {
  Element element;
  element.part = part;
  element.parts = 9;
  element.area.value = area;
  element.path = TreePath(digits);
  return element;
}

std::vector<Element> random_trees(std::mt19937& random) {
  std::vector<Element> elements;
  std::uniform_real_distribution<double> area(0.1, 1);
  for (std::uint32_t part = 0; part < 9; ++part) {
    const std::function<void(std::vector<int>)> grow = [&](const std::vector<int>& digits) {
      if (digits.size() == 4 || random() % 2 == 0) return elements.push_back(leaf(part, digits, area(random)));
      for (int digit = 0; digit < 4; ++digit) {
        std::vector<int> child = digits;
        child.push_back(digit);
        grow(child);
      }
    };
    grow({});
  }
  return elements;
}

std::vector<double> random_values(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> value(0.1, 10);
  std::vector<double> result(count);
  for (double& v : result) v = value(random);
  return result;
}

TEST(Shading, HasItsNames) {
  EXPECT_EQ(shading_of("flat"), Shading::kFlat);
  EXPECT_EQ(shading_of("smooth"), Shading::kSmooth);
  EXPECT_EQ(shading_of("parents"), Shading::kParents);
  EXPECT_EQ(shading_of("Smooth"), std::nullopt);
}

TEST(ValuesFromParents, AreMeansByAreasOfTheDeepestLevel) {
  const std::vector<Element> elements{leaf(0, {}),     leaf(1, {0}),    leaf(1, {1, 0}), leaf(1, {1, 1}, 3),
                                      leaf(1, {1, 2}), leaf(1, {1, 3}), leaf(1, {2}),    leaf(1, {3}),
                                      leaf(2, {0}, 2), leaf(2, {1}, 2)};
  const std::vector<double> values{7, 1, 2, 3, 4, 5, 6, 7, 10, 20};
  const double mean = (2 + 3 * 3 + 4 + 5) / 6.0;
  EXPECT_EQ(values_from_parents(elements, values, 1),
            (std::vector<double>{7, 1, mean, mean, mean, mean, 6, 7, 15, 15}));
}

TEST(ValuesFromParents, KeepFrontsFromBacks) {
  std::vector<Element> elements{leaf(0, {0}), leaf(0, {1}), leaf(0, {0}), leaf(0, {1})};
  elements[2].is_back = elements[3].is_back = true;
  EXPECT_EQ(values_from_parents(elements, std::vector<double>{1, 3, 5, 9}, 1), (std::vector<double>{2, 2, 7, 7}));
}

// (2).
TEST(ValuesFromParents, KeepTheLightOfAFace) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const std::vector<Element> elements = random_trees(random);
    const std::vector<double> before = random_values(elements.size(), random);
    const std::vector<double> after = values_from_parents(elements, before, 1);
    double light_before = 0, light_after = 0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
      light_before += elements[k].area.value * before[k];
      light_after += elements[k].area.value * after[k];
    }
    EXPECT_NEAR(light_after, light_before, 1e-12 * light_before);
    EXPECT_NE(after, before);
  }
}

// (3), of each channel by itself.
TEST(ValuesFromParents, StayWithinTheirSiblings) {
  std::mt19937 random(6);
  for (int round = 0; round < 20; ++round) {
    const std::vector<Element> elements = random_trees(random);
    const std::vector<double> before = random_values(3 * elements.size(), random);
    const std::vector<double> after = values_from_parents(elements, before, 3);
    for (std::size_t k = 0; k < after.size(); ++k) {
      const Element& element = elements[k / 3];
      if (element.path.depth() == 0) continue;
      double least = before[k], most = before[k];
      for (std::size_t j = k % 3; j < before.size(); j += 3)
        if (elements[j / 3].part == element.part && element.path.parent().holds(elements[j / 3].path)) {
          least = std::min(least, before[j]);
          most = std::max(most, before[j]);
        }
      EXPECT_GE(after[k], least);
      EXPECT_LE(after[k], most);
    }
    const std::vector<double> equal(elements.size(), 0.1 * round + 0.7);
    EXPECT_EQ(values_from_parents(elements, equal, 1), equal);
  }
}

TEST(ValuesFromParents, WhatHasNoValueCountsForNothing) {
  const double none = std::nan("");
  const std::vector<Element> elements{leaf(0, {0}), leaf(0, {1}), leaf(0, {2}),
                                      leaf(0, {3}), leaf(1, {0}), leaf(1, {1})};
  const std::vector<double> after = values_from_parents(elements, std::vector<double>{1, none, 2, 6, none, none}, 1);
  EXPECT_EQ(after[0], 3);
  EXPECT_TRUE(std::isnan(after[1]));
  EXPECT_EQ(after[2], 3);
  EXPECT_TRUE(std::isnan(after[4]) && std::isnan(after[5]));
}

}  // namespace
}  // namespace hottel::shading_test
