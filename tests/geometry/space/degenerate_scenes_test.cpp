// What holds of every scene in scenes/degenerate/space/. The answers, with the reason for each, are in the files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/seen_faces.h"
#include "io/scene/scene_json.h"
#include "kernel/decimal.h"
#include "tests/refusal.h"

namespace hottel::degenerate_scenes_test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

fs::path folder() { return fs::path(HOTTEL_SOURCE_DIR) / "scenes" / "degenerate" / "space"; }
Scene3 degenerate(const std::string& stem) { return read_scene_3(folder() / (stem + ".json")); }

std::vector<std::string> stems_in(const fs::path& path) {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".json") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

using Printed = std::map<std::pair<std::string, std::string>, std::pair<double, double>>;

ExchangeMatrix factors_of(const Scene3& scene, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepare(scene), {.granularity = granularity});
}
Printed printed(const ExchangeMatrix& matrix) {
  Printed result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      result[{matrix.name(i), matrix.name(entry.to)}] = {entry.factor.value, entry.visibility};
  return result;
}

// The part of all directions from the eye of the camera in which a face is seen.
double fraction_of(const Scene3& scene, const std::string& name) {
  const PreparedScene3 prepared = prepare(scene);
  Look3 look;
  look.eye = scene.camera.value().eye;
  const VisibilityMap3 map = with_owners(map_from(prepared.occluders(), look), prepared.arrangement());
  const bool is_back = name.ends_with(":back");
  const Face face{scene.find(is_back ? name.substr(0, name.size() - 5) : name).value(), is_back};
  for (const VisibilityMap3::Share& share : map.shares)
    if (share.face == face) return share.fraction;
  return 0;
}

double value_of(const Scene3& scene, const Expectation& row) {
  if (row.quantity == "fraction") return fraction_of(scene, row.of.at(0));
  const ExchangeMatrix matrix =
      factors_of(scene, row.quantity == "group_factor" ? Granularity::kGroup : Granularity::kFace);
  if (row.quantity == "visibility") return printed(matrix)[{row.of.at(0), row.of.at(1)}].second;
  double sum = 0;
  for (std::size_t k = 1; k < row.of.size(); ++k) sum += matrix.factor(row.of[0], row.of[k]).value;
  return sum;
}

class DegenerateScenes3 : public testing::TestWithParam<std::string> {};

TEST_P(DegenerateScenes3, HaveTheValuesOfTheirFile) {
  const Scene3 scene = degenerate(GetParam());
  EXPECT_FALSE(scene.expect.empty());
  for (const Expectation& row : scene.expect) {
    const double expected = to_double(parse_rational(row.value).value()), value = value_of(scene, row);
    EXPECT_NEAR(value, expected, 1e-13) << row.name;
    EXPECT_EQ(value == 0, expected == 0) << row.name << ": zero is decided by signs";
    EXPECT_FALSE(row.derivation.empty()) << row.name;
  }
}

TEST_P(DegenerateScenes3, HaveClosedRowsWithinTheirBounds) {
  const ExchangeMatrix matrix = factors_of(degenerate(GetParam()));
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    double sum = 0;
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      sum += entry.factor.value;
      EXPECT_GT(entry.factor.value, 0);
      EXPECT_TRUE(matrix.bounds(i, k).contains(entry.factor.value));
      EXPECT_TRUE(0 < entry.visibility && entry.visibility <= 1);
    }
    EXPECT_NEAR(sum, 1, 1e-12) << matrix.name(i);
  }
}

Scene3 moved(Scene3 scene, const std::function<Point3(const Point3&)>& move) {
  for (Polygon3& polygon : scene.polygons) {
    for (Point3& p : polygon.points) p = move(p);
    for (auto& hole : polygon.holes)
      for (Point3& p : hole) p = move(p);
  }
  return scene;
}

// A millionth, a million times, and far away beside their size: to the last bit.
TEST_P(DegenerateScenes3, AreTheSameMagnifiedAndFarAway) {
  const Scene3 scene = degenerate(GetParam());
  const Printed expected = printed(factors_of(scene));
  for (const auto& [size, shift] : std::vector<std::pair<Rational, Rational>>{
           {Rational(1, 1000000), 0}, {1000000, 0}, {1, 1000000}, {Rational(1, 3), (Integer(1) << 60) + 7}})
    EXPECT_TRUE(printed(factors_of(moved(scene,
                                         [&s = size, &d = shift](const Point3& p) {
                                           return Point3{p.x * s + d, p.y * s - d, p.z * s + d};
                                         }))) == expected)
        << size << " " << shift;
}

// Where surfaces overlap another one may be the first listed: then faces have other areas.
TEST_P(DegenerateScenes3, DoNotDependOnTheOrderOfPolygons) {
  Scene3 scene = degenerate(GetParam());
  const ExchangeMatrix forth = factors_of(scene);
  std::reverse(scene.surfaces.begin(), scene.surfaces.end());
  std::reverse(scene.polygons.begin(), scene.polygons.end());
  const ExchangeMatrix back = factors_of(scene);
  const auto has_same_area = [&](const std::string& name) {
    return name == "sky" ||
           forth.elements()[forth.find(name).value()].area == back.elements()[back.find(name).value()].area;
  };
  Printed other = printed(back);
  for (const auto& [names, numbers] : printed(forth))
    if (has_same_area(names.first) && has_same_area(names.second)) {
      EXPECT_NEAR(numbers.first, other[names].first, 1e-13) << names.first << " to " << names.second;
    }
}

std::string read_me() {
  std::ifstream file(folder() / "README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_P(DegenerateScenes3, AreInTheReadme) { EXPECT_THAT(read_me(), HasSubstr("`" + GetParam() + "`")); }

TEST(RefusedScenes3, AreInTheReadmeAndNameThePolygonsAndThePlace) {
  const auto refusal = [](const std::string& stem) {
    return refusal_by([&] { prepare(degenerate("refused/" + stem)); });
  };
  for (const std::string& stem : stems_in(folder() / "refused")) {
    EXPECT_NE(refusal(stem), "") << stem;
    EXPECT_THAT(read_me(), HasSubstr("`refused/" + stem + "`"));
  }
  EXPECT_THAT(
      refusal("coplanar_conflict"),
      AllOf(HasSubstr("coplanar_conflict.json:10: 'white' (front) and 'black' (front)"), HasSubstr("around (")));
  EXPECT_THAT(refusal("not_plane"), AllOf(HasSubstr("not_plane.json:8"), HasSubstr("'bent'")));
}

INSTANTIATE_TEST_SUITE_P(, DegenerateScenes3, testing::ValuesIn(stems_in(folder())),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace hottel::degenerate_scenes_test
