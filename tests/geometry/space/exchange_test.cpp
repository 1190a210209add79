// View factors of scenes in space: values, order, groups, the sky, threads, what is refused.
#include "geometry/space/exchange/exchange.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel::exchange_test {
namespace {

using ::testing::HasSubstr;
using Pair = std::pair<std::string, std::string>;

constexpr double kOpposite = 0.1998248956983873830415993, kAdjacent = 0.2000437760754031542396002;

PreparedScene3 prepared(const std::string& json) { return prepare(parse_scene_3(json, "scene.json")); }
PreparedScene3 scene_file(const std::string& name, std::uint32_t elements = 1) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return prepare(std::move(scene));
}

std::set<Pair> pairs_of(const ExchangeMatrix& matrix) {
  std::set<Pair> pairs;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i)) pairs.emplace(matrix.name(i), matrix.name(entry.to));
  return pairs;
}

FactorEntry entry_of(const ExchangeMatrix& matrix, const std::string& from, const std::string& to) {
  for (const FactorEntry& entry : matrix.row(*matrix.find(from)))
    if (entry.to == *matrix.find(to)) return entry;
  throw std::runtime_error(from + " and " + to + " exchange nothing");
}

double row_sum(const ExchangeMatrix& matrix, std::uint32_t i) {
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
  return sum;
}

// Two plates that look at each other, a wide screen between them, and one far off. Open.
constexpr const char* kScreened = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
  {"name": "high", "points": [[0,0,2],[0,1,2],[1,1,2],[1,0,2]], "material": "m"},
  {"name": "screen", "points": [[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]], "material": "m"}]})";

TEST(Exchange3, FactorsOfACubeAreKnown) {
  const ExchangeMatrix matrix = exact_exchange(scene_file("cube.json"));
  EXPECT_EQ(matrix.entry_count(), 30u);
  const std::vector<std::string> names{"floor", "ceiling", "front", "rear", "left", "right"};
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (i == j) continue;
      const FactorEntry& entry = entry_of(matrix, names[i], names[j]);
      EXPECT_NEAR(entry.factor.value, i / 2 == j / 2 ? kOpposite : kAdjacent, 1e-9);
      EXPECT_EQ(entry.visibility, 1);
    }
}

TEST(Exchange3, EveryEntryIsWithinItsProvenBounds) {
  for (const char* name : {"cube.json", "two_boxes.json"}) {
    const ExchangeMatrix matrix = exact_exchange(scene_file(name));
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
        const Enclosure bounds = matrix.bounds(i, k);
        EXPECT_TRUE(bounds.contains(matrix.row(i)[k].factor.value)) << name;
        EXPECT_TRUE(0 <= bounds.lower && bounds.upper <= 1) << name;
        EXPECT_GT(matrix.row(i)[k].factor.value, 0) << name;
      }
  }
  const ExchangeMatrix cube = exact_exchange(scene_file("cube.json"));
  EXPECT_EQ(cube.guarantee(), Guarantee::kEnclosed);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_TRUE(cube.bounds(0, k).contains(k == 0 ? kOpposite : kAdjacent)) << k;
    EXPECT_LE(cube.bounds(0, k).width(), 2.1e-9);
  }
}

TEST(Exchange3, RowsOfAClosedRoomSumToOneWithoutTheSky) {
  for (const std::uint32_t elements : {1u, 2u}) {
    const PreparedScene3 room = scene_file("two_boxes.json", elements);
    ExchangeReport3 report;
    const ExchangeMatrix matrix = exact_exchange(room, {.granularity = Granularity::kElement}, &report);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      EXPECT_NEAR(row_sum(matrix, i), 1, 1e-9) << matrix.name(i);
      EXPECT_NE(matrix.row(i).back().to, matrix.sky()) << matrix.name(i);
    }
    EXPECT_LE(report.max_defect, 1e-9);
    EXPECT_GT(report.mixed, 0u);
  }
}

TEST(Exchange3, FactorsAreReciprocal) {
  const ExchangeMatrix matrix = exact_exchange(scene_file("two_boxes.json"), {.wants_measures = true});
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      const double area = matrix.elements()[i].area.value;
      EXPECT_NEAR(matrix.measures(i)[k], area * entry.factor.value, 1e-14 * area);
      if (entry.to == matrix.sky() || !matrix.has_row(entry.to)) continue;
      const FactorEntry& reverse = entry_of(matrix, matrix.name(entry.to), matrix.name(i));
      EXPECT_EQ(entry.visibility, reverse.visibility);
      EXPECT_NEAR(area * entry.factor.value, matrix.elements()[entry.to].area.value * reverse.factor.value,
                  1e-14 * area);
    }
}

TEST(Exchange3, BothFactorsAreOfOneMeasureWhereOneIsOne) {
  const PreparedScene3 scene = prepared(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
    "polygons": [
      {"name": "floor", "points": [[5, 2, 0], [4, 2, 0], [4, 3, 0], [0, 3, 0], [0, 0, 0], [5, 0, 0]], "material": "m"},
      {"name": "sheet", "points": [[2.0096, 0.5, 1e-10], [2, 0.5, 1e-10], [2, 0, 1e-10]], "material": "m", "back": "m"}]})");
  const ExchangeMatrix matrix = exact_exchange(scene, {.wants_measures = true});
  EXPECT_EQ(matrix.factor("sheet:back", "floor").value, 1);
  EXPECT_DOUBLE_EQ(matrix.factor("floor", "sheet:back").value, 0.0024 / 14);
  EXPECT_LE(matrix.measures(0)[0], 0.0024 * (1 + 0x1p-52));
  EXPECT_LE(matrix.bounds(0, 0).upper, 0.0024 / 14 * (1 + 0x1p-50));
}

TEST(Exchange3, FactorsOfElementsSumToThoseOfTheirFaces) {
  const PreparedScene3 room = scene_file("two_boxes.json", 2);
  const ExchangeMatrix faces = exact_exchange(room);
  const ExchangeMatrix parts = exact_exchange(room, {.granularity = Granularity::kElement, .wants_measures = true});
  std::map<std::pair<std::string, std::string>, double> sums;
  const auto face_of = [](const std::string& name) { return name.substr(0, name.find('#')); };
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = 0; k < parts.row(i).size(); ++k)
      sums[{face_of(parts.name(i)), face_of(parts.name(parts.row(i)[k].to))}] += parts.measures(i)[k];
  std::set<Pair> found;
  for (const auto& [pair, sum] : sums) {
    const double area = faces.elements()[*faces.find(pair.first)].area.value;
    EXPECT_NEAR(entry_of(faces, pair.first, pair.second).factor.value, sum / area, 1e-8)
        << pair.first << " " << pair.second;
    found.insert(pair);
  }
  EXPECT_EQ(found, pairs_of(faces));
}

TEST(Exchange3, AFaceIsNeverDividedUnlessElementsAreAskedFor) {
  const ExchangeMatrix whole = exact_exchange(scene_file("cube.json", 1)),
                       divided = exact_exchange(scene_file("cube.json", 3));
  EXPECT_EQ(whole.row(0)[0].factor, divided.row(0)[0].factor);
  EXPECT_EQ(whole.size(), divided.size());
}

TEST(Exchange3, OfAnOpenSceneTheSkyIsSeenThroughWhatIsOpen) {
  // A box without a lid: through the opening the floor sees what it saw of the lid.
  Scene3 open = scene_file("cube.json").scene;
  open.closed = false;
  open.surfaces.erase(open.surfaces.begin() + 1);
  open.polygons.erase(open.polygons.begin() + 1);
  const ExchangeMatrix matrix = exact_exchange(prepare(std::move(open)));
  EXPECT_NEAR(entry_of(matrix, "floor", "sky").factor.value, kOpposite, 1e-9);
  EXPECT_NEAR(entry_of(matrix, "left", "sky").factor.value, kAdjacent, 1e-9);
  EXPECT_EQ(entry_of(matrix, "left", "sky").visibility, entry_of(matrix, "left", "sky").factor.value);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (matrix.has_row(i)) {
      EXPECT_NEAR(row_sum(matrix, i), 1, 1e-9);
    }
  }
}

// What all else leaves of the area is proven as well as that is.
TEST(Exchange3, TheSkyIsEnclosedWhereAllElseIs) {
  const ExchangeMatrix matrix =
      exact_exchange(prepared(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "a", "points": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "material": "m"},
  {"name": "b", "points": [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]], "material": "m"}]})"),
                     {});
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const std::size_t last = matrix.row(i).size() - 1;
    ASSERT_EQ(matrix.row(i)[last].to, matrix.sky());
    EXPECT_EQ(matrix.guarantee(i, last), Guarantee::kEnclosed);
    EXPECT_LT(matrix.bounds(i, last).width(), 1e-13);
    EXPECT_TRUE(matrix.bounds(i, last).contains(1 - kOpposite));
  }
}

// Far from each other, or small beside the others.
TEST(Exchange3, TheSkyIsSeenByWhatIsFarAndByWhatIsSmall) {
  for (const char* distance : {"1e3", "1e6", "1e9", "1e12", "1e15"}) {
    const std::string z = distance;
    const ExchangeMatrix matrix = exact_exchange(
        prepared(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "a", "points": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "material": "m"},
  {"name": "b", "points": [[0, 0, )" +
                 z + "], [0, 1, " + z + "], [1, 1, " + z + "], [1, 0, " + z + R"(]], "material": "m"}]})"),
        {});
    EXPECT_NEAR(entry_of(matrix, "a", "sky").factor.value, 1 - entry_of(matrix, "a", "b").factor.value, 1e-12) << z;
    EXPECT_EQ(entry_of(matrix, "a", "b").factor.value > 0, true) << z;
  }
  const ExchangeMatrix matrix =
      exact_exchange(prepared(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "field", "points": [[-1000, -1000, 0], [1000, -1000, 0], [1000, 1000, 0], [-1000, 1000, 0]], "material": "m"},
  {"name": "sensor", "points": [[0, 0, 1.5], [0.001, 0, 1.5], [0.001, 0, 1.501], [0, 0, 1.501]], "material": "m"}]})"),
                     {});
  EXPECT_NEAR(entry_of(matrix, "sensor", "sky").factor.value + entry_of(matrix, "sensor", "field").factor.value, 1,
              1e-9);
  EXPECT_NEAR(entry_of(matrix, "field", "sky").factor.value, 1, 1e-9);
}

TEST(Exchange3, AFaceAloneSeesTheSkyAlone) {
  const ExchangeMatrix matrix = exact_exchange(prepared(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
           {"name": "kite", "points": [[0,0,0],[3,1,2],[1,1,1]], "material": "m", "back": "m"}]})"));
  EXPECT_EQ(pairs_of(matrix), (std::set<Pair>{{"kite", "sky"}, {"kite:back", "sky"}}));
  EXPECT_NEAR(matrix.row(0)[0].factor.value, 1, 1e-9);
  EXPECT_NEAR(matrix.row(1)[0].factor.value, 1, 1e-9);
}

TEST(Exchange3, BlackBacksAreColumnsWithoutRows) {
  const ExchangeMatrix matrix = exact_exchange(prepared(kScreened));
  EXPECT_EQ(pairs_of(matrix), (std::set<Pair>{{"low", "screen:back"},
                                              {"low", "sky"},
                                              {"high", "screen"},
                                              {"high", "sky"},
                                              {"screen", "high"},
                                              {"screen", "sky"}}));
}

TEST(Exchange3, HiddenPairsAreThoseThatWouldExchangeLightAlone) {
  const PreparedScene3 scene = prepared(kScreened);
  const ExchangeMatrix matrix = exact_exchange(scene);
  const auto low = *matrix.find("low"), high = *matrix.find("high");
  EXPECT_EQ(hidden_pairs(scene, Granularity::kFace, matrix), (std::vector<ElementPair>{{low, high}, {high, low}}));
  // In a closed room nobody sees the sky.
  const PreparedScene3 cube = scene_file("cube.json");
  const ExchangeMatrix of_cube = exact_exchange(cube);
  std::vector<ElementPair> expected;
  for (std::uint32_t i = 0; i < of_cube.size(); ++i)
    if (of_cube.has_row(i)) expected.emplace_back(i, of_cube.sky());
  EXPECT_EQ(hidden_pairs(cube, Granularity::kFace, of_cube), expected);
}

// Half of the way between two plates is covered.
constexpr const char* kHalf = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
  {"name": "high", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "m"},
  {"name": "bar", "points": [[0,0,"1/2"],["1/2",0,"1/2"],["1/2",1,"1/2"],[0,1,"1/2"]], "material": "m"}]})";

TEST(Exchange3, VisibilityIsTheShareThatIsNotHidden) {
  const ExchangeMatrix matrix = exact_exchange(prepared(kHalf));
  // By symmetry half is seen.
  EXPECT_NEAR(entry_of(matrix, "low", "high").factor.value, kOpposite / 2, 1e-9);
  EXPECT_NEAR(entry_of(matrix, "low", "high").visibility, 0.5, 1e-8);
  EXPECT_EQ(entry_of(matrix, "low", "bar:back").visibility, 1);
  EXPECT_TRUE(std::isnan(exact_exchange(prepared(kHalf), {.wants_visibility = false}).row(0)[0].visibility));
}

// The same, the plates and the bar in two groups: what a group hides of itself is not missed.
std::string grouped(const std::string& bar_group) {
  std::string text = kHalf;
  const std::pair<std::string, std::string> groups[] = {{"low", "plates"}, {"high", "other"}, {"bar", bar_group}};
  for (const auto& [name, group] : groups)
    text.insert(text.find("\"name\": \"" + name + "\""), "\"group\": \"" + group + "\", ");
  return text;
}

TEST(Exchange3, GroupsAreSumsOfTheirMembers) {
  const PreparedScene3 scene = prepared(grouped("plates"));
  const ExchangeMatrix faces = exact_exchange(scene, {.wants_measures = true});
  const ExchangeMatrix groups = exact_exchange(scene, {.granularity = Granularity::kGroup, .wants_measures = true});
  std::map<Pair, double> sums;
  const auto group_of = [](std::string name) {
    const std::string back = name.ends_with(":back") ? ":back" : "";
    if (name == "sky") return name;
    return (name.starts_with("high") ? "other" : "plates") + back;
  };
  for (std::uint32_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = 0; k < faces.row(i).size(); ++k)
      sums[{group_of(faces.name(i)), group_of(faces.name(faces.row(i)[k].to))}] += faces.measures(i)[k];
  for (const auto& [pair, sum] : sums) {
    const double area = groups.elements()[*groups.find(pair.first)].area.value;
    EXPECT_NEAR(entry_of(groups, pair.first, pair.second).factor.value, sum / area, 1e-9)
        << pair.first << " " << pair.second;
  }
  for (std::uint32_t i = 0; i < groups.size(); ++i) {
    if (groups.has_row(i)) {
      EXPECT_NEAR(row_sum(groups, i), 1, 1e-9);
    }
  }
}

TEST(Exchange3, WhatAGroupHidesOfItselfIsNotMissedInItsVisibility) {
  // The bar belongs to the plates: nothing else hides anything of them.
  const ExchangeMatrix own = exact_exchange(prepared(grouped("plates")), {.granularity = Granularity::kGroup});
  EXPECT_EQ(entry_of(own, "plates", "other").visibility, 1);
  const ExchangeMatrix foreign = exact_exchange(prepared(grouped("bars")), {.granularity = Granularity::kGroup});
  EXPECT_NEAR(entry_of(foreign, "plates", "other").visibility, 0.5, 1e-8);
}

// What remains of a scene where all but two groups are taken away.
Scene3 with_groups_alone(const Scene3& scene, std::uint32_t a, std::uint32_t b) {
  Scene3 result = scene;
  result.polygons.clear();
  result.surfaces.clear();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    if (scene.surfaces[s].group != a && scene.surfaces[s].group != b) continue;
    result.polygons.push_back(scene.polygons[s]);
    result.surfaces.push_back(scene.surfaces[s]);
  }
  return result;
}

// A box whose fronts look out, as a group.
std::string box_of_group(const std::string& group, const std::array<int, 3>& low, const std::array<int, 3>& high) {
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string text;
  for (int f = 0; f < 6; ++f) {
    text += ", {\"name\": \"" + group + std::to_string(f) + "\", \"group\": \"" + group +
            "\", \"material\": \"m\", \"points\": [";
    for (int c = 0; c < 4; ++c) {
      const auto place = [&](int axis) {
        const auto k = static_cast<std::size_t>(axis);
        return std::to_string((faces[f][c] >> axis & 1) != 0 ? high[k] : low[k]);
      };
      text += (c == 0 ? "[" : ", [") + place(0) + ", " + place(1) + ", " + place(2) + "]";
    }
    text += "]}";
  }
  return text;
}

// Over a floor two low boxes beside each other, then a high one, then a low one, and one above the high one. None
// touches another one: what is covered would be free without it.
Scene3 groups_of_boxes() {
  return parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "floor", "group": "ground", "points": [[0,0,0],[12,0,0],[12,5,0],[0,5,0]], "material": "m"})" +
          box_of_group("a", {1, 1, 1}, {2, 2, 2}) + box_of_group("b", {1, 3, 1}, {2, 4, 2}) +
          box_of_group("c", {4, 0, 1}, {5, 3, 3}) + box_of_group("d", {8, 1, 1}, {9, 2, 2}) +
          box_of_group("e", {4, 1, 4}, {5, 2, 5}) + "]}",
      "boxes.json");
}

TEST(Exchange3, TheVisibilityOfGroupsIsWhatTheyExchangeThereByThatAlone) {
  const ExchangeRequest request{.granularity = Granularity::kGroup, .wants_measures = true};
  const Scene3 scene = groups_of_boxes();
  const ExchangeMatrix there = exact_exchange(prepare(Scene3(scene)), request);
  const auto group_of = [&](std::uint32_t label) { return scene.surfaces[there.elements()[label].surface].group; };
  std::map<bool, int> counts;  // by whether nothing else hides anything
  for (std::uint32_t i = 0; i < there.size(); ++i)
    for (std::size_t k = 0; k < there.row(i).size(); ++k) {
      const FactorEntry entry = there.row(i)[k];
      if (entry.to == there.sky() || entry.to < i) continue;
      const Scene3 two = with_groups_alone(scene, group_of(i), group_of(entry.to));
      const double alone =
          entry_of(exact_exchange(prepare(Scene3(two)), request), there.name(i), there.name(entry.to)).factor.value;
      EXPECT_NEAR(entry.factor.value, entry.visibility * alone, 1e-8) << there.name(i) << ' ' << there.name(entry.to);
      EXPECT_EQ(entry.visibility == 1, std::fabs(entry.factor.value - alone) < 1e-8)
          << there.name(i) << ' ' << there.name(entry.to);
      ++counts[entry.visibility == 1];
    }
  EXPECT_GE(counts[true], 4);
  EXPECT_GE(counts[false], 4);
}

TEST(Exchange3, AGroupThatSeesItselfCountsBothDirections) {
  // The six walls of a cube as one group: all that leaves them arrives at them.
  Scene3 scene = scene_file("cube.json").scene;
  scene.groups = {"room"};
  for (Surface& surface : scene.surfaces) surface.group = 0;
  const ExchangeMatrix matrix = exact_exchange(prepare(std::move(scene)), {.granularity = Granularity::kGroup});
  EXPECT_EQ(pairs_of(matrix), (std::set<Pair>{{"room", "room"}}));
  EXPECT_NEAR(matrix.row(0)[0].factor.value, 1, 1e-9);
  EXPECT_EQ(matrix.row(0)[0].visibility, 1);
}

bool are_equal(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  if (a.size() != b.size() || a.entry_count() != b.entry_count()) return false;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a.row(i).size(); ++k) {
      const FactorEntry &x = a.row(i)[k], &y = b.row(i)[k];
      if (x.to != y.to || x.factor != y.factor || x.visibility != y.visibility || a.bounds(i, k) != b.bounds(i, k) ||
          a.guarantee(i, k) != b.guarantee(i, k))
        return false;
    }
  return true;
}

TEST(Exchange3, ThreadsChangeNothing) {
  const PreparedScene3 scene = scene_file("two_boxes.json", 2);
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    const ExchangeRequest request{.granularity = granularity};
    ExchangeReport3 one_report, many_report;
    const ExchangeMatrix many = exact_exchange(scene, request, &many_report);
    const ThreadLimit limit(1);
    EXPECT_TRUE(are_equal(exact_exchange(scene, request, &one_report), many));
    EXPECT_EQ(one_report.signs, many_report.signs);
    EXPECT_EQ(one_report.max_defect, many_report.max_defect);
  }
}

TEST(Exchange3, TheReportCountsPairs) {
  ExchangeReport3 report;
  const ExchangeMatrix cube = exact_exchange(scene_file("cube.json"), {}, &report);
  EXPECT_EQ(report.surfaces, 6u);
  EXPECT_EQ(report.vertices, 8u);
  EXPECT_EQ(report.elements, 12u);
  EXPECT_EQ(report.pairs, 15u);
  EXPECT_EQ(report.enclosed, 15u);
  EXPECT_EQ(report.clear, 15u);
  // Fronts with fronts and with the backs of others, and with the sky.
  EXPECT_EQ(report.hidden + report.clear + report.mixed, 15u + 30u + 6u);
  EXPECT_EQ(cube.entry_count(), 2 * report.pairs);
}

TEST(Exchange3, MemoryIsKeptTo) {
  const PreparedScene3 scene = scene_file("cube.json", 4);
  const auto refused = [&](std::uint64_t memory) -> std::string {
    try {
      exact_exchange(scene, {.granularity = Granularity::kElement, .memory = memory});
    } catch (const RequestError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refused(1000), HasSubstr("102 elements need about"));
  EXPECT_THAT(refused(200'000), HasSubstr("visible pairs need about"));
  EXPECT_EQ(refused(100'000'000), "");
}

TEST(Exchange3, ProgressMayStopIt) {
  struct Stop {};
  EXPECT_THROW(exact_exchange(scene_file("two_boxes.json", 2),
                              {.granularity = Granularity::kElement, .progress = [](double) { throw Stop(); }}),
               Stop);
  double last = 0;
  exact_exchange(scene_file("cube.json"), {.progress = [&](double fraction) { last = std::max(last, fraction); }});
  EXPECT_EQ(last, 1);
  const std::atomic<bool> is_stopped{true};
  const StopScope scope(&is_stopped);
  EXPECT_THROW(exact_exchange(scene_file("cube.json")), Interrupted);
}

TEST(RequireEnclosed3, NamesThePairsThatAreEstimated) {
  std::vector<Element> elements(2);
  elements[0] = {"a", 0, 0, 1, false, 0, {1, 0}};
  elements[1] = {"b", 1, 0, 1, false, 0, {1, 0}};
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  const auto fill = [&](Guarantee guarantee) {
    matrix.assign({0, 2, 3}, {{1, {0.5, 0}}, {2, {0.25, 0}}, {0, {0.5, 0}}}, {}, {{0.4, 0.6}, {0.2, 0.3}, {0.4, 0.6}},
                  {guarantee, Guarantee::kEnclosed, guarantee});
  };
  fill(Guarantee::kEnclosed);
  require_enclosed_3(matrix, 1e-9);
  fill(Guarantee::kEstimated);
  try {
    require_enclosed_3(matrix, 1e-9);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(), "a pair has no enclosure within 1e-09: 'a' and 'b'");
  }
}

// A box turned about an axis of no plane, in a room, its corners typed to six digits: no face of it is plane.
std::string turned_box(bool is_typed) {
  std::string text = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "closed": true, "polygons": [
  {"name": "floor", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m"},
  {"name": "ceiling", "points": [[0,0,2],[0,2,2],[2,2,2],[2,0,2]], "material": "m"},
  {"name": "west", "points": [[0,0,0],[0,2,0],[0,2,2],[0,0,2]], "material": "m"},
  {"name": "east", "points": [[2,0,0],[2,0,2],[2,2,2],[2,2,0]], "material": "m"},
  {"name": "south", "points": [[0,0,0],[0,0,2],[2,0,2],[2,0,0]], "material": "m"},
  {"name": "north", "points": [[0,2,0],[2,2,0],[2,2,2],[0,2,2]], "material": "m"})";
  // The quaternion 7 + 2 i + 1 j + 3 k, of norm 63, turns by rational numbers.
  const double r[3][3] = {{43, -38, 26}, {46, 37, -22}, {-2, 34, 53}};
  std::vector<std::string> corners;
  for (int k = 0; k < 8; ++k) {
    const double at[3] = {k & 1 ? 0.31 : -0.37, k & 2 ? 0.43 : -0.4, k & 4 ? 0.57 : -0.51};
    std::string corner;
    for (int row = 0; row < 3; ++row) {
      const double value = 1 + (r[row][0] * at[0] + r[row][1] * at[1] + r[row][2] * at[2]) / 63;
      const long numerator = std::lround(value * 6300);
      const std::string number = is_typed ? std::to_string(value) : "\"" + std::to_string(numerator) + "/6300\"";
      corner += (row == 0 ? "[" : ",") + number;
    }
    corners.push_back(corner + "]");
  }
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int f = 0; f < 6; ++f) {
    text +=
        ",\n  {\"name\": \"side " + std::to_string(f) + "\", \"group\": \"box\", \"material\": \"m\", \"points\": [";
    for (int c = 0; c < 4; ++c) text += (c == 0 ? "" : ",") + corners[static_cast<std::size_t>(faces[f][c])];
    text += "]}";
  }
  return text + "]}";
}

ExchangeMatrix factors_of(Scene3 scene, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepare(std::move(scene)), {.granularity = granularity, .tolerance = 1e-12});
}

// The scene with triangles of their own where it is nearly plane.
Scene3 cut_scene(const Scene3& scene) {
  Scene3 result = scene;
  result.surfaces.clear();
  result.polygons.clear();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const std::vector<Polygon3> facets = facets_of(scene.polygons[s]);
    for (std::size_t f = 0; f < facets.size(); ++f) {
      Surface surface = scene.surfaces[s];
      if (facets.size() > 1) surface.name += "/" + std::to_string(f);
      result.add(surface, facets[f]);
    }
  }
  return result;
}

TEST(Exchange3, NearlyPlanePolygonsAreTheirFacetsTogether) {
  const Scene3 scene = parse_scene_3(turned_box(true), "typed.json");
  std::size_t bent = 0;
  for (const Polygon3& polygon : scene.polygons) bent += polygon.is_nearly_plane;
  EXPECT_GE(bent, 2u);
  const Scene3 cut = cut_scene(scene);
  ASSERT_EQ(cut.surfaces.size(), 12 + bent);
  const ExchangeMatrix whole = factors_of(scene), parts = factors_of(cut);
  ASSERT_EQ(whole.size(), 24u);
  // The box is solid: its backs have no area.
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    if (!whole.has_row(i)) continue;
    EXPECT_NEAR(row_sum(whole, i), 1, 1e-12) << whole.name(i);
    const auto is_part_of = [](const std::string& part, const std::string& name) {
      return part == name || part.starts_with(name + "/");
    };
    double area = 0;
    std::map<std::string, double> measures;
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
      if (!parts.has_row(k) || !is_part_of(parts.name(k), whole.name(i))) continue;
      const double its_area = parts.elements()[k].area.value;
      area += its_area;
      for (const FactorEntry& entry : parts.row(k)) {
        const std::string to = parts.name(entry.to);
        measures[to.substr(0, to.find('/'))] += its_area * entry.factor.value;
      }
    }
    EXPECT_NEAR(whole.elements()[i].area.value, area, 4e-16 * area);
    for (const FactorEntry& entry : whole.row(i)) {
      EXPECT_NEAR(entry.factor.value, measures[whole.name(entry.to)] / area, 1e-12)
          << whole.name(i) << ' ' << whole.name(entry.to);
      EXPECT_LE(entry.visibility, 1);
    }
    EXPECT_EQ(whole.row(i).size(), measures.size()) << whole.name(i);
  }
  // What was meant is plane, and the factors are those of it, but for the digits.
  const Scene3 meant = parse_scene_3(turned_box(false), "meant.json");
  for (const Polygon3& polygon : meant.polygons) EXPECT_FALSE(polygon.is_nearly_plane);
  const ExchangeMatrix exact = factors_of(meant);
  for (std::uint32_t i = 0; i < 12; ++i)
    for (const FactorEntry& entry : exact.row(i))
      EXPECT_NEAR(entry_of(whole, exact.name(i), exact.name(entry.to)).factor.value, entry.factor.value, 1e-5);
}

TEST(Exchange3, ElementsOfNearlyPlanePolygonsAreThoseOfTheirFacets) {
  Scene3 scene = parse_scene_3(turned_box(true), "typed.json");
  const ExchangeMatrix whole = factors_of(scene);
  for (Surface& surface : scene.surfaces) surface.elements = 2;
  const ExchangeMatrix parts = factors_of(scene, Granularity::kElement);
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const std::string& name = scene.surfaces[s].name;
    if (name == "west") continue;
    const std::uint32_t count = scene.polygons[s].is_nearly_plane ? 8 : 4;
    double area = 0, seen = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto element = parts.find(name + "#" + std::to_string(k));
      ASSERT_TRUE(element.has_value()) << name << ' ' << k;
      EXPECT_NEAR(row_sum(parts, *element), 1, 1e-11);
      const double its_area = parts.elements()[*element].area.value;
      area += its_area;
      for (const FactorEntry& entry : parts.row(*element))
        if (parts.name(entry.to).starts_with("west")) seen += its_area * entry.factor.value;
    }
    EXPECT_FALSE(parts.find(name + "#" + std::to_string(count)).has_value());
    EXPECT_NEAR(area, whole.elements()[*whole.find(name)].area.value, 1e-15);
    double factor = 0;
    for (const FactorEntry& entry : whole.row(*whole.find(name)))
      if (whole.name(entry.to) == "west") factor = entry.factor.value;
    EXPECT_NEAR(seen / area, factor, 1e-12) << name;
  }
}

// One quad bent inward sees itself.
TEST(Exchange3, ANearlyPlanePolygonMaySeeItself) {
  const ExchangeMatrix bent = factors_of(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
      {"name": "quad", "points": [[0,0,0.0001],[2,0,0],[2,2,0.0001],[0,2,0]], "material": "m"}]})",
      "scene.json"));
  // Two triangles with the diagonal from the first corner in common, which is the higher one: a roof from above.
  EXPECT_EQ(bent.row(*bent.find("quad")).size(), 1u);
  const ExchangeMatrix valley = factors_of(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
      {"name": "quad", "points": [[0,0,0],[2,0,0.0001],[2,2,0],[0,2,0.0001]], "material": "m"}]})",
      "scene.json"));
  ASSERT_EQ(valley.row(*valley.find("quad")).size(), 2u);
  const FactorEntry& self = entry_of(valley, "quad", "quad");
  EXPECT_GT(self.factor.value, 0);
  EXPECT_LT(self.factor.value, 1e-4);
  EXPECT_NEAR(row_sum(valley, *valley.find("quad")), 1, 1e-12);
}

}  // namespace
}  // namespace hottel::exchange_test
