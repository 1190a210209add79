// Radiosities of scenes whose solution is known, and what is refused.
#include "solver/radiosity/radiosity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/support/failure.h"
#include "solver/radiosity/matrix_checks.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::radiosity_test {
namespace {

using namespace testing_radiosity;
using testing::HasSubstr;

const ElementRadiosity& of(const ExactScene& scene, const RadiositySolution& solution, const std::string& name,
                           std::size_t channel = 0) {
  return solution.channels.at(channel).elements.at(scene.matrix().find(name).value());
}

void expect_contains(const ElementRadiosity& e, const Rational& exact) {
  EXPECT_LE(Rational(e.lower), exact);
  EXPECT_GE(Rational(e.upper), exact);
}

double ulp(double value) { return std::nextafter(value, 1e300) - value; }

class AnalyticRadiosities : public testing::TestWithParam<const char*> {};

TEST_P(AnalyticRadiosities, AreRightToTheLastDigit) {
  const ExactScene scene(analytic_scene(GetParam()));
  const RadiositySolution solution = scene.solve();
  int rows = 0;
  for (const Expectation& row : scene.scene().expect) {
    if (row.quantity != "radiosity" || row.kind != "exact") continue;
    ++rows;
    const Rational exact = parse_rational(row.value).value();
    const ElementRadiosity& e = of(scene, solution, row.of.at(0));
    EXPECT_LE(std::abs(e.radiosity - to_double(exact)), ulp(to_double(exact))) << row.of.at(0);
    EXPECT_LE(e.upper - e.lower, 4 * ulp(e.upper)) << row.of.at(0);
    expect_contains(e, exact);
    EXPECT_EQ(e.net(), e.radiosity - e.irradiance);
    EXPECT_NEAR(e.net_value, e.net(), 4e-16 * (e.radiosity + e.irradiance));
  }
  EXPECT_GT(rows, 0);
  EXPECT_LE(std::abs(solution.energy.defect), 1e-14 * solution.energy.emitted);
  EXPECT_LE(solution.closure_defect, 1e-15);
  EXPECT_LE(solution.reciprocity_defect, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(, AnalyticRadiosities,
                         testing::Values("square_radiosity", "square_radiosity_bright", "furnace"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Radiosity, OfAFurnaceIsOneAndNothingFlows) {
  const ExactScene scene(analytic_scene("furnace"));
  const RadiositySolution solution = scene.solve();
  for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
    if (!scene.matrix().has_row(i)) continue;
    const ElementRadiosity& e = solution.channels[0].elements[i];
    EXPECT_EQ(e.radiosity, 1) << scene.matrix().elements()[i].name;
    EXPECT_EQ(e.irradiance, 1);
    EXPECT_EQ(e.net(), 0);
    EXPECT_NEAR(e.net_value, 0, 1e-30);
    expect_contains(e, 1);
    EXPECT_GE(e.lower, std::nextafter(1, 0));
    EXPECT_LE(e.upper, std::nextafter(1, 2));
  }
}

TEST(Radiosity, OfParallelPlatesUnderASkyIsTheClosedForm) {
  // Two mirror-symmetric plates of rho = 1/2: B = E + rho (F B + (1 - F) E_sky), F = sqrt(2) - 1.
  const ExactScene scene(scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"m": {"reflectivity": 0.5, "emission": 3}}, "sky": {"emission": 2},
    "edges": [{"name": "low", "points": [[1,0],[0,0]], "material": "m"},
              {"name": "high", "points": [[0,1],[1,1]], "material": "m"}]})"));
  const RadiositySolution solution = scene.solve();
  const mpf_class f = sqrt(mpf_class(2, kBits)) - 1;
  const mpf_class exact = (3 + (1 - f)) / (1 - f / 2);
  for (const char* name : {"low", "high"}) {
    const ElementRadiosity& e = of(scene, solution, name);
    EXPECT_LE(mpf_class(e.lower), exact);
    EXPECT_GE(mpf_class(e.upper), exact);
    EXPECT_LE(e.upper - e.lower, 2 * ulp(e.radiosity));
  }
  EXPECT_GT(solution.energy.to_sky, 0);
  EXPECT_NEAR(solution.energy.emitted, solution.energy.absorbed + solution.energy.to_sky, 1e-14);
}

TEST(Radiosity, OfTheTriangle345IsARationalNumber) {
  // F(3,4) = (3 + 4 - 5)/6 = 1/3, F(3,5) = 2/3, F(4,3) = 1/4, F(4,5) = 3/4, F(5,3) = 2/5, F(5,4) = 3/5.
  const ExactScene scene(scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"lamp": {"reflectivity": "1/3", "emission": 1}, "m": {"reflectivity": "1/2"}},
    "edges": [{"name": "a", "points": [[3,0],[0,0]], "material": "lamp"},
              {"name": "b", "points": [[0,0],[0,4]], "material": "m"},
              {"name": "c", "points": [[0,4],[3,0]], "material": "m"}]})"));
  const RadiositySolution solution = scene.solve();
  // b = (a/4 + 3c/4)/2, c = (2a/5 + 3b/5)/2, a = 1 + (b/3 + 2c/3)/3.
  const Rational b_of_a = (Rational(1, 8) + Rational(3, 8) * Rational(1, 5)) / (1 - Rational(3, 8) * Rational(3, 10));
  const Rational c_of_a = Rational(1, 5) + Rational(3, 10) * b_of_a;
  const Rational a = 1 / (1 - b_of_a / 9 - 2 * c_of_a / 9);
  const Rational exact[] = {a, Rational(a * b_of_a), Rational(a * c_of_a)};
  const char* names[] = {"a", "b", "c"};
  for (int k = 0; k < 3; ++k) {
    expect_contains(of(scene, solution, names[k]), exact[k]);
    EXPECT_LE(std::abs(of(scene, solution, names[k]).radiosity - to_double(exact[k])), ulp(to_double(exact[k])));
  }
}

// A dark box inside a lit room, and channels of their own.
constexpr const char* kBoxInRoom = R"({"hottel": 1, "dimension": 2,
  "materials": {"wall": {"reflectivity": [0.5, 0.5, 0.25]}, "lamp": {"emission": [9, 0, 1], "reflectivity": 0},
                "inside": {"reflectivity": 1}},
  "polylines": [{"name": "box", "points": [[1,1],[1,2],[2,2],[2,1]], "closed": true, "material": "inside",
                 "back": "wall"}],
  "edges": [{"name": "s", "points": [[4,0],[0,0]], "material": "lamp"},
            {"name": "w", "points": [[0,0],[0,4]], "material": "wall"},
            {"name": "n", "points": [[0,4],[4,4]], "material": "wall"},
            {"name": "e", "points": [[4,4],[4,0]], "material": "wall"}]})";

TEST(Radiosity, OfWhatNoLightReachesIsExactlyZero) {
  const ExactScene scene(scene_of(kBoxInRoom));
  const RadiositySolution solution = scene.solve();
  ASSERT_EQ(solution.channel_names, (std::vector<std::string>{"r", "g", "b"}));
  EXPECT_EQ(solution.factorizations, 2u);
  for (int k = 0; k < 4; ++k) {
    const ElementRadiosity& e = of(scene, solution, "box[" + std::to_string(k) + "]");
    EXPECT_EQ(e.radiosity, 0);
    EXPECT_EQ(e.lower, 0);
    EXPECT_EQ(e.upper, 0);
    EXPECT_EQ(e.irradiance, 0);
    EXPECT_EQ(e.net(), 0);
    EXPECT_EQ(e.net_value, 0);
  }
  ASSERT_EQ(solution.channels[0].dark.size(), 1u);
  EXPECT_EQ(solution.channels[0].dark[0].size, 4u);
  EXPECT_EQ(solution.channels[1].dark.size(), 2u);  // nothing is green
  EXPECT_EQ(of(scene, solution, "w", 1).upper, 0);
  EXPECT_GT(of(scene, solution, "w", 0).lower, 0);
  EXPECT_GT(of(scene, solution, "box[0]:back", 0).lower, 0);
  ASSERT_EQ(solution.notes.size(), 1u);
  EXPECT_THAT(solution.notes[0], HasSubstr("'box[0]'"));
  BoundsCheck check;
  Scene2 without_box = scene.scene();
  without_box.materials[2].reflectivity = Spectrum::scalar(Rational(1, 2));  // 0 all the same
  check.add(scene, solution, without_box.materials);
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
}

TEST(Radiosity, WhereAllIsReflectedAndSomethingEmitsIsRefusedByName) {
  Scene2 scene = scene_of(kBoxInRoom);
  for (Material& m : scene.materials)
    if (m.name == "inside") m.emission = Spectrum::scalar(1);
  try {
    ExactScene(scene).solve();
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'box[0]'"));
  }
}

TEST(Radiosity, OfWhatReflectsNearlyAllIsNotTakenForAMirror) {
  // 1 - 2^-1100 is 1 in doubles, and what is lost is 0.
  const ExactScene scene(analytic_scene("furnace"));
  std::vector<Material> materials = scene.scene().materials;
  for (Material& m : materials) m.reflectivity = Spectrum::scalar(1 - Rational(1, Integer(1) << 1100));
  const RadiositySolution bright = scene.solve(materials);
  for (const ElementRadiosity& e : bright.channels[0].elements) {
    if (e.reflectivity == 0) continue;  // the backs
    EXPECT_EQ(e.lower, std::numeric_limits<double>::max());
    EXPECT_EQ(e.upper, HUGE_VAL);
  }
  try {
    require_doubles(scene.matrix(), {}, bright);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the light of"));
    EXPECT_THAT(error.what(), HasSubstr("beyond the range of doubles"));
  }
  for (Material& m : materials) m.emission = Spectrum::scalar(Rational(1, Integer(1) << 1100));
  const RadiositySolution moderate = scene.solve(materials);
  for (const ElementRadiosity& e : moderate.channels[0].elements)
    if (e.reflectivity != 0) {
      EXPECT_EQ(e.lower, 1);
      EXPECT_EQ(e.upper, 1);
    }
}

TEST(Radiosity, OfPerfectReflectorsIsOrdinaryWhereLightGetsOut) {
  // Reflectivity 1 all round but for a black back (no material): E is all that comes, and it goes there.
  Scene2 scene = scene_of(R"({"hottel": 1, "dimension": 2,
    "materials": {"white": {"reflectivity": 1}, "lamp": {"reflectivity": 1, "emission": 1}},
    "edges": [{"name": "s", "points": [[1,0],[0,0]], "material": "lamp"},
              {"name": "w", "points": [[0,0],[0,1]], "material": "white"},
              {"name": "n", "points": [[1,1],[0,1]], "material": "white"},
              {"name": "e", "points": [[1,1],[1,0]], "material": "white"}]})");
  const ExactScene exact(scene);
  const RadiositySolution solution = exact.solve();
  BoundsCheck check;
  check.add(exact, solution, scene.materials);
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_LT(solution.max_relative_width, 1e-15);
  EXPECT_EQ(of(exact, solution, "w").net_value, 0);
  EXPECT_EQ(of(exact, solution, "s").net_value, 1);
  EXPECT_TRUE(solution.notes.empty());
}

TEST(Radiosity, OfNumbersBeyondTheRangeOfDoublesIsBounded) {
  Scene2 scene = analytic_scene("square_radiosity");
  for (Material& m : scene.materials)
    if (!m.emission.is_zero()) m.emission = Spectrum::scalar(parse_rational("1e400").value());
  const ExactScene exact(scene);
  const RadiositySolution solution = exact.solve();
  EXPECT_EQ(of(exact, solution, "top").upper, HUGE_VAL);
  EXPECT_LT(of(exact, solution, "top").lower, HUGE_VAL);
  scene.materials.back().reflectivity = Spectrum::scalar(parse_rational("1e-400").value());
  scene.materials[0].emission = Spectrum::scalar(1);
  const ExactScene other(scene);
  BoundsCheck check;
  check.add(other, other.solve(), scene.materials);
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
}

TEST(Radiosity, ThatWasChosenIsFoundAgain) {
  // Manufactured: E = B - rho F B from the factors to kBits, all of it exact input.
  const ExactScene polygon(convex_polygon(12));
  Scene2 scene = polygon.scene();
  const Rational rho(1, 2);
  std::vector<Rational> chosen;
  for (std::uint32_t i = 0; i < 12; ++i) chosen.emplace_back(10 + i * i % 7, 9);
  scene.materials.clear();
  for (std::uint32_t i = 0; i < 12; ++i) {
    mpf_class gathered(0, kBits);
    for (std::uint32_t j = 0; j < 12; ++j) {
      const std::uint32_t row = *polygon.matrix().find(scene.surfaces[i].name);
      const std::uint32_t to = *polygon.matrix().find(scene.surfaces[j].name);
      gathered += polygon.factors()[row][to] * number(chosen[j]);
    }
    const mpf_class emission = number(chosen[i]) - number(rho) * gathered;
    ASSERT_GE(emission, 0);
    scene.materials.push_back({"m" + std::to_string(i), Spectrum::scalar(rho), Spectrum::scalar(Rational(emission))});
    scene.surfaces[i].material = i;
  }
  const ExactScene made(scene);
  const RadiositySolution solution = made.solve();
  for (std::uint32_t i = 0; i < 12; ++i) {
    const ElementRadiosity& e = of(made, solution, scene.surfaces[i].name);
    EXPECT_LE(std::abs(e.radiosity - to_double(chosen[i])), ulp(to_double(chosen[i])));
    EXPECT_LE(e.lower, to_double(chosen[i]));
    EXPECT_GE(e.upper, to_double(chosen[i]));
  }
}

}  // namespace
}  // namespace hottel::radiosity_test
