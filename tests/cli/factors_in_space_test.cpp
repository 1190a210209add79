// What CONTRACT says of `hottel factors` on scenes in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::factors_in_space_test {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

using Pair = std::pair<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line + ",");
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

struct Row {
  std::string from, to;
  double factor, lower, upper;
  std::string visibility, guarantee;
};

// Rows of a csv without quoted names.
std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  for (const std::string& line : lines_of(csv)) {
    const std::vector<std::string> fields = fields_of(line);
    EXPECT_EQ(fields.size(), 7u) << line;
    if (fields[0] == "from") continue;
    const auto number = [&](std::size_t k) { return std::strtod(fields[k].c_str(), nullptr); };
    rows.push_back({fields[0], fields[1], number(2), number(3), number(4), fields[5], fields[6]});
  }
  return rows;
}

std::vector<std::string> froms_of(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows)
    if (names.empty() || names.back() != row.from) names.push_back(row.from);
  return names;
}

// Two plates that look at each other, and between them a wide screen of two sides. Open.
constexpr const char* kScreened =
    R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
  {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m", "elements": 2},
  {"name": "high", "points": [[0,0,2],[0,1,2],[1,1,2],[1,0,2]], "material": "m"},
  {"name": "screen", "points": [[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]], "material": "m", "back": "m", "elements": 3},
  {"name": "kite", "group": "far", "points": [[20,0,0],[21,0,0],[20,0,1]], "material": "m", "elements": 2}]})";

class FactorsInSpace : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"cube.json", "two_boxes.json"})
      place_.write(name, contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name));
    place_.write("screened.json", kScreened);
  }
  std::string csv(const std::string& options) const {
    const Outcome outcome = place_.run("hottel factors " + options + " --quiet");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  std::vector<Row> rows(const std::string& options) const { return rows_of(csv(options)); }
  Workplace place_;
};

TEST_F(FactorsInSpace, HaveTheHeaderAndOrderOfThePlane) {
  const std::vector<std::string> lines = lines_of(csv("cube.json"));
  ASSERT_EQ(lines.size(), 31u);
  EXPECT_EQ(lines[0], "from,to,factor,lower,upper,visibility,guarantee");
  EXPECT_THAT(lines[1], StartsWith("floor,ceiling,0.19982489569"));
  EXPECT_THAT(lines[1], testing::EndsWith(",1,enclosed"));
  EXPECT_THAT(lines[30], StartsWith("right,left,0.19982489569"));
  EXPECT_THAT(froms_of(rows("cube.json")), ElementsAre("floor", "ceiling", "front", "rear", "left", "right"));
}

TEST_F(FactorsInSpace, RowsSumToOneAndValuesLieInTheirBounds) {
  for (const char* scene : {"cube.json", "two_boxes.json", "screened.json"})
    for (const char* per : {"face", "element", "group"}) {
      std::map<std::string, double> sums;
      for (const Row& row : rows(std::string(scene) + " --per " + per)) {
        sums[row.from] += row.factor;
        EXPECT_TRUE(0 <= row.lower && row.lower <= row.factor && row.factor <= row.upper && row.upper <= 1)
            << row.from << " " << row.to;
        EXPECT_TRUE(row.guarantee == "enclosed" || row.guarantee == "estimated");
        const double visibility = std::stod(row.visibility);
        EXPECT_TRUE(0 < visibility && visibility <= 1) << row.from << " " << row.to;
        if (row.to == "sky") {
          EXPECT_EQ(visibility, row.factor);
        }
      }
      for (const auto& [from, sum] : sums) EXPECT_NEAR(sum, 1, 1e-8) << scene << " " << from;
    }
}

TEST_F(FactorsInSpace, FacesAreWholeUnlessElementsAreAskedFor) {
  const std::vector<std::string> faces = {"low", "high", "screen", "screen:back", "kite"};
  EXPECT_EQ(froms_of(rows("screened.json")), faces);
  EXPECT_EQ(csv("screened.json"), csv("screened.json --per face --elements 7"));
  const Outcome told = place_.run("hottel factors screened.json --elements 7 -o f.csv");
  EXPECT_THAT(told.err, HasSubstr("the division into elements changes no number here"));
}

TEST_F(FactorsInSpace, ElementsAreNumberedAsDocumented) {
  const auto count = [&](const std::string& options) {
    return froms_of(rows("screened.json --per element " + options)).size();
  };
  EXPECT_EQ(count(""), 4u + 1 + 9 + 9 + 4);
  EXPECT_EQ(count("--elements 2"), 4u + 4 + 4 + 4 + 4);
  EXPECT_EQ(count("--elements 1"), 5u);
  EXPECT_EQ(count("--element-size 9"), 1u + 1 + 4 + 4 + 1);  // 18 / 9 is 2, exactly
  EXPECT_EQ(place_.run("hottel factors screened.json --per element -o f.mtx --quiet").code, 0);
  const std::vector<std::string> lines = lines_of(place_.read("f.mtx.faces.csv"));
  ASSERT_EQ(lines.size(), 32u);  // fronts 4, 1, 9, 4; backs 1, 1, 9, 1; header and sky
  EXPECT_EQ(lines[0], "index,face,element,area,material,points");
  EXPECT_EQ(lines[1], "1,low,0,0.25,m,0 0 0;0.5 0 0;0.5 0.5 0;0 0.5 0");
  EXPECT_EQ(lines[2], "2,low,1,0.25,m,0.5 0 0;1 0 0;1 0.5 0;0.5 0.5 0");
  EXPECT_EQ(lines[5], "5,low:back,0,1,,0 0 0;0 1 0;1 1 0;1 0 0");
  EXPECT_EQ(lines[27], "27,kite,1,0.125,m,20.5 0 0;20.5 0 0.5;20 0 0.5");
  EXPECT_EQ(lines[31], "31,sky,0,,,");
}

TEST_F(FactorsInSpace, GroupsAreNamedInTheScene) {
  EXPECT_THAT(froms_of(rows("screened.json --per group")), ElementsAre("low", "high", "screen", "screen:back", "far"));
  EXPECT_THAT(froms_of(rows("two_boxes.json --per group")),
              ElementsAre("floor", "ceiling", "front", "rear", "left", "right", "lamp", "lamp:back", "low", "high"));
}

TEST_F(FactorsInSpace, FacingAddsWhatSomethingHidesCompletely) {
  std::set<Pair> visible, hidden;
  for (const Row& row : rows("screened.json")) visible.emplace(row.from, row.to);
  for (const Row& row : rows("screened.json --pairs facing")) {
    if (visible.contains({row.from, row.to})) continue;
    hidden.emplace(row.from, row.to);
    EXPECT_EQ(row.factor, 0);
    EXPECT_EQ(row.upper, 0);
    EXPECT_EQ(row.visibility, "0");
    EXPECT_EQ(row.guarantee, "exact");
  }
  EXPECT_TRUE(hidden.contains({"low", "high"}));
  EXPECT_TRUE(hidden.contains({"high", "low"}));
  EXPECT_FALSE(hidden.contains({"low", "screen"}));  // its front looks away
}

TEST_F(FactorsInSpace, MatricesAreDense) {
  const std::vector<std::string> factors = lines_of(csv("screened.json --matrix factor"));
  ASSERT_EQ(factors.size(), 10u);
  EXPECT_EQ(factors[0], ",low,low:back,high,high:back,screen,screen:back,kite,kite:back,sky");
  const std::vector<std::string> visibility = fields_of(lines_of(csv("screened.json --matrix visibility"))[1]);
  EXPECT_EQ(visibility[1], "NaN");  // it does not face itself
  EXPECT_EQ(visibility[3], "0");    // the other plate is hidden
  EXPECT_EQ(visibility[6], "1");    // the screen's back
  // S is symmetric, and A F.
  const auto exchange = lines_of(csv("two_boxes.json --matrix exchange"));
  const double forth = std::stod(fields_of(exchange[1])[3]), back = std::stod(fields_of(exchange[3])[1]);
  EXPECT_EQ(forth, back);
  EXPECT_NEAR(forth, 5.5 * 5.5 * std::stod(fields_of(lines_of(csv("two_boxes.json --matrix factor"))[1])[3]), 1e-12);
}

TEST_F(FactorsInSpace, AreWrittenInEveryFormat) {
  for (const std::string file : {"f.csv", "f.mtx", "f.npy", "f.txt", "f.bin"})
    EXPECT_EQ(place_.run("hottel factors cube.json --quiet -o " + file).code, 0) << file;
  EXPECT_EQ(place_.read("f.csv"), csv("cube.json"));
  EXPECT_EQ(lines_of(place_.read("f.mtx"))[2], "13 13 30");
  EXPECT_EQ(lines_of(place_.read("f.mtx.faces.csv"))[1], "1,floor,0,1,white,0 0 0;1 0 0;1 1 0;0 1 0");
  const auto sidecar = nlohmann::json::parse(place_.read("f.npy.json"));
  EXPECT_EQ(sidecar["shape"], nlohmann::json({13, 13}));
  EXPECT_EQ(sidecar["names"][12], "sky");
  EXPECT_TRUE(place_.read("f.txt").starts_with("View3D 4.0.0 0 0 0 6 "));
  EXPECT_TRUE(place_.read("f.bin").starts_with("View3D 4.0.0 1 0 0 6 "));
  EXPECT_EQ(place_.run("hottel factors cube.json -o f.png").code, 2);
}

TEST_F(FactorsInSpace, TheReportIsOneObjectWithItsTiers) {
  const Outcome outcome = place_.run("hottel factors two_boxes.json --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const char* tier : {"filter", "combinatorial", "exact"}) EXPECT_TRUE(json["tiers"][tier].is_number()) << tier;
  const auto& counts = json["counts"];
  EXPECT_EQ(counts["surfaces"], 17);
  EXPECT_EQ(counts["elements"], 34);
  for (const char* count : {"hidden", "clear", "mixed", "pairs"}) EXPECT_GT(counts[count].get<int>(), 0) << count;
  EXPECT_LT(json["closure"]["max_defect"].get<double>(), 1e-8);
  EXPECT_FALSE(json["closure"]["exact"].get<bool>());
  EXPECT_THAT(outcome.err, HasSubstr("rows sum to 1 within "));
  EXPECT_EQ(place_.run("hottel factors two_boxes.json --json --quiet").err, "");
}

TEST_F(FactorsInSpace, ThreadsChangeNothing) {
  for (const std::string per : {"face", "element", "group"}) {
    const std::string line = "two_boxes.json --elements 2 --pairs facing --per " + per;
    EXPECT_EQ(csv(line + " --threads 1"), csv(line + " --threads 2"));
  }
}

TEST_F(FactorsInSpace, AnEnclosureWithinTheToleranceMayBeDemanded) {
  const Outcome met = place_.run("hottel factors cube.json --guarantee enclosed --quiet");
  EXPECT_EQ(met.code, 0);
  EXPECT_EQ(met.out, csv("cube.json"));
  EXPECT_EQ(met.out, csv("cube.json --guarantee estimated"));
  place_.write("old.csv", "old");
  const Outcome unmet = place_.run("hottel factors cube.json --guarantee enclosed --tolerance 1e-30 -o old.csv");
  EXPECT_EQ(unmet.code, 1);
  EXPECT_THAT(lines_of(unmet.err)[0], HasSubstr("cube.json: "));
  EXPECT_THAT(unmet.err, HasSubstr("pairs "));
  EXPECT_THAT(unmet.err, HasSubstr("'floor' and 'ceiling'"));
  EXPECT_THAT(unmet.err, ContainsRegex("; and 12 more, the worst of all [0-9.]+e-1[0-9]. Take a larger tolerance, such "
                                       "as 1e-1[0-9]\n"));
  EXPECT_EQ(place_.read("old.csv"), "old");
}

TEST_F(FactorsInSpace, MemoryIsKeptTo) {
  const Outcome outcome = place_.run("hottel factors cube.json --memory 1000");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, StartsWith("cube.json: about 12 elements need about"));
  EXPECT_EQ(place_.run("hottel factors cube.json --per element --elements 1000000").code, 1);
}

TEST_F(FactorsInSpace, WhatIsOfThePlaneIsRefused) {
  for (const char* option :
       {"--picture p.svg --toward floor", "--method gauss:4 --exact-form", "--method gauss:4 --script-f"}) {
    const Outcome outcome = place_.run(std::string("hottel factors cube.json ") + option);
    EXPECT_EQ(outcome.code, 2) << option << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << option;
  }
  for (const char* option : {"--tolerance 0", "--tolerance -1", "--tolerance x", "--tolerance 1e-400",
                             "--tolerance 1e400", "--guarantee exact", "--guarantee", "--element-size 0"})
    EXPECT_EQ(place_.run(std::string("hottel factors cube.json ") + option).code, 2) << option;
  EXPECT_THAT(place_.files(), ElementsAre("cube.json", "screened.json", "two_boxes.json"));
}

TEST_F(FactorsInSpace, RectanglesHaveClosedForms) {
  const Outcome pair = place_.run("hottel factors cube.json --exact-form floor ceiling --quiet");
  EXPECT_EQ(
      pair.out,
      "from,to,exchange,area\nfloor,ceiling,(-4*atan(1) + 4*sqrt(2)*atan(1/2*sqrt(2)) + 2*log(2) - log(3))/pi,1\n");
  const Outcome all = place_.run("hottel factors cube.json --exact-form");
  EXPECT_EQ(lines_of(all.out).size(), 31u);
  EXPECT_EQ(all.err, "");
  const Outcome hidden = place_.run("hottel factors two_boxes.json --exact-form floor ceiling");
  EXPECT_EQ(hidden.code, 1);
  EXPECT_THAT(hidden.err,
              HasSubstr("two_boxes.json: no closed form is known of 'floor' and 'ceiling': something hides"));
  EXPECT_THAT(place_.run("hottel visibility cube.json --from floor --to ceiling").out, HasSubstr("  S = (-4*atan(1)"));
}

TEST_F(FactorsInSpace, ScriptFIsEnclosedWhereFactorsAre) {
  const std::vector<Row> cube = rows("cube.json --script-f");
  ASSERT_EQ(cube.size(), 36u);  // all sides exchange heat, also with themselves
  double sum = 0;
  for (const Row& row : cube) {
    EXPECT_EQ(row.guarantee, "enclosed");
    EXPECT_LT(row.lower, row.upper);
    EXPECT_TRUE(row.lower <= row.factor && row.factor <= row.upper);
    if (row.from == "ceiling") sum += row.factor;
  }
  EXPECT_NEAR(sum, 0.9, 1e-9);  // its emissivity
  const Outcome boxes = place_.run("hottel factors two_boxes.json --script-f --channel r --json -o f.csv");
  ASSERT_EQ(boxes.code, 0) << boxes.err;
  const auto report = nlohmann::json::parse(boxes.out);
  EXPECT_EQ(report["script_f"]["guarantee"], "estimated");
  EXPECT_EQ(report["script_f"]["channel"], "r");
  EXPECT_THAT(boxes.err, HasSubstr("as good as the view factors, some of which are estimated"));
  for (const Row& row : rows_of(place_.read("f.csv"))) EXPECT_EQ(row.guarantee, "estimated");
  EXPECT_EQ(place_.run("hottel factors two_boxes.json --script-f").code, 1);  // which channel?
}

TEST_F(FactorsInSpace, TheSkyIsWhatTheOthersLeaveWhereThatIsAskedFor) {
  const Outcome outcome = place_.run("hottel factors screened.json --per element --sky closure --json -o f.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<Row> by_closure = rows_of(place_.read("f.csv")), all = rows("screened.json --per element");
  ASSERT_EQ(by_closure.size(), all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(Pair(by_closure[k].from, by_closure[k].to), Pair(all[k].from, all[k].to));
    EXPECT_NEAR(by_closure[k].factor, all[k].factor, all[k].to == "sky" ? 1e-12 : 0) << all[k].from;
  }
  const auto sky = nlohmann::json::parse(outcome.out)["sky"];
  EXPECT_EQ(sky["by"], "closure");
  EXPECT_EQ(sky["rows"], froms_of(all).size() - 1);
  EXPECT_EQ(sky["checked"], 1);
  EXPECT_EQ(sky["integrated"], 0);
  EXPECT_EQ(sky["beyond_stated"], 0);
  EXPECT_LE(sky["max_error"], sky["within"]);
  EXPECT_LE(sky["within"], 1e-7);
  EXPECT_LE(sky["max_difference"], 1e-12);
  EXPECT_THAT(outcome.err, HasSubstr("the sky by closure: 26 rows told by their other pairs, off by "));
  EXPECT_THAT(outcome.err, HasSubstr("; 1 integrated to compare, 0 as too little is left to tell"));
  EXPECT_THAT(place_.run("hottel factors screened.json").err, Not(HasSubstr("closure")));

  // Of a closed room every row is integrated: whether it sees the sky is decided by signs.
  const Outcome room = place_.run("hottel factors two_boxes.json --sky closure --quiet");
  EXPECT_EQ(room.code, 0) << room.err;
  EXPECT_EQ(room.out, place_.run("hottel factors two_boxes.json --quiet").out);
}

TEST_F(FactorsInSpace, AMeshIsASceneByItself) {
  place_.write("plates.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
               "g low\nf 1 2 3 4\ng high\nf 5 8 7 6\n");
  const std::vector<Row> all = rows("plates.obj");
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].from, "low[0]");
  EXPECT_EQ(all[0].to, "high[0]");
  EXPECT_NEAR(all[0].factor, 0.19982489569838738, 1e-9);
  EXPECT_EQ(all[1].to, "sky");
  EXPECT_EQ(froms_of(rows("plates.obj --per group")), (std::vector<std::string>{"low", "high"}));
}

TEST_F(FactorsInSpace, AnEmptySceneHasNoPairs) {
  place_.write("empty.json", R"({"hottel": 1, "dimension": 3})");
  EXPECT_THAT(rows("empty.json"), IsEmpty());
  EXPECT_EQ(lines_of(csv("empty.json --matrix factor")), (std::vector<std::string>{",sky", "sky,0"}));
}

}  // namespace
}  // namespace hottel::factors_in_space_test
