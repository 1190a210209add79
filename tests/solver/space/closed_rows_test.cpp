// Radiosities in space of factors that are all enclosed: what closed rows leave unknown.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/radiosity/radiosity.h"
#include "solver/space/simulation/simulation.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::closed_rows_in_space_test {
namespace {

using namespace testing_radiosity;

Scene3 scene_of(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
}

// A box, a box with a screen, boxes on a floor, turned ones, a room that is not convex, a furnished one.
std::vector<std::pair<std::string, Scene3>> rooms() {
  std::vector<std::pair<std::string, Scene3>> result;
  for (const char* name :
       {"cube.json", "shelf_in_a_box.json", "attic.json", "duct.json", "room_turned.json", "pierced_triangles.json"})
    result.emplace_back(name, scene_of(name));
  for (const char* kind : {"room-touching", "room-turned"})
    result.emplace_back(kind, generate_3({.kind = kind, .n = 2, .seed = 1}));
  return result;
}

ExchangeMatrix proven_factors(const Scene3& scene) {
  ExchangeMatrix matrix = exact_exchange(prepare(scene), {.proves = true});
  EXPECT_EQ(matrix.guarantee(), Guarantee::kEnclosed);
  EXPECT_TRUE(matrix.has_closed_rows());
  return matrix;
}

// All faces have one temperature and emissivities of their own, and so has the sky: all is as bright as a black body.
TEST(ClosedRowsInSpace, LeaveIsothermalRoomsAsBrightAsTheyAre) {
  for (auto& [name, scene] : rooms()) {
    const ExchangeMatrix matrix = proven_factors(scene);
    std::vector<Material> materials = scene.materials;
    int k = 0;
    for (Material& material : materials) {
      const Rational e(1, std::array{2, 5, 100, 1000}[static_cast<std::size_t>(k++ % 4)]);
      Material gray;
      gray.name = material.name;
      gray.reflectivity = Spectrum::scalar(1 - e);
      gray.emission = Spectrum::scalar(e * 400);
      material = gray;
    }
    bool sees_black_backs = false;  // which are cold
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i))
        sees_black_backs |= entry.to != matrix.sky() && !matrix.has_row(entry.to);
    ASSERT_FALSE(sees_black_backs) << name;
    const RadiositySolution solution = solve_radiosity(matrix, materials, Spectrum::scalar(400));
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (matrix.row(i).empty()) continue;
      const ElementRadiosity& e = solution.channels[0].elements[i];
      EXPECT_LE(e.lower, 400) << name;
      EXPECT_GE(e.upper, 400) << name;
      EXPECT_LE(e.upper - e.lower, 1e-9) << name;
      EXPECT_LE(e.net_lower, 0) << name;
      EXPECT_GE(e.net_upper, 0) << name;
      EXPECT_LE(e.net_upper - e.net_lower, 1e-9) << name;
    }
  }
}

// Factors within their bounds whose rows sum to 1, far from each other.
WideFactors closed_within(const ExchangeMatrix& matrix, std::mt19937_64& random) {
  WideFactors factors(matrix.size(), std::vector<mpf_class>(matrix.size() + 1, mpf_class(0, kBits)));
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const std::size_t count = matrix.row(i).size();
    mpf_class missing(1, kBits);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < count; ++k) {
      order.push_back(k);
      factors[i][matrix.row(i)[k].to] = mpf_class(matrix.bounds(i, k).lower, kBits);
      missing -= factors[i][matrix.row(i)[k].to];
    }
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t k : order) {  // as much as there is to the first ones
      mpf_class& factor = factors[i][matrix.row(i)[k].to];
      const mpf_class room = mpf_class(matrix.bounds(i, k).upper, kBits) - factor;
      const mpf_class more = room < missing ? room : missing;
      factor += more;
      missing -= more;
    }
    if (count > 0) {
      EXPECT_EQ(missing, 0) << "a row of bounds that rule out the sum 1";
    }
  }
  return factors;
}

TEST(ClosedRowsInSpace, BoundWhatOneLampLights) {
  for (auto& [name, scene] : rooms()) {
    const ExchangeMatrix matrix = proven_factors(scene);
    std::vector<Material> materials = scene.materials;
    for (std::size_t m = 0; m < materials.size(); ++m) {
      Material gray;
      gray.name = materials[m].name;
      gray.reflectivity = Spectrum::scalar(Rational(9, 10));
      gray.emission = Spectrum::scalar(m == 0 ? 1 : 0);
      materials[m] = gray;
    }
    const RadiositySolution solution = solve_radiosity(matrix, materials, {});
    EXPECT_LE(solution.max_relative_width, 1e-8) << name;
    std::mt19937_64 random(1);
    for (int times = 0; times < 4; ++times) {
      const auto radiosity = radiosity_of(matrix, closed_within(matrix, random), materials, {}, 0);
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        if (matrix.row(i).empty()) continue;
        const ElementRadiosity& e = solution.channels[0].elements[i];
        EXPECT_LE(mpf_class(e.lower, kBits), radiosity[i] * (1 + 1e-75)) << name << " " << i;
        EXPECT_GE(mpf_class(e.upper, kBits), radiosity[i] * (1 - 1e-75)) << name << " " << i;
      }
    }
  }
}

// Rows that were asked for alone promise nothing of the others.
TEST(ClosedRowsInSpace, AreNotPromisedOfAFewRows) {
  const Scene3 cube = scene_of("cube.json");
  ExchangeRequest request;
  EXPECT_TRUE(exact_exchange(prepare(cube), request).has_closed_rows());
  request.rows = RowChoice::of(cube, "floor", Granularity::kFace);
  EXPECT_FALSE(exact_exchange(prepare(cube), request).has_closed_rows());
}

}  // namespace
}  // namespace hottel::closed_rows_in_space_test
