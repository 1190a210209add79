// Proven bounds hold what another sum, in numbers of fifty digits, tells to thirty: of two thousand scenes of the
// lattice, and of the 140 pairs of occluded.json as they are printed.
//
//   hottel_many_digits --scenes 2400 > tests/oracle/space/lattice_digits.csv
//   hottel_many_digits --file tests/oracle/space/occluded.json > tests/oracle/space/occluded_digits.csv
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/comparison/space/pair_scene.h"
#include "tests/oracle/space/exchange_to_digits.h"
#include "tests/oracle/space/real_of_digits.h"
#include "tests/oracle/space/space_scenes.h"
#include "tests/sanitizers.h"
#include "tests/storm/space/lattice_scene.h"
#include "tests/storm/space/matrix_law.h"

namespace hottel::oracle::many_digits_test {
namespace {

using Digits = RealOf<50>;

const Digits kKnown("1e-31");  // of the smaller area: from 1 to 0 the other sum is the same within that

std::string path(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/tests/oracle/space/" + name; }

struct Known {
  std::string scene;
  Digits measure;
};

std::vector<Known> read_known(const std::string& name) {
  std::ifstream file(path(name));
  std::vector<Known> known;
  for (std::string line; std::getline(file, line);)
    if (const std::size_t comma = line.find(','); line.find("measure") == std::string::npos)
      known.push_back({line.substr(0, comma), Digits(line.substr(comma + 1))});
  return known;
}

// All of them, or under sanitizers one of thirty.
std::vector<Known> some_known(const std::string& name) {
  std::vector<Known> known = read_known(name), some;
  for (std::size_t k = 0; k < known.size(); k += kHasAddressSanitizer ? 30 : 1) some.push_back(known[k]);
  return some;
}

Digits area(const SpacePolygon& polygon) {
  SpacePoint sum{0, 0, 0};
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const SpacePoint part = cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sqrt(real<Digits>(dot(sum, sum))) / 2;
}

PairRequest3 proving(double tolerance) {
  PairRequest3 request;
  request.tolerance = tolerance;
  request.proves = true;
  return request;
}

TEST(ManyDigits, OfLatticeScenesAreWithinProvenBounds) {
  std::size_t exchanging = 0;
  const std::vector<Known> all = some_known("lattice_digits.csv");
  EXPECT_GE(all.size(), kHasAddressSanitizer ? 66u : 2'000u);
  for (const Known& known : all) {
    const std::uint64_t number = std::stoull(known.scene);
    const auto polygons = storm::lattice_scene_3(number).polygons;
    const PairScene3 scene(polygons);
    const PairResult3 m = scene.measure(scene.patch(0), scene.patch(1), proving(1e-9));
    const Digits smaller = std::min(area(polygons[0]), area(polygons[1])), slack = kKnown * smaller;
    EXPECT_LE(Digits(m.bounds.lower), known.measure + slack) << known.scene;
    EXPECT_GE(Digits(m.bounds.upper), known.measure - slack) << known.scene;
    const bool is_flat = number % 7 == 6;  // needles, of which doubles lose more
    EXPECT_LE(m.bounds.width(), (is_flat ? 2e-8 : 1e-9) * static_cast<double>(smaller)) << known.scene;
    EXPECT_EQ(m.bounds.upper == 0, known.measure == 0) << known.scene;
    exchanging += known.measure != 0 ? 1 : 0;
  }
  EXPECT_GE(exchanging, kHasAddressSanitizer ? 50u : 1'600u);
}

// With rows of the first two alone.
Scene3 scene_of(const std::vector<SpacePolygon>& polygons) {
  Scene3 scene = storm::scene_of_polygons_3(polygons);
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    scene.surfaces[k].back.reset();
    scene.surfaces[k].is_obstruction = k > 1;
  }
  return scene;
}

void expect_printed(const ExchangeMatrix& factors, std::uint32_t from, std::uint32_t to, const Digits& factor,
                    const std::string& name) {
  for (std::size_t k = 0; k < factors.row(from).size(); ++k) {
    if (factors.row(from)[k].to != to) continue;
    EXPECT_LE(Digits(factors.bounds(from, k).lower), factor + kKnown) << name;
    EXPECT_GE(Digits(factors.bounds(from, k).upper), factor - kKnown) << name;
    return;
  }
  EXPECT_EQ(factor, 0) << name;
}

// As printed, there and back; and the file has the digits that it says: its first 40 values to 4e-15, the others to
// 1e-12.
TEST(ManyDigits, OfOccludedPairsAreWithinThePrintedBounds) {
  const std::vector<Known> known = read_known("occluded_digits.csv");
  const std::vector<SpaceCase> cases = read_space_cases(path("occluded.json"));
  ASSERT_EQ(known.size(), cases.size());
  for (std::size_t k = 0; k < cases.size(); k += kHasAddressSanitizer ? 30 : 1) {
    const auto& [name, polygons, value] = cases[k];
    ASSERT_EQ(known[k].scene, name);
    const Digits there = known[k].measure / area(polygons[0]), back = known[k].measure / area(polygons[1]);
    EXPECT_NEAR(static_cast<double>(there), value, k < 40 ? 4e-15 : 1e-12) << name;
    const ExchangeMatrix factors =
        exact_exchange(prepare(scene_of(polygons)), {.wants_visibility = false, .proves = true});
    const std::uint32_t i = factors.find("0").value(), j = factors.find("1").value();
    expect_printed(factors, i, j, there, name);
    expect_printed(factors, j, i, back, name);
  }
}

// The other sum is still what it was.
TEST(ManyDigits, AreFoundAgain) {
  for (const Known& known : read_known("lattice_digits.csv")) {
    const std::uint64_t number = std::stoull(known.scene);
    if (number >= 50 || number % 10 != 0) continue;
    const auto polygons = storm::lattice_scene_3(number).polygons;
    const Digits apart = Digits(exchange_to_digits(polygons).measure) - known.measure;
    EXPECT_LE(abs(apart), kKnown * 16) << known.scene;
  }
}

// Aligned unit squares and perpendicular ones with a common side (Howell C-11, C-14), to 22 digits; and what hides a
// quarter.
TEST(ManyDigits, AreThoseOfTables) {
  const SpacePolygon floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
      wall{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  const SpacePolygon ceiling{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
  const mpq_class h(1, 2);
  const SpacePolygon quarter{{0, 0, h}, {h, 0, h}, {h, h, h}, {0, h, h}};
  const auto expect = [](const std::vector<SpacePolygon>& polygons, const char* value) {
    EXPECT_LE(abs(Digits(exchange_to_digits(polygons).measure) - Digits(value)), Digits("1e-22")) << value;
  };
  expect({floor, ceiling}, "0.1998248956983873830416");
  expect({floor, wall}, "0.2000437760754031542396");
  expect({floor, ceiling, quarter}, "0.1498686717737905372812");
}

}  // namespace
}  // namespace hottel::oracle::many_digits_test
