// hottel compare, and --method of factors and solve, in space, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::compare_in_space_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kCube = std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json";

TEST(CompareInSpace, WritesAllFilesAndALineForEachFamily) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kCube + "' -o out --repeat 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto csv = lines_of(place.read("out/compare.csv"));
  ASSERT_EQ(csv.size(), 10u);
  EXPECT_EQ(csv[0], "method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error");
  EXPECT_THAT(csv[1], StartsWith("exact,enclosed,"));  // nothing stands between its faces
  EXPECT_THAT(csv[2], testing::Not(HasSubstr("enclosed")));
  EXPECT_THAT(place.read("out/compare.svg"), HasSubstr("<svg"));
  EXPECT_THAT(place.read("out/worst.csv"), HasSubstr("touching"));
  EXPECT_THAT(place.read("out/readings.csv"), StartsWith("error,family,seconds,exact_seconds\n"));
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_GT(json["exact_may_be_off"]["max_error"].get<double>(), 0);
  EXPECT_EQ(json["methods"][0]["max_error"], json["exact_may_be_off"]["max_error"]);
  EXPECT_THAT(outcome.err, HasSubstr("the exact factors may be off by"));
}

TEST(CompareInSpace, SweepsAndTakesToleranceElementsAndFilesOfOthers) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors '" + kCube + "' --quiet -o cube.csv").code, 0);
  const Outcome outcome = place.run(
      "hottel compare '" + kCube + "' --methods exact,gauss,file:cube.csv --sweep --tolerance 1e-12 --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string csv = place.read("out/compare.csv");
  EXPECT_THAT(csv, HasSubstr("\ngauss:1,"));
  EXPECT_THAT(csv, HasSubstr("\ngauss:6,"));
  EXPECT_THAT(csv, HasSubstr("\nfile:cube.csv,"));
  EXPECT_THAT(outcome.err, HasSubstr("file:cube.csv: all 30 pairs agree with the exact factors"));
}

TEST(CompareInSpace, SaysThatTheExactMethodIsProvenWhereThatIsAskedFor) {
  const Workplace place;
  const std::string compare = "hottel compare '" + std::string(HOTTEL_SOURCE_DIR) +
                              "/scenes/space/two_boxes.json' --methods exact,center --repeat 1 --tolerance 1e-6 -o out";
  for (const bool proves : {false, true}) {
    const Outcome outcome = place.run(compare + (proves ? " --guarantee enclosed" : ""));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto csv = lines_of(place.read("out/compare.csv"));
    EXPECT_THAT(csv[1], StartsWith(proves ? "exact,enclosed," : "exact,estimated,"));
    EXPECT_THAT(csv[2], StartsWith("center,estimated,"));
  }
}

TEST(CompareInSpace, DrawsWhereAMethodIsWrong) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel compare '" + kCube + "' --elements 2 --methods exact,center --repeat 1 --map center -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("out/errors.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(place.run("hottel compare '" + kCube + "' --methods exact --map center -o out").code, 2);
}

TEST(CompareInSpace, FactorsByAMethodAreWrittenLikeExactOnesWithoutBounds) {
  const Workplace place;
  const Outcome outcome = place.run("hottel factors '" + kCube + "' --method gauss:2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 31u);
  EXPECT_THAT(lines[1], testing::EndsWith(",0,1,,estimated"));
  EXPECT_THAT(outcome.err, HasSubstr("view factors by gauss:2: estimated, rows sum to 1 within 0."));
  const Outcome json = place.run("hottel factors '" + kCube + "' --method points:2 -o f.csv --json --quiet");
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["method"], "points:2");
  for (const std::string option : {"--tolerance 1e-6", "--guarantee enclosed", "--memory 1000000"}) {
    const Outcome refused = place.run("hottel factors '" + kCube + "' --method gauss:2 " + option);
    EXPECT_EQ(refused.code, 2) << option;
    EXPECT_THAT(refused.err, HasSubstr("is for the method exact only, not for gauss:2")) << option;
  }
  for (const std::string option : {"--pairs facing", "--matrix visibility", "--script-f"})
    EXPECT_EQ(place.run("hottel factors '" + kCube + "' --method gauss:2 " + option).code, 2) << option;
  // A F: of faces of area 1 the factors themselves.
  EXPECT_EQ(place.run("hottel factors '" + kCube + "' --method gauss:2 --matrix exchange").out,
            place.run("hottel factors '" + kCube + "' --method gauss:2 --matrix factor").out);
  EXPECT_EQ(place.run("hottel factors '" + kCube + "' --method strings").code, 2);
}

TEST(CompareInSpace, SolveTakesFactorsByAnyMethodAndSaysSo) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel solve '" + kCube + "' --elements 3 --method points:4 --no-picture -o out --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("out/report.json"), HasSubstr("view factors by points:4: estimated"));
  EXPECT_EQ(place.run("hottel solve '" + kCube + "' --method points:4 --tolerance 1e-6 -o out").code, 2);
}

}  // namespace
}  // namespace hottel::compare_in_space_test
