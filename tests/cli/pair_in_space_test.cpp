// What CONTRACT says of `hottel visibility --from A --to B` on scenes in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::pair_in_space_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::json;

const std::string kBoxes = "'" + std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json'";
const std::string kCube = "'" + std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json'";

// A wall that stands on the floor, below a ceiling, and a screen above it.
constexpr const char* kStanding =
    R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
  {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
  {"name": "high", "points": [[0,0,2],[0,1,2],[1,1,2],[1,0,2]], "material": "m"},
  {"name": "wall", "points": [[0.5,0.25,0],[0.5,0.75,0],[0.5,0.75,1],[0.5,0.25,1]], "material": "m"},
  {"name": "far", "points": [[0,0,9],[0,1,9],[1,1,9],[1,0,9]], "material": "m"}]})";

class PairInSpace : public testing::Test {
 protected:
  Json json(const std::string& options) const {
    const Outcome outcome = place_.run("hottel visibility --json --quiet " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }
  Workplace place_;
};

TEST_F(PairInSpace, HasTheNumbersOfFactors) {
  const Json pair = json(kBoxes + " --from floor --to rear");
  const Outcome csv = place_.run("hottel factors --quiet " + kBoxes + " | grep ^floor,rear,");
  std::vector<std::string> fields;
  std::istringstream line(csv.out);
  for (std::string field; std::getline(line, field, ',');) fields.push_back(field);
  ASSERT_EQ(fields.size(), 7u);
  const auto number = [&](std::size_t k) { return std::strtod(fields[k].c_str(), nullptr); };
  EXPECT_EQ(pair["factor"]["value"], number(2));
  EXPECT_EQ(pair["factor"]["lower"], number(3));
  EXPECT_EQ(pair["factor"]["upper"], number(4));
  EXPECT_EQ(pair["visibility"]["value"], number(5));
  EXPECT_EQ(pair["exchange"]["guarantee"].get<std::string>() + "\n", fields[6]);
}

TEST_F(PairInSpace, IsProvenWhereAskedFor) {
  const Json usual = json(kBoxes + " --from floor --to rear"),
             proven = json(kBoxes + " --from floor --to rear --guarantee enclosed");
  EXPECT_EQ(usual["exchange"]["guarantee"], "estimated");
  EXPECT_EQ(proven["exchange"]["guarantee"], "enclosed");
  EXPECT_EQ(proven["factor"]["value"], usual["factor"]["value"]);
  EXPECT_LT(proven["factor"]["upper"].get<double>() - proven["factor"]["lower"].get<double>(), 1e-9);
  EXPECT_LT(proven["factor"]["lower"], usual["factor"]["value"]);
  EXPECT_GT(proven["factor"]["upper"], usual["factor"]["value"]);
}

TEST_F(PairInSpace, TellsHowItWasSettledAndWhatItIsMadeOf) {
  const Json pair = json(kBoxes + " --from lamp --to floor");
  EXPECT_EQ(pair["from"], "lamp");
  EXPECT_EQ(pair["to"], "floor");
  EXPECT_EQ(pair["settled"], "mixed");
  EXPECT_EQ(pair["reason"], "10 polygons may stand between");
  EXPECT_EQ(pair["between"].size(), 10u);
  EXPECT_GT(pair["exchange"]["error"].get<double>(), 0);
  EXPECT_LE(pair["residual"]["value"].get<double>(), pair["residual"]["bound"].get<double>());
  EXPECT_EQ(pair["counts"]["seen"], pair["stretches"].size());
  EXPECT_GE(pair["counts"]["stretches"], pair["counts"]["seen"]);
  double sum = 0;
  std::size_t pieces = 0;
  for (const Json& stretch : pair["stretches"]) {
    const std::string role = stretch["role"];
    EXPECT_EQ(role == "outline", stretch["of"].is_null());
    EXPECT_TRUE(role == "source" || role == "foot" || role == "outline");
    EXPECT_EQ(stretch["ends"].size(), 2u);
    EXPECT_EQ(stretch["ends"][0]["exact"].size(), 3u);
    for (const Json& piece : stretch["pieces"]) {
      EXPECT_EQ(piece["t"].size(), 2u);
      EXPECT_LT(piece["t"][0].get<double>(), piece["t"][1].get<double>());
      EXPECT_GE(piece["arcs"].get<int>(), 3);
      sum += piece["exchange"].get<double>();
      ++pieces;
    }
  }
  EXPECT_EQ(pair["counts"]["pieces"], pieces);
  EXPECT_NEAR(sum, pair["exchange"]["value"].get<double>(), 1e-13);
}

TEST_F(PairInSpace, FeetAreWhereSomethingStandsOnAFace) {
  place_.write("standing.json", kStanding);
  const Json pair = json("standing.json --from low --to high");
  std::size_t feet = 0;
  for (const Json& stretch : pair["stretches"]) {
    if (stretch["role"] != "foot") continue;
    ++feet;
    EXPECT_EQ(stretch["of"], "from");
    EXPECT_EQ(stretch["at"], Json({"wall"}));
    for (const Json& end : stretch["ends"]) EXPECT_EQ(end["x"], 0.5);
  }
  EXPECT_EQ(feet, 1u);
}

TEST_F(PairInSpace, SaysWhyNothingIsSeen) {
  place_.write("standing.json", kStanding);
  const Json away = json("standing.json --from low:back --to high");
  EXPECT_EQ(away["settled"], "hidden");
  EXPECT_EQ(away["reason"], "no part of one is in front of the other");
  EXPECT_TRUE(away["visibility"].is_null());
  EXPECT_TRUE(away["residual"].is_null());
  EXPECT_TRUE(away["stretches"].empty());
  const Json hidden = json("standing.json --from low --to far");
  EXPECT_EQ(hidden["settled"], "hidden");
  EXPECT_EQ(hidden["reason"], "'high' hides all of each from the other");
  EXPECT_EQ(hidden["visibility"]["value"], 0);
  EXPECT_EQ(hidden["exchange"]["upper"], 0);
  EXPECT_GT(hidden["unobstructed"]["value"].get<double>(), 0);
}

TEST_F(PairInSpace, TheTextSaysTheSame) {
  const Outcome outcome = place_.run("hottel visibility " + kCube + " --from floor --to ceiling");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(lines_of(outcome.out)[0], "'floor' and 'ceiling'");
  EXPECT_THAT(outcome.out, HasSubstr("0.199824895698387"));
  EXPECT_THAT(outcome.out, HasSubstr("S is enclosed within 1e-09"));
  EXPECT_THAT(outcome.out,
              HasSubstr("settled as clear: nothing can stand between them\nS as a sum of integrals along edges: "));
}

TEST_F(PairInSpace, OneOfThemMayBeTheSky) {
  place_.write("standing.json", kStanding);
  const Json sky = json("standing.json --from wall --to sky");
  EXPECT_TRUE(sky["area_to"].is_null());
  EXPECT_TRUE(sky["factor_back"].is_null());
  EXPECT_EQ(sky["visibility"], sky["factor"]);
  EXPECT_EQ(json("standing.json --from sky --to wall")["exchange"], sky["exchange"]);
  EXPECT_EQ(place_.run("hottel visibility standing.json --from sky --to sky").code, 2);
}

TEST_F(PairInSpace, WhatMakesNoSenseIsRefused) {
  for (const char* options :
       {"--from floor", "--to floor", "--from floor --to nowhere", "--from floor --to rear --at 1,1,1",
        "--from floor --to rear -o pair.svg", "--from floor --to rear -o pair.txt"}) {
    const Outcome outcome = place_.run("hottel visibility " + kCube + " " + options);
    EXPECT_EQ(outcome.code, 2) << options << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << options;
  }
  EXPECT_THAT(place_.files(), ElementsAre());
}

}  // namespace
}  // namespace hottel::pair_in_space_test
