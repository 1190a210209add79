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
#include "geometry/space/prepared/element_table.h"
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

// A room whose floor has the shape of an L, of one wall after another.
Scene3 room_of_two_arms() {
  const std::array<std::array<int, 2>, 6> corners{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}};
  std::string floor, ceiling, walls;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [x, y] = std::pair(corners[k][0], corners[k][1]);
    const auto [u, v] = std::pair(corners[(k + 1) % 6][0], corners[(k + 1) % 6][1]);
    floor += fmt::format("{}[{},{},0]", k == 0 ? "" : ",", x, y);
    ceiling = fmt::format("[{},{},3]{}", x, y, k == 0 ? "" : ",") + ceiling;
    walls += fmt::format(R"(,{{"points": [[{},{},0],[{},{},0],[{},{},3],[{},{},3]], "material": "m{}"}})", u, v, x, y,
                         x, y, u, v, k % 3);
  }
  return parse_scene_3(
      fmt::format(R"({{"hottel": 1, "dimension": 3, "closed": true, "materials": {{"m0": {{}}, "m1": {{}}, "m2": {{}}}},
                       "polygons": [{{"points": [{}], "material": "m0"}}, {{"points": [{}], "material": "m1"}}{}]}})",
                  floor, ceiling, walls),
      "two arms");
}

// Each row asked for alone: so nothing is narrowed by what other pairs leave, and no row promises to be closed.
ExchangeMatrix unclosed_factors(const Scene3& scene) {
  const PreparedScene3 prepared = prepare(scene);
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> found;
  std::vector<Enclosure> bounds;
  const auto table = prepared.elements(Granularity::kFace);
  for (std::uint32_t i = 0; i < table->count(); ++i) {
    ExchangeRequest request{.wants_visibility = false, .proves = true};
    if (table->has_row(i)) {
      request.rows = RowChoice::of(scene, table->elements()[i].name, Granularity::kFace);
      const ExchangeMatrix row = exact_exchange(prepared, request);
      EXPECT_FALSE(row.has_closed_rows());
      for (std::size_t k = 0; k < row.row(i).size(); ++k) {
        found.push_back(row.row(i)[k]);
        bounds.push_back(row.bounds(i, k));
      }
    }
    begin.push_back(found.size());
  }
  FactorEntries entries(found.size());
  for (std::size_t k = 0; k < found.size(); ++k) entries.set(k, found[k]);
  ExchangeMatrix matrix(table->elements(), Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds),
                std::vector<Guarantee>(found.size(), Guarantee::kEnclosed));
  return matrix;
}

// Rooms of every kind, and a town under a sky as warm as it is.
TEST(ClosedRowsInSpace, AreNotNeededToBoundWhatIsAllOneTemperature) {
  std::vector<std::pair<std::string, Scene3>> scenes = rooms();
  scenes.emplace_back("two arms", room_of_two_arms());
  scenes.emplace_back("town", generate_3({.kind = "town", .n = 3, .seed = 1}));
  for (const char* kind : {"room-stacked", "room-piercing"})
    scenes.emplace_back(kind, generate_3({.kind = kind, .n = 2, .seed = 1}));
  for (const auto& [name, scene] : scenes) {
    const ExchangeMatrix matrix = unclosed_factors(scene);
    std::vector<Material> materials;
    for (std::size_t k = 0; k < scene.materials.size(); ++k) {
      const Rational e(static_cast<long>(k % 3) + 2, 5);
      materials.emplace_back();
      materials.back().name = scene.materials[k].name;
      materials.back().reflectivity = Spectrum::scalar(1 - e);
      materials.back().emission = Spectrum::scalar(e);
    }
    const RadiositySolution solution = solve_radiosity(matrix, materials, Spectrum::scalar(1));
    EXPECT_EQ(solution.guarantee, Guarantee::kEnclosed) << name;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (matrix.row(i).empty()) continue;
      const ElementRadiosity& e = solution.channels[0].elements[i];
      EXPECT_LE(e.lower, 1) << name;
      EXPECT_GE(e.upper, 1) << name;
      EXPECT_LE(e.upper - e.lower, 1e-9) << name;
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
