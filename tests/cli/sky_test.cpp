// The sky by its name, where faces are named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::sky_test {
namespace {

using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::json;

// A floor under two shelves of which neither is above the other. From x on the floor, the gap between them is open
// where the line through (2, 1) and (5/2, 2) has passed, at x = 3/2: the sky appears there for those who walk to the
// left.
constexpr const char* kShelves = R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}},
  "edges": [{"name": "floor", "points": [[4, 0], [0, 0]], "material": "m"},
            {"name": "low", "points": [[1, 1], [2, 1]], "material": "m"},
            {"name": "high", "points": [["5/2", 2], ["7/2", 2]], "material": "m"}]})";

class Sky : public testing::Test {
 protected:
  void SetUp() override { place_.write("shelves.json", kShelves); }
  Json answer(const std::string& options) const {
    const Outcome outcome = place_.run("hottel visibility shelves.json --json " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  Workplace place_;
};

TEST_F(Sky, TakesTheWholeAreaWhenNothingElseIsThere) {
  const Json json = answer("--from floor --to sky");
  EXPECT_EQ(json["unobstructed"]["exact"], "4");
  EXPECT_EQ(json["area_from"]["exact"], "4");
  EXPECT_EQ(json["area_to"], nullptr);
  EXPECT_EQ(json["factor_back"], nullptr);
  EXPECT_EQ(json["visibility"], json["factor"]);
  for (const std::string& line : lines_of(place_.run("hottel factors shelves.json --quiet").out))
    if (line.starts_with("floor,sky,")) {
      EXPECT_EQ(std::stod(line.substr(10)), json["factor"]["value"].get<double>());
    }
  for (const std::string& line : lines_of(place_.run("hottel factors shelves.json --exact-form floor sky --quiet").out))
    if (line.starts_with("floor,sky,")) {
      EXPECT_EQ(line, "floor,sky," + json["exchange"]["exact"].get<std::string>() + ",4");
    }
}

TEST_F(Sky, IsTheSameFromTheOtherSide) {
  const Json to = answer("--from floor --to sky"), from = answer("--from sky --to floor");
  EXPECT_EQ(from["exchange"], to["exchange"]);
  EXPECT_EQ(from["visibility"], to["visibility"]);
  EXPECT_EQ(from["area_to"], to["area_from"]);
  EXPECT_EQ(from["factor_back"], to["factor"]);
  EXPECT_EQ(from["area_from"], nullptr);
  EXPECT_EQ(from["factor"], nullptr);
  EXPECT_EQ(from["critical_points"], Json::array());
}

TEST_F(Sky, AppearsAtTheCriticalPointsOfAFace) {
  const Json json = answer("--from floor --to sky");
  bool is_found = false;
  for (const Json& point : json["critical_points"])
    is_found = is_found || (point["at"]["exact"] == Json{"3/2", "0"} && point["kind"] == "D1");
  EXPECT_TRUE(is_found) << json["critical_points"];
}

TEST_F(Sky, IsDrawnAsThePlaceWhereRaysEnd) {
  const Outcome outcome = place_.run("hottel visibility shelves.json --from floor --to sky -o sky.svg");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(place_.read("sky.svg").find("<svg"), std::string::npos);
}

TEST_F(Sky, IsSeenByAllWhereFacesAreColouredTowardIt) {
  const Outcome outcome = place_.run("hottel factors shelves.json -o f.csv --picture toward.svg --toward sky");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(place_.read("toward.svg").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace hottel::sky_test
