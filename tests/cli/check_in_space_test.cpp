// hottel check in space, as a stranger meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::check_in_space_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::json;

std::string scene_file(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name; }

std::map<std::string, int> kinds(const Json& report) {
  std::map<std::string, int> result;
  for (const auto& finding : report["findings"]) ++result[finding["kind"].get<std::string>()];
  return result;
}

using Kinds = std::map<std::string, int>;

TEST(CheckInSpace, TellsWhatIsTrueOfTheScenes) {
  const Workplace place;
  const std::map<std::string, Kinds> expected{{"cube.json", {}},
                                              {"room_turned.json", {}},
                                              {"room_axis.json", {{"black-back", 3}, {"t-junction", 2}}},
                                              {"two_boxes.json", {{"black-back", 2}}}};
  for (const auto& [scene, found] : expected) {
    const Outcome outcome = place.run("hottel check '" + scene_file(scene) + "' --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << scene;
    EXPECT_EQ(kinds(Json::parse(outcome.out)), found) << scene;
  }
  EXPECT_EQ(place.run("hottel check '" + scene_file("room_turned.obj") + "'").out,
            place.run("hottel check '" + scene_file("room_turned.json") + "'").out)
      << "meshes are looked at alike";
}

TEST(CheckInSpace, FindingsHaveNamesPlacesAndLines) {
  const Workplace place;
  place.write("s.json", contents(scene_file("room_six_digits.json")));
  const Outcome outcome = place.run("hottel check s.json --json");
  EXPECT_EQ(outcome.code, 1) << "it promises to be closed and is not";
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(kinds(report), (Kinds{{"not-closed", 1}, {"near-contact", 8}, {"covered", 1}}));
  EXPECT_EQ(report["findings"][0]["severity"], "error");
  const Json* partition = nullptr;
  for (const auto& finding : report["findings"])
    if (partition == nullptr && finding["surfaces"] == Json({"east", "partition"})) partition = &finding;
  ASSERT_NE(partition, nullptr);
  EXPECT_EQ((*partition)["kind"], "near-contact");
  EXPECT_EQ((*partition)["at"], Json({2.864102, 3.03923, 0.0}));
  EXPECT_EQ((*partition)["line"], 16);
  EXPECT_THAT((*partition)["message"].get<std::string>(), HasSubstr("is 2.0000001220249e-07 from an edge of "));
  const Outcome text = place.run("hottel check s.json");
  EXPECT_EQ(text.code, 1);
  EXPECT_THAT(text.out, StartsWith("s.json:12: error: not-closed at ("));
  EXPECT_THAT(text.out, EndsWith("1 error, 8 warnings, 1 note\n"));
}

// The sums of the rows of a file of factors, and the largest factor toward the sky.
struct Closure {
  double worst = 0, sky = 0;
  std::size_t rows = 0;
};
Closure closure_of(const Workplace& place, const std::string& scene) {
  const Outcome outcome = place.run("hottel factors " + scene + " --quiet -o -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::map<std::string, double> sums;
  Closure closure;
  for (const std::string& line : lines_of(outcome.out)) {
    if (line.starts_with("from,")) continue;
    std::istringstream cells(line);
    std::string from, to, factor;
    std::getline(cells, from, ',');
    std::getline(cells, to, ',');
    std::getline(cells, factor, ',');
    sums[from] += std::stod(factor);
    if (to == "sky") closure.sky = std::max(closure.sky, std::stod(factor));
  }
  closure.rows = sums.size();
  for (const auto& [from, sum] : sums) closure.worst = std::max(closure.worst, std::fabs(sum - 1));
  return closure;
}

TEST(CheckInSpace, FixJoinsWhatSixDigitsParted) {
  const Workplace place;
  place.write("s.json", contents(scene_file("room_six_digits.json")));
  const Outcome outcome = place.run("hottel check s.json --json --fix t.json --within 1e-5");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(kinds(report), (Kinds{{"covered", 2}, {"t-junction", 6}}));
  EXPECT_EQ(report["repairs"].size(), 8u);
  for (const auto& step : report["repairs"]) EXPECT_EQ(step["kind"], "snapped");
  // Light no longer gets out, and the rear of the cupboard has no row any more.
  bool tells_of_sky = false, tells_of_rear = false;
  for (const auto& change : report["changes"]) {
    EXPECT_NE(change["before"], change["after"]);
    if (change["to"] == "sky") {
      tells_of_sky = true;
      EXPECT_GT(change["before"].get<double>(), 0);
      EXPECT_EQ(change["after"], 0.0);
    }
    if (change["from"] == "cupboard.rear") {
      tells_of_rear = true;
      EXPECT_TRUE(change["after"].is_null());
    }
  }
  EXPECT_TRUE(tells_of_sky);
  EXPECT_TRUE(tells_of_rear);

  std::string open = place.read("s.json");  // as it is, its promise would be broken
  const std::string promise = "\"closed\": true";
  ASSERT_NE(open.find(promise), std::string::npos);
  place.write("open.json", open.replace(open.find(promise), promise.size(), "\"closed\": false"));
  const Closure before = closure_of(place, "open.json"), after = closure_of(place, "t.json");
  EXPECT_EQ(before.rows, 14u);
  EXPECT_EQ(after.rows, 13u);
  EXPECT_GT(before.sky, 1e-8);
  EXPECT_EQ(after.sky, 0);
  EXPECT_LT(before.worst, 1e-8);
  EXPECT_LT(after.worst, 1e-12);

  EXPECT_EQ(Json::parse(place.run("hottel check t.json --json").out)["findings"], report["findings"]);
  EXPECT_THAT(place.run("hottel check t.json --fix u.json --within 1e-5").out,
              StartsWith("t.json: nothing was repaired\n"));
  EXPECT_EQ(place.read("u.json"), place.read("t.json"));
}

TEST(CheckInSpace, AClosedMeshWithItsFrontsInwardIsNotToBeClosed) {
  // A lamp that floats in a room: a cube that shines into itself.
  std::string polygons;
  const auto add_cube = [&](const char* group, const char* material, char low, char high, std::size_t count) {
    const char* const kFaces[6] = {"100110010000", "011111101001", "001101100000",
                                   "111011010110", "011001000010", "101111110100"};
    for (std::size_t face = 0; face < count; ++face) {
      polygons += std::string(polygons.empty() ? "" : ", ") + R"({"name": ")" + group + std::to_string(face) +
                  R"(", "group": ")" + group + R"(", "material": ")" + material + R"(", "points": [)";
      for (int k = 0; k < 12; ++k) {
        polygons += k % 3 == 0 ? (k > 0 ? ", [" : "[") : ", ";
        polygons += kFaces[face][k] == '1' ? high : low;
        if (k % 3 == 2) polygons += ']';
      }
      polygons += "]}";
    }
  };
  const auto suggestions = [&](std::size_t faces_of_lamp) {
    polygons.clear();
    add_cube("room", "w", '0', '4', 6);
    add_cube("lamp", "e", '1', '2', faces_of_lamp);
    const Workplace place;
    place.write("s.json", R"({"hottel": 1, "dimension": 3, "materials": {"w": {"reflectivity": 0.5},
        "e": {"reflectivity": 0.2, "emission": 1}}, "polygons": [)" +
                              polygons + "]}");
    const Json report = Json::parse(place.run("hottel check s.json --json").out);
    std::map<std::string, int> result;
    for (const auto& finding : report["findings"])
      if (finding["kind"] == "black-back" && finding["surfaces"][0] == "lamp0")
        ++result[finding["suggestion"].get<std::string>()];
    return result;
  };
  EXPECT_EQ(suggestions(6),
            (Kinds{{"'lamp' is closed with its fronts inward: for a body list the points of each "
                    "polygon the other way round; else give 'lamp' a \"back\", or its material \"two_sided\": true",
                    1}}));
  EXPECT_EQ(suggestions(5), (Kinds{{"close the mesh 'lamp', its bottom too, where nothing is in it; else give 'lamp' "
                                    "a \"back\", or its material \"two_sided\": true",
                                    1}}));
}

TEST(CheckInSpace, FixWithoutADistanceReversesWhatIsUpsideDown) {
  const Workplace place;
  std::string text = contents(scene_file("cube.json"));
  const std::string points = "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]";
  const auto at = text.find(points);
  ASSERT_NE(at, std::string::npos);
  place.write("s.json", text.replace(at, points.size(), "[[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]]"));
  EXPECT_THAT(place.run("hottel check s.json").out, HasSubstr("warning: upside-down at (0.5, 0.5, 0): 'floor' has "));
  const Outcome outcome = place.run("hottel check s.json --fix t.json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, StartsWith("s.json:"));
  EXPECT_THAT(outcome.out, HasSubstr(": reversed: the points of 'floor' go the other way round"));
  EXPECT_THAT(outcome.out, EndsWith("0 errors, 0 warnings, 0 notes\n"));
}

TEST(CheckInSpace, OptionsThatMakeNoSenseAreRefusedAsInThePlane) {
  const Workplace place;
  place.write("s.json", contents(scene_file("cube.json")));
  for (const char* options : {"--within 1", "--fix - --within 1", "--fix a.svg --within 1", "--fix a.json --within 0"})
    EXPECT_EQ(place.run(std::string("hottel check s.json ") + options).code, 2) << options;
  EXPECT_EQ(place.files(), std::vector<std::string>{"s.json"});
}

}  // namespace
}  // namespace hottel::check_in_space_test
