// Every expectation that a scene of scenes/analytic/space/ carries; the limit of a sphere; rows of the scenes to look
// at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/decimal.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::analytic_scenes_test {
namespace {

namespace fs = std::filesystem;

// What pairs of these scenes are off at most, of the smaller area; the default is 1e-9.
constexpr double kTolerance = 1e-13;

fs::path folder() { return fs::path(HOTTEL_SOURCE_DIR) / "scenes"; }

std::vector<std::string> stems() {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(folder() / "analytic" / "space"))
    if (entry.path().extension() == ".json") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

ExchangeMatrix factors_of(const PreparedScene3& prepared, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepared, {.granularity = granularity, .wants_visibility = false, .tolerance = kTolerance});
}

double row_sum(const ExchangeMatrix& matrix, std::uint32_t i) {
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
  return sum;
}

class AnalyticScenes3 : public testing::TestWithParam<std::string> {};

TEST_P(AnalyticScenes3, HaveTheValuesOfTheirFile) {
  const PreparedScene3 prepared = prepare(read_scene_3(folder() / "analytic" / "space" / (GetParam() + ".json")));
  const ExchangeMatrix faces = factors_of(prepared), groups = factors_of(prepared, Granularity::kGroup);
  const RadiositySolution light = solve_radiosity(faces, prepared.scene.materials, prepared.scene.sky_emission);
  EXPECT_FALSE(prepared.scene.expect.empty());
  for (const Expectation& row : prepared.scene.expect) {
    const double expected = to_double(parse_rational(row.value).value());
    EXPECT_FALSE(row.derivation.empty()) << row.name;
    if (row.quantity == "radiosity") {
      const ElementRadiosity& element = light.channels.at(0).elements.at(faces.find(row.of.at(0)).value());
      EXPECT_NEAR(element.radiosity, expected, 1e-12) << row.name;
      continue;
    }
    ASSERT_TRUE(row.quantity == "factor" || row.quantity == "group_factor") << row.name;
    const ExchangeMatrix& matrix = row.quantity == "factor" ? faces : groups;
    const std::uint32_t from = matrix.find(row.of.at(0)).value();
    double sum = 0, lower = 0, upper = 0;
    for (std::size_t k = 0; k < matrix.row(from).size(); ++k) {
      const FactorEntry& entry = matrix.row(from)[k];
      if (std::find(row.of.begin() + 1, row.of.end(), matrix.name(entry.to)) == row.of.end()) continue;
      sum += entry.factor.value;
      lower += matrix.bounds(from, k).lower;
      upper += matrix.bounds(from, k).upper;
    }
    EXPECT_NEAR(sum, expected, 1e-12) << row.name;
    EXPECT_LE(lower, expected * (1 + 1e-15)) << row.name;
    EXPECT_GE(upper, expected * (1 - 1e-15)) << row.name;
  }
}

// Proven: whatever is asked, the values of the file, to the digits that it has, are within bounds as narrow as that.
TEST_P(AnalyticScenes3, HaveTheValuesOfTheirFileWithinProvenBounds) {
  const PreparedScene3 prepared = prepare(read_scene_3(folder() / "analytic" / "space" / (GetParam() + ".json")));
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const auto proven = [&](Granularity granularity) {
      ExchangeMatrix matrix = exact_exchange(
          prepared, {.granularity = granularity, .wants_visibility = false, .tolerance = tolerance, .proves = true});
      EXPECT_NO_THROW(require_enclosed_3(matrix, tolerance));
      return matrix;
    };
    const ExchangeMatrix faces = proven(Granularity::kFace), groups = proven(Granularity::kGroup);
    const RadiositySolution light = solve_radiosity(faces, prepared.scene.materials, prepared.scene.sky_emission);
    for (const Expectation& row : prepared.scene.expect) {
      const double expected = to_double(parse_rational(row.value).value()), slack = 1e-15 * expected;
      if (row.quantity == "radiosity") {
        const ElementRadiosity& element = light.channels.at(0).elements.at(faces.find(row.of.at(0)).value());
        EXPECT_LE(element.lower - slack, expected) << row.name;
        EXPECT_GE(element.upper + slack, expected) << row.name;
        continue;
      }
      const ExchangeMatrix& matrix = row.quantity == "factor" ? faces : groups;
      const std::uint32_t from = matrix.find(row.of.at(0)).value();
      double lower = 0, upper = 0;
      for (std::size_t k = 0; k < matrix.row(from).size(); ++k) {
        if (std::find(row.of.begin() + 1, row.of.end(), matrix.name(matrix.row(from)[k].to)) == row.of.end()) continue;
        lower += matrix.bounds(from, k).lower;
        upper += matrix.bounds(from, k).upper;
      }
      EXPECT_LE(lower - slack, expected) << row.name;
      EXPECT_GE(upper + slack, expected) << row.name;
      EXPECT_LE(upper - lower, 64 * tolerance) << row.name;
    }
  }
}

TEST_P(AnalyticScenes3, HaveClosedRows) {
  const ExchangeMatrix matrix =
      factors_of(prepare(read_scene_3(folder() / "analytic" / "space" / (GetParam() + ".json"))));
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (matrix.has_row(i)) {
      EXPECT_NEAR(row_sum(matrix, i), 1, 1e-12) << matrix.name(i);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, AnalyticScenes3, testing::ValuesIn(stems()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

// A sphere from inside: an octahedron whose triangles are divided into n^2, with corners pushed out to radius 1, as
// doubles, and the face toward its middle.
Scene3 sphere(int n) {
  std::string text =
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.9, "emission": 1}}, "polygons": [)";
  const auto corner = [n](int sx, int sy, int sz, int i, int j) {
    const double x = sx * (n - i - j), y = sy * i, z = sz * j, r = std::hypot(x, y, z);
    std::string result = "[";
    for (const double c : {x, y, z}) result += (result.size() > 1 ? "," : "") + shortest(c / r);
    return result + "]";
  };
  bool is_first = true;
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1, sz = (octant & 4) != 0 ? -1 : 1;
    const auto add = [&](const std::string& a, const std::string& b, const std::string& c) {
      text += std::string(is_first ? "" : ",") + R"({"points": [)" +
              (sx * sy * sz > 0 ? a + "," + c + "," + b : a + "," + b + "," + c) + R"(], "material": "m"})";
      is_first = false;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(corner(sx, sy, sz, i, j), corner(sx, sy, sz, i + 1, j), corner(sx, sy, sz, i, j + 1));
        if (i + j + 2 <= n)
          add(corner(sx, sy, sz, i + 1, j), corner(sx, sy, sz, i + 1, j + 1), corner(sx, sy, sz, i, j + 1));
      }
  }
  return parse_scene_3(text + R"(], "closed": true})", "sphere");
}

// In a sphere F(i, j) = A_j / (4 pi R^2) for all i. Of a mesh of triangles the root mean square of the deviations, in
// parts of it and weighted by it, falls with refinement: a plane triangle does not see itself, nor much of those
// beside.
TEST(SphereLimit3, FactorsTendToTheShareOfTheArea) {
  double before = 0;
  for (const int n : {1, 2, 4}) {
    const ExchangeMatrix matrix = factors_of(prepare(sphere(n)), Granularity::kElement);
    double area = 0, squares = 0, weights = 0;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) area += matrix.elements()[i].area.value;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      EXPECT_NEAR(row_sum(matrix, i), 1, 1e-12) << n;
      for (std::uint32_t j = 0; j < matrix.size(); ++j) {
        if (!matrix.has_row(j)) continue;
        const double limit = matrix.elements()[j].area.value / (4 * std::numbers::pi);
        const double f = i == j ? 0 : matrix.factor(i, j).value;
        squares += std::pow(f - limit, 2) / limit;
        weights += limit;
      }
    }
    const double error = std::sqrt(squares / weights);
    if (before > 0) {
      EXPECT_LT(error, before / 1.6) << n;
    }
    EXPECT_GT(area, before == 0 ? 6 : 7);
    before = error;
  }
  EXPECT_LT(before, 0.3);
}

// In a closed room that emits 1 and reflects 0.9 everywhere all is 1 / (1 - 0.9), whatever its shape.
TEST(SphereLimit3, ALitSphereIsEvenlyBright) {
  const PreparedScene3 prepared = prepare(sphere(2));
  const ExchangeMatrix matrix = factors_of(prepared);
  const RadiositySolution light = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (matrix.has_row(i)) {
      EXPECT_NEAR(light.channels[0].elements[i].radiosity, 10, 1e-10);
    }
  }
}

// Two cubes, one in the other, that approach each other: what a face of the inner one sends out arrives at the face of
// the outer one before it, all of it in the limit.
TEST(NestedCubes3, FacesNearEachOtherSeeNothingElseInTheLimit) {
  double before = 1;
  for (const std::string gap : {"1/8", "1/64", "1/512"}) {
    const Rational d = parse_rational(gap).value();
    const auto at = [&](int side, const Rational& shift) { return to_string(Rational(side) + shift); };
    const std::string a = '"' + at(0, d) + '"', b = '"' + at(1, -d) + '"';
    const auto square = [](const std::string& name, const std::string& z, const std::string& p, const std::string& q,
                           bool is_up) {
      const std::string corners[4] = {p + "," + p, q + "," + p, q + "," + q, p + "," + q};
      std::string points;
      for (int k = 0; k < 4; ++k) points += (k > 0 ? ",[" : "[") + corners[is_up ? k : 3 - k] + "," + z + "]";
      return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": "m"})";
    };
    const ExchangeMatrix matrix = factors_of(
        prepare(parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [)" +
                                  square("outer", "0", "0", "1", true) + "," + square("inner", a, a, b, false) + "]}",
                              "nested")));
    const double rest = 1 - matrix.factor("inner", "outer").value;
    EXPECT_GT(rest, 0);
    EXPECT_LT(rest, before / 4);
    // Reciprocity bounds what comes back: no more than the share of the areas.
    EXPECT_LE(matrix.factor("outer", "inner").value, to_double(Rational((1 - 2 * d) * (1 - 2 * d))));
    before = rest;
  }
}

// Scenes to look at: rows sum to 1, the sky included, and only where the scene is not closed is it seen.
class ScenesInSpace3 : public testing::TestWithParam<std::string> {};

TEST_P(ScenesInSpace3, HaveClosedRows) {
  const PreparedScene3 prepared = prepare(read_scene_3(folder() / (GetParam() + ".json")));
  const ExchangeMatrix matrix = exact_exchange(prepared, {.wants_visibility = false});
  double to_sky = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    EXPECT_NEAR(row_sum(matrix, i), 1, 1e-9) << matrix.name(i);
    to_sky += matrix.factor(i, matrix.sky()).value;
  }
  EXPECT_EQ(to_sky > 0, !prepared.scene.closed);
}

INSTANTIATE_TEST_SUITE_P(, ScenesInSpace3,
                         testing::Values("space/cornell_box", "space/attic", "space/city_block", "space/duct",
                                         "space/pierced_triangles"),
                         [](const auto& test) { return test.param.substr(test.param.find('/') + 1); });

}  // namespace
}  // namespace hottel::analytic_scenes_test
