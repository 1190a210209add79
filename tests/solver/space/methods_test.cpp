// What every method in space promises, and what each comes to on plates and cubes whose factors are known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/near_names.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/space/methods/hemicube.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel::methods_test {
namespace {

const MethodCatalogue3& catalogue() {
  static const MethodCatalogue3 methods = methods_3();
  return methods;
}

Scene3 shipped(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name + ".json");
}

// Two unit squares that look at each other from a distance; `more` polygons after them.
Scene3 plates(int distance, int elements = 1, int upper_elements = 1, const std::string& more = "") {
  return parse_scene_3(fmt::format(R"({{"hottel": 1, "dimension": 3, "materials": {{"m": {{}}}}, "polygons": [
  {{"name": "low", "points": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "material": "m", "elements": {1}}},
  {{"name": "high", "points": [[0, 0, {0}], [0, 1, {0}], [1, 1, {0}], [1, 0, {0}]], "material": "m", "elements": {2}}}
  {3}]}})",
                                   distance, elements, upper_elements, more),
                       "plates");
}

ExchangeMatrix by(const std::string& method, const Scene3& scene, Granularity granularity = Granularity::kElement) {
  MethodReport report;
  return catalogue().make(method)->compute(prepare(scene), {.granularity = granularity}, report);
}

constexpr double kUnitPlates = 0.19982489569838747;  // X = Y = 1: Howell's catalogue, C-11

double row_sum(const ExchangeMatrix& matrix, std::uint32_t i) {
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
  return sum;
}

struct Case {
  std::string scene, method;
};
std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.method << " on " << one.scene; }

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const std::string scene : {"cube", "two_boxes"})
    for (const std::string method :
         {"exact", "center", "center-vis", "vertices", "vertices:centroid", "vertices:literal",
          "vertices:literal:centroid", "gauss:2", "points:2", "hemicube:32", "hemicube:32:uniform", "rays:256",
          "rays:256:stratified", "rays:256:sobol", "rays:256:seed=7", "gauss:2:normalised"})
      result.push_back({scene, method});
  return result;
}

class MethodsInSpace : public testing::TestWithParam<Case> {};

TEST_P(MethodsInSpace, HaveTheRowsOfTheExactMatrixOnAnyNumberOfThreads) {
  const PreparedScene3 prepared = prepare(shipped(GetParam().scene));
  const ExchangeMatrix exact = exact_exchange(prepared, {.granularity = Granularity::kElement});
  const auto method = catalogue().make(GetParam().method);
  EXPECT_EQ(method->info().name, GetParam().method);
  EXPECT_FALSE(method->info().reference.empty());
  const auto computed_by = [&](int threads, MethodReport& report) {
    const ThreadLimit limit(threads);
    return method->compute(prepared, {.granularity = Granularity::kElement}, report);
  };
  MethodReport report;
  const ExchangeMatrix matrix = computed_by(1, report);
  ASSERT_EQ(matrix.size(), exact.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    EXPECT_EQ(matrix.elements()[i].name, exact.elements()[i].name);
    EXPECT_EQ(matrix.elements()[i].area, exact.elements()[i].area);
    EXPECT_TRUE(exact.has_row(i) || matrix.row(i).empty());
    for (const FactorEntry& entry : matrix.row(i)) {
      EXPECT_TRUE(std::isfinite(entry.factor.value) && entry.factor.value > 0);
      EXPECT_TRUE(entry.to != i) << "a plane element sees itself";
    }
  }
  EXPECT_TRUE(std::isfinite(report.row_defect));
  for (const int threads : {2, 3}) {
    MethodReport again;
    const ExchangeMatrix other = computed_by(threads, again);
    ASSERT_EQ(other.entry_count(), matrix.entry_count());
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
        EXPECT_EQ(other.row(i)[k].factor.value, matrix.row(i)[k].factor.value);
    EXPECT_EQ(again.row_defect, report.row_defect);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MethodsInSpace, testing::ValuesIn(cases()));

TEST(MethodsInSpace, CenterIsTheKernelBetweenCentres) {
  EXPECT_DOUBLE_EQ(by("center", plates(2)).factor("low", "high").value, 1 / (4 * std::numbers::pi));
  // The sky gets what is left: nothing else is there.
  EXPECT_DOUBLE_EQ(by("center", plates(2)).factor("low", "sky").value, 1 - 1 / (4 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(by("center-vis", plates(2)).factor("low", "high").value, 1 / (4 * std::numbers::pi));
}

TEST(MethodsInSpace, DiskStandsForTheOtherElementAndStaysBelowOne) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(by("disk", plates(1)).factor("low", "high").value, 1 / (pi + 1), 1e-15);
  EXPECT_NEAR(by("disk", plates(3)).factor("low", "high").value, 1 / (9 * pi + 1), 1e-15);
  // The lower one in quarters: A_i F_ij is not A_j F_ji.
  const ExchangeMatrix parts = by("disk", plates(1, 2));
  const double square = 1 + 2 * 0.25 * 0.25, cosines = 1 / square;
  const auto whole = *parts.find("high");
  EXPECT_NEAR(parts.factor(0, whole).value, cosines / (pi * square + 1), 1e-15);
  EXPECT_NEAR(parts.factor(whole, 0).value, 0.25 * cosines / (pi * square + 0.25), 1e-15);
}

TEST(MethodsInSpace, UniformRaysCountSolidAngles) {
  // The mean of the solid angle of the upper plate, by four right triangles at each point.
  const auto angle = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); };
  double mean = 0;
  constexpr int kSide = 64;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double x = (i + 0.5) / kSide, y = (j + 0.5) / kSide;
      mean += angle(x, y) + angle(1 - x, y) + angle(x, 1 - y) + angle(1 - x, 1 - y);
    }
  mean /= 2 * std::numbers::pi * kSide * kSide;
  const ExchangeMatrix counted = by("rays:65536:sobol:uniform", plates(1));
  EXPECT_NEAR(counted.factor("low", "high").value, mean, 1e-3);
  EXPECT_GT(std::abs(mean - kUnitPlates), 0.01);
  EXPECT_FALSE(catalogue().make("rays:64:uniform")->declared_error(prepare(plates(1))));
  EXPECT_EQ(catalogue().make("rays:64:uniform:seed=3")->info().name, "rays:64:uniform:seed=3");
}

TEST(MethodsInSpace, VerticesIsTheMeanOverCornersAndItsLiteralVariantLosesPi) {
  // Of 16 pairs of corners 4 are opposite (r^2 = 1), 8 beside (r^2 = 2), 4 across (r^2 = 3); cos cos' = 1 / r^2.
  const double mean = (4 * 1.0 + 8 / 4.0 + 4 / 9.0) / 16 / std::numbers::pi;
  EXPECT_DOUBLE_EQ(by("vertices", plates(1)).factor("low", "high").value, mean);
  EXPECT_DOUBLE_EQ(by("vertices:centroid", plates(1)).factor("low", "high").value, mean);
  EXPECT_DOUBLE_EQ(by("vertices:literal", plates(1)).factor("low", "high").value, std::numbers::pi * mean);
}

TEST(MethodsInSpace, QuadraturesConvergeGeometricallyWhereNothingHides) {
  double gauss_before = 1, points_before = 1;
  for (const int n : {1, 2, 4, 8}) {
    const double gauss =
        std::fabs(by("gauss:" + std::to_string(n), plates(1)).factor("low", "high").value - kUnitPlates);
    const double points =
        std::fabs(by("points:" + std::to_string(n), plates(1)).factor("low", "high").value - kUnitPlates);
    EXPECT_LT(gauss, gauss_before) << n;
    EXPECT_LT(points, points_before) << n;
    gauss_before = gauss;
    points_before = points;
  }
  EXPECT_LT(gauss_before, 1e-9);
  EXPECT_LT(points_before, 1e-10);
}

TEST(MethodsInSpace, WhatElementsOfAPlateReceiveSumsToWhatThePlateDoes) {
  for (const std::string method : {"points:3", "hemicube:128", "rays:4096:seed=3", "exact"}) {
    const ExchangeMatrix whole = by(method, plates(1)), parts = by(method, plates(1, 1, 4));
    double sum = 0;
    for (std::uint32_t j = 0; j < parts.size(); ++j)
      if (parts.elements()[j].name.starts_with("high#")) sum += parts.factor(*parts.find("low"), j).value;
    EXPECT_NEAR(sum, whole.factor("low", "high").value, 1e-12) << method;
  }
}

TEST(MethodsInSpace, MethodsThatLookEverywhereCloseTheirRows) {
  for (const std::string method : {"points:3", "hemicube:64", "hemicube:64:uniform", "rays:512", "rays:512:sobol"})
    for (const std::string scene : {"cube", "two_boxes"}) {
      const ExchangeMatrix matrix = by(method, shipped(scene));
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        if (matrix.has_row(i)) {
          EXPECT_NEAR(row_sum(matrix, i), 1, 1e-12) << method << " " << scene << " " << i;
        }
      }
    }
}

TEST(MethodsInSpace, PixelsOfTheHemicubeWeighWhatTheyCover) {
  for (const std::uint32_t resolution : {2u, 16u, 128u}) {
    const std::vector<double> weights = hemicube_weights_3(resolution);
    const std::size_t top = std::size_t{resolution} * resolution;
    ASSERT_EQ(weights.size(), top + top / 2);
    const double of_top = std::accumulate(weights.begin(), weights.begin() + static_cast<long>(top), 0.0);
    const double of_side = std::accumulate(weights.begin() + static_cast<long>(top), weights.end(), 0.0);
    // From a point to a square of side 2 at distance 1: 4 / pi / sqrt 2 atan(1 / sqrt 2).
    EXPECT_NEAR(of_top, 4 / (std::numbers::pi * std::sqrt(2)) * std::atan(1 / std::sqrt(2)), 1e-13);
    EXPECT_NEAR(of_top + 4 * of_side, 1, 1e-13);
  }
}

// From the centre of a small plate the hemicube sees what a point does; its error falls with the pixels.
TEST(MethodsInSpace, TheHemicubeConvergesToTheFactorFromTheCentre) {
  const double from_point = by("points:1", plates(1)).factor("low", "high").value;
  for (const int resolution : {64, 256, 1024})
    EXPECT_NEAR(by("hemicube:" + std::to_string(resolution), plates(1)).factor("low", "high").value, from_point,
                2.0 / resolution)
        << resolution;
  EXPECT_GT(std::fabs(by("hemicube:1024:uniform", plates(1)).factor("low", "high").value - from_point), 0.01);
}

TEST(MethodsInSpace, RaysAreWithinFiveStandardErrors) {
  const Scene3 scene = shipped("two_boxes");
  const ExchangeMatrix exact = exact_exchange(prepare(scene), {.granularity = Granularity::kElement});
  for (const std::string method : {"rays:16384", "rays:16384:stratified", "rays:16384:sobol", "rays:16384:seed=9"}) {
    const ExchangeMatrix matrix = by(method, scene);
    for (std::uint32_t i = 0; i < exact.size(); ++i)
      for (const FactorEntry& entry : exact.row(i)) {
        const double f = entry.factor.value;
        EXPECT_NEAR(matrix.factor(i, entry.to).value, f, 5 * std::sqrt(f * (1 - f) / 16384) + 1e-4)
            << method << " " << exact.name(i) << " " << exact.name(entry.to);
      }
  }
}

TEST(MethodsInSpace, FacesAndGroupsAreMeansOverTheirElements) {
  const Scene3 divided = plates(1, 3, 2);
  for (const std::string method : {"center", "points:2"}) {
    const ExchangeMatrix elements = by(method, divided), faces = by(method, divided, Granularity::kFace);
    double sum = 0;
    for (std::uint32_t i = 0; i < elements.size(); ++i)
      for (const FactorEntry& entry : elements.row(i))
        if (elements.elements()[i].surface == 0 && entry.to != elements.sky()) sum += entry.factor.value / 9;
    EXPECT_NEAR(faces.factor("low", "high").value, sum, 1e-15) << method;
    EXPECT_EQ(by(method, divided, Granularity::kGroup).factor("low", "high").value, faces.factor("low", "high").value);
  }
}

TEST(MethodsInSpace, AnOccluderBetweenTheCentresHidesAllFromCenterAndAPartFromTheOthers) {
  const Scene3 scene = plates(2, 1, 1, R"(, {"name": "between", "material": "m",
      "points": [[0.25, 0.25, 1], [0.75, 0.25, 1], [0.75, 0.75, 1], [0.25, 0.75, 1]]})");
  EXPECT_EQ(by("center", scene).factor("low", "high").value, 0);
  EXPECT_EQ(by("vertices:centroid", scene).factor("low", "high").value, 0);
  EXPECT_GT(by("vertices", scene).factor("low", "high").value, 0);
  const double exact = by("exact", scene).factor("low", "high").value;
  EXPECT_NEAR(by("points:16", scene).factor("low", "high").value, exact, 5e-3 * exact);  // kinks where shadows begin
  EXPECT_NEAR(by("gauss:16", scene).factor("low", "high").value, exact, 5e-2 * exact);   // jumps
}

// What a mask and its base exchange follows from their areas, and the rest of both rows from the rest.
TEST(MethodsInSpace, MasksExchangeWithTheirBasesWhatTheyDo) {
  const Scene3 room =
      parse_scene_3(R"({"hottel": 1, "dimension": 3, "closed": true, "materials": {"m": {}}, "polygons": [
  {"name": "floor", "points": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], "material": "m"},
  {"name": "ceiling", "points": [[0, 0, 2], [0, 2, 2], [2, 2, 2], [2, 0, 2]], "material": "m"},
  {"name": "south", "points": [[0, 0, 0], [0, 0, 2], [2, 0, 2], [2, 0, 0]], "material": "m"},
  {"name": "north", "points": [[0, 2, 0], [2, 2, 0], [2, 2, 2], [0, 2, 2]], "material": "m"},
  {"name": "west", "points": [[0, 0, 0], [0, 2, 0], [0, 2, 2], [0, 0, 2]], "material": "m"},
  {"name": "east", "points": [[2, 0, 0], [2, 0, 2], [2, 2, 2], [2, 2, 0]], "material": "m"},
  {"name": "rug", "points": [[0, 1, 0], [1, 1, 0], [1, 0, 0], [0, 0, 0]], "material": "m", "masks": "floor"}]})",
                    "rug");
  const ExchangeMatrix exact = by("exact", room);
  for (const std::string method : {"center", "center-vis", "vertices", "gauss:3", "points:4", "hemicube:64",
                                   "hemicube:64:uniform", "rays:4096", "rays:4096:normalised"}) {
    const ExchangeMatrix matrix = by(method, room);
    EXPECT_NEAR(matrix.factor("rug", "floor").value, 1, 1e-15) << method;
    EXPECT_NEAR(matrix.factor("floor", "rug").value, 0.25, 1e-15) << method;
    EXPECT_EQ(matrix.row(*matrix.find("rug")).size(), 1u) << method;
    for (const char* wall : {"ceiling", "east", "north"})
      EXPECT_NEAR(matrix.factor("floor", wall).value, exact.factor("floor", wall).value, 0.2) << method;
    if (method.find("points") == 0 || method.find("rays") == 0 || method.find("hemicube:64") == 0) {
      EXPECT_NEAR(row_sum(matrix, *matrix.find("floor")), 1, 1e-12) << method;
    }
  }
}

TEST(MethodsInSpace, NamesThatMakeNoSenseAreRefused) {
  for (const std::string name : {"gauss", "gauss:0", "gauss:65", "points:x", "hemicube:3", "hemicube:", "hemicube:5000",
                                 "hemicube:64:flat", "rays", "rays:0", "rays:8:sobol:seed", "rays:8:seed=3:uniform",
                                 "disk:2", "vertices:middle", "center:1", "exact:1", "center-vis:inverse-square=1"})
    EXPECT_THROW(catalogue().make(name), UsageError) << name;
  EXPECT_THROW(catalogue().make("strings"), UnknownName);
}

}  // namespace
}  // namespace hottel::methods_test
