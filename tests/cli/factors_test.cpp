// What CONTRACT says of `hottel factors`, on scenes that are not in the repository.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::factors_test {
namespace {

using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

using Pair = std::pair<std::string, std::string>;

struct Row {
  std::string from, to;
  double factor, lower, upper;
  std::string visibility;
};

// Rows of a csv without quoted names.
std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  for (const std::string& line : lines_of(csv)) {
    std::vector<std::string> fields;
    std::string field;
    std::istringstream in(line + ",");
    while (std::getline(in, field, ',')) fields.push_back(field);
    EXPECT_EQ(fields.size(), 7u) << line;
    if (fields[0] == "from") continue;
    EXPECT_EQ(fields[6], "exact");
    const auto number = [&](std::size_t k) { return std::strtod(fields[k].c_str(), nullptr); };  // 5e-324 too
    rows.push_back({fields[0], fields[1], number(2), number(3), number(4), fields[5]});
  }
  return rows;
}

std::set<Pair> pairs_of(const std::vector<Row>& rows) {
  std::set<Pair> pairs;
  for (const Row& row : rows) pairs.emplace(row.from, row.to);
  return pairs;
}

std::vector<std::string> froms_of(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows)
    if (names.empty() || names.back() != row.from) names.push_back(row.from);
  return names;
}

// Two plates that face each other, a long wall between them, and behind the right one a plate with two sides. Open.
//
//     left |      wall |      | right  | away
//          |>         <|>    <|       <|>         > front; < of "away" is its back
constexpr const char* kHidden = R"({ "hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}},
  "edges": [
    {"name": "left", "points": [[0, 0], [0, 1]], "material": "m", "elements": 2},
    {"name": "right", "points": [[4, 1], [4, 0]], "material": "m"},
    {"name": "wall", "points": [[2, -9], [2, 9]], "material": "m"},
    {"name": "away", "points": [[5, 0], [5, 1]], "material": "m", "back": "m", "elements": 3}
  ]})";

class Factors : public testing::Test {
 protected:
  void SetUp() override { place_.write("scene.json", kHidden); }
  std::vector<Row> rows(const std::string& options) const {
    const Outcome outcome = place_.run("hottel factors scene.json --quiet " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return rows_of(outcome.out);
  }
  Workplace place_;
};

const std::set<Pair> kVisible = {{"left", "wall:back"}, {"left", "sky"},     {"right", "wall"},
                                 {"right", "sky"},      {"wall", "right"},   {"wall", "away:back"},
                                 {"wall", "sky"},       {"away", "sky"},     {"away:back", "right:back"},
                                 {"away:back", "wall"}, {"away:back", "sky"}};

TEST_F(Factors, RowsAreTheFacesWithAMaterialAndColumnsAllThatIsSeen) { EXPECT_EQ(pairs_of(rows("")), kVisible); }

TEST_F(Factors, FacingAddsExactlyThePairsThatSomethingHides) {
  std::set<Pair> expected = kVisible;
  expected.insert({{"left", "right"}, {"left", "away:back"}, {"right", "left"}, {"away:back", "left"}});
  const std::vector<Row> facing = rows("--pairs facing");
  EXPECT_EQ(pairs_of(facing), expected);
  for (const Row& row : facing)
    if (!kVisible.contains({row.from, row.to})) {
      EXPECT_EQ(row.factor, 0);
      EXPECT_EQ(row.lower, 0);
      EXPECT_EQ(row.upper, 0);
      EXPECT_EQ(row.visibility, "0");
    }
}

TEST_F(Factors, VisibilityIsOneWhereNothingHidesAndTheFactorForTheSky) {
  for (const Row& row : rows("")) {
    const double visibility = std::stod(row.visibility);
    if (row.to == "sky")
      EXPECT_EQ(visibility, row.factor);
    else if (Pair(row.from, row.to) == Pair("wall", "away:back") || Pair(row.from, row.to) == Pair("away:back", "wall"))
      EXPECT_TRUE(0 < visibility && visibility < 1) << row.from;
    else
      EXPECT_EQ(row.visibility, "1") << row.from << " " << row.to;
  }
}

TEST_F(Factors, FacesAreWholeUnlessElementsAreAskedFor) {
  const std::vector<std::string> faces = {"left", "right", "wall", "away", "away:back"};
  EXPECT_EQ(froms_of(rows("")), faces);
  EXPECT_EQ(froms_of(rows("--elements 7")), faces);
  EXPECT_EQ(place_.run("hottel factors scene.json --elements 7 --quiet").out,
            place_.run("hottel factors scene.json --per face --quiet").out);
}

TEST_F(Factors, ElementsAreNamedFromTheFirstToTheSecondPoint) {
  EXPECT_EQ(froms_of(rows("--per element")),
            (std::vector<std::string>{"left#0", "left#1", "right", "wall", "away#0", "away#1", "away#2", "away:back#0",
                                      "away:back#1", "away:back#2"}));
  EXPECT_EQ(froms_of(rows("--per element --elements 2")),
            (std::vector<std::string>{"left#0", "left#1", "right#0", "right#1", "wall#0", "wall#1", "away#0", "away#1",
                                      "away:back#0", "away:back#1"}));
  EXPECT_EQ(froms_of(rows("--per element --elements 1")), froms_of(rows("")));
  // Parts no longer than 2/5: three of each plate, 45 of the wall.
  EXPECT_EQ(froms_of(rows("--per element --element-size 2/5")).size(), 3u + 3 + 45 + 3 + 3);
  // No longer than 1/2: two, exactly.
  EXPECT_EQ(froms_of(rows("--per element --element-size 0.5")).size(), 2u + 2 + 36 + 2 + 2);
  // left#0 is the lower half: it sees less of the wall's upper end.
  place_.run("hottel factors scene.json --per element -o elements.mtx --quiet");
  EXPECT_TRUE(lines_of(place_.read("elements.mtx.faces.csv")).at(1).starts_with("1,left,0,0.5,m,0,0,0,0.5"));
  EXPECT_TRUE(lines_of(place_.read("elements.mtx.faces.csv")).at(2).starts_with("2,left,1,0.5,m,0,0.5,0,1"));
}

TEST_F(Factors, ExactFormsTakeTheSceneBeforeAndAfter) {
  for (const char* line :
       {"hottel factors scene.json --exact-form right sky", "hottel factors --exact-form right sky scene.json",
        "hottel factors --exact-form right sky -o - scene.json",
        "hottel factors --quiet --exact-form right sky scene.json"}) {
    const Outcome outcome = place_.run(line);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // What the wall leaves, by crossed strings: 1 - (sqrt(4 + 100) + sqrt(4 + 81) - sqrt(4 + 64) - sqrt(4 + 81))/2.
    EXPECT_EQ(outcome.out, "from,to,exchange,area\nright,sky,1 + 1*sqrt(17) - 1*sqrt(26),1\n") << line;
  }
  EXPECT_EQ(place_.run("hottel factors --exact-form scene.json --quiet").out,
            place_.run("hottel factors scene.json --exact-form --quiet").out);
  EXPECT_EQ(place_.run("hottel factors scene.json --exact-form left right --quiet").out,
            "from,to,exchange,area\nleft,right,0,1\n");
}

TEST_F(Factors, JsonIsOneObjectAloneOnStandardOutput) {
  for (const char* line : {"hottel factors scene.json --json", "hottel factors scene.json --json -o x.csv"}) {
    const Outcome outcome = place_.run(line);
    EXPECT_EQ(outcome.code, 0);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_TRUE(json.is_object());
    EXPECT_TRUE(json.at("closure").at("exact").get<bool>());
    EXPECT_EQ(json.at("counts").at("surfaces"), 4);
  }
  EXPECT_EQ(place_.read("x.csv"), place_.run("hottel factors scene.json --quiet").out);
}

TEST_F(Factors, GroupsArePolylines) {
  place_.write("scene.json", R"({ "hottel": 1, "dimension": 2, "materials": {"m": {}},
    "edges": [ {"name": "lid", "points": [[-1, 2], [2, 2]], "material": "m"} ],
    "polylines": [ {"name": "tray", "points": [[2, 1], [2, 0], [-1, 0], [-1, 1]], "material": "m"} ]})");
  const std::vector<Row> groups = rows("--per group");
  EXPECT_EQ(froms_of(groups), (std::vector<std::string>{"lid", "tray"}));
  // The tray sees itself.
  EXPECT_EQ(pairs_of(groups),
            (std::set<Pair>{{"lid", "tray"}, {"lid", "sky"}, {"tray", "lid"}, {"tray", "tray"}, {"tray", "sky"}}));
}

TEST_F(Factors, RowsOfShortEdgesBesideLongOnesAreNotLost) {
  place_.write("scene.json", R"({ "hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
    {"name": "small", "points": [["1e-20", 0], [0, 0]], "material": "m"},
    {"name": "big", "points": [[0, "1e-20"], ["1e40", "1e-20"]], "material": "m"},
    {"name": "least", "points": [["1e-400", -1], [0, -1]], "material": "m"} ]})");
  std::map<Pair, double> factors;
  for (const Row& row : rows("")) factors[{row.from, row.to}] = row.factor;
  EXPECT_NEAR(factors.at({"small", "big"}), std::sqrt(0.5), 1e-15);  // an infinitely long lid from one end on
  EXPECT_NEAR(factors.at({"small", "sky"}), 1 - std::sqrt(0.5), 1e-15);
  EXPECT_TRUE(factors.contains({"least", "small:back"}));
}

// Laws over generated scenes: name of the kind and options.
class FactorsOfGenerated : public testing::TestWithParam<std::string> {};

std::vector<std::string> order_of(const std::string& faces_csv) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(faces_csv)) {
    std::string index, face, element;
    std::istringstream in(line);
    std::getline(in, index, ',');
    std::getline(in, face, ',');
    std::getline(in, element, ',');
    if (index != "index") names.push_back(face);
  }
  return names;
}

TEST_P(FactorsOfGenerated, ObeyTheLawsOfTheTable) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate " + GetParam() + " --quiet -o scene.json").code, 0);
  const Outcome outcome = place.run("hottel factors scene.json --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, place.run("hottel factors scene.json --quiet --threads 1").out);
  ASSERT_EQ(place.run("hottel factors scene.json --quiet -o scene.mtx").code, 0);
  std::map<std::string, std::size_t> place_in_order;
  for (const std::string& name : order_of(place.read("scene.mtx.faces.csv")))
    place_in_order.emplace(name, place_in_order.size());
  EXPECT_EQ(place_in_order.at("sky") + 1, place_in_order.size());

  std::map<std::string, long double> sums;
  std::map<Pair, Row> by_pair;
  std::pair<std::size_t, std::size_t> previous{0, 0};
  for (const Row& row : rows_of(outcome.out)) {
    const std::pair<std::size_t, std::size_t> at{place_in_order.at(row.from), place_in_order.at(row.to)};
    EXPECT_TRUE(previous < at || by_pair.empty()) << row.from << " " << row.to;
    previous = at;
    sums[row.from] += row.factor;
    EXPECT_LE(row.lower, row.factor);
    EXPECT_LE(row.factor, row.upper);
    EXPECT_LE(row.upper, std::nextafter(row.lower, 2));
    EXPECT_GT(row.factor, 0);
    EXPECT_LE(std::stod(row.visibility), 1);
    EXPECT_GT(std::stod(row.visibility), 0);
    by_pair[{row.from, row.to}] = row;
  }
  for (const auto& [from, sum] : sums) EXPECT_NEAR(static_cast<double>(sum), 1, 1e-14) << from;
  for (const auto& [pair, row] : by_pair) {
    const auto reverse = by_pair.find({pair.second, pair.first});
    EXPECT_EQ(reverse != by_pair.end(), sums.contains(pair.second)) << pair.first << " " << pair.second;
    if (reverse != by_pair.end()) {
      EXPECT_EQ(row.visibility, reverse->second.visibility);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, FactorsOfGenerated,
                         testing::Values("room --n 80 --seed 5", "clutter --n 150 --seed 2",
                                         "clutter --n 60 --view long --digits 17", "lattice --n 120 --k 6 --seed 9",
                                         "maze --n 120", "comb --n 40", "star --n 41", "pillars --n 96",
                                         "plates --n 12"),
                         [](const auto& test) {
                           return test.param.substr(0, test.param.find(' ')) + "_" + std::to_string(test.index);
                         });

// Fields of a csv without quoted names, the header first.
std::vector<std::vector<std::string>> fields_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(csv)) {
    std::istringstream in(line + ",");
    rows.emplace_back();
    for (std::string field; std::getline(in, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

TEST_F(Factors, ScriptFHasRowsThatSumToTheEmissivityWithProvenBounds) {
  const Outcome outcome = place_.run("hottel factors scene.json --script-f --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = fields_of(outcome.out);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"from", "to", "factor", "lower", "upper", "visibility", "guarantee"}));
  std::map<std::string, double> sum;
  std::set<Pair> pairs;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    ASSERT_EQ(rows[k].size(), 7u);
    EXPECT_EQ(rows[k][5], "");
    EXPECT_EQ(rows[k][6], "enclosed");
    const double factor = std::stod(rows[k][2]);
    EXPECT_TRUE(std::stod(rows[k][3]) <= factor && factor <= std::stod(rows[k][4]));
    EXPECT_LE(std::stod(rows[k][4]) - std::stod(rows[k][3]), 1e-14 * factor);
    sum[rows[k][0]] += factor;
    pairs.emplace(rows[k][0], rows[k][1]);
  }
  EXPECT_EQ(sum.size(), 5u);
  for (const auto& [from, total] : sum) EXPECT_NEAR(total, 0.5, 1e-15) << from;
  EXPECT_TRUE(pairs.contains({"wall", "wall"}));   // by way of the plates
  EXPECT_FALSE(pairs.contains({"left", "left"}));  // it sees a black back and the sky: nothing comes back
}

TEST_F(Factors, ScriptFIsOfOneChannelOrOfGrayMaterials) {
  place_.write("rgb.json", R"({ "hottel": 1, "dimension": 2,
    "materials": {"red": {"reflectivity": [0.5, 0.25, 0]}, "gray": {"reflectivity": 0.5, "emission": [1, 2, 3]}},
    "edges": [{"name": "a", "points": [[1, 0], [0, 0]], "material": "gray"},
              {"name": "b", "points": [[0, 1], [1, 1]], "material": "red"}]})");
  const Outcome refused = place_.run("hottel factors rgb.json --script-f --quiet");
  EXPECT_EQ(refused.code, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("rgb.json: 'red', the material of 'b', is not gray"), std::string::npos) << refused.err;
  std::set<std::string> outputs;
  for (const std::string channel : {"r", "g", "b"}) {
    const Outcome outcome = place_.run("hottel factors rgb.json --script-f --quiet --channel " + channel);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    outputs.insert(outcome.out);
  }
  EXPECT_EQ(outputs.size(), 3u);
  EXPECT_EQ(place_.run("hottel factors scene.json --script-f --quiet").out,
            place_.run("hottel factors scene.json --script-f --channel b --quiet").out);
}

TEST_F(Factors, ScriptFIsWrittenInEveryFormat) {
  const std::string factors = "hottel factors scene.json --quiet ";
  for (const std::string file : {"f.csv", "f.mtx", "f.npy", "f.txt", "f.bin"})
    EXPECT_EQ(place_.run(factors + "--script-f -o " + file).code, 0) << file;
  EXPECT_TRUE(place_.read("f.txt").starts_with("View3D 4.0.0 0 0 1 5 "));  // marked as View3D marks emit=1
  EXPECT_TRUE(place_.read("f.bin").starts_with("View3D 4.0.0 1 0 1 5 "));
  EXPECT_EQ(place_.read("f.csv"), place_.run(factors + "--script-f").out);
  EXPECT_EQ(place_.run(factors + "--script-f --matrix factor").code, 0);
  for (const std::string per : {"element", "group"})
    EXPECT_EQ(place_.run(factors + "--script-f --per " + per).code, 0) << per;
  const auto report = nlohmann::json::parse(place_.run(factors + "--script-f --json").out);
  EXPECT_EQ(report["script_f"]["channel"], "all");
  EXPECT_LT(report["script_f"]["max_relative_width"].get<double>(), 1e-14);
  EXPECT_TRUE(report["seconds"].contains("script_f"));
  EXPECT_FALSE(nlohmann::json::parse(place_.run(factors + "--json").out)["seconds"].contains("script_f"));
}

TEST_F(Factors, ScriptFRefusesWhatItIsNot) {
  for (const std::string bad : {"--script-f --matrix visibility", "--script-f --matrix exchange", "--channel r",
                                "--script-f --exact-form", "--script-f --pairs facing", "--script-f --channel x"})
    EXPECT_EQ(place_.run("hottel factors scene.json --quiet " + bad).code, 2) << bad;
}

}  // namespace
}  // namespace hottel::factors_test
