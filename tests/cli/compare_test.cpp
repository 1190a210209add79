// hottel compare, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kSquare = std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/square_radiosity.json";

TEST(Compare, WritesTheFilesOfTheContract) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' --methods exact,exact:normalised --repeat 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const auto csv = lines_of(place.read("square_radiosity-hottel/compare.csv"));
  ASSERT_EQ(csv.size(), 3u);
  EXPECT_EQ(csv[0], "method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error");
  EXPECT_THAT(csv[1], StartsWith("exact,exact,"));
  EXPECT_THAT(csv[2], StartsWith("exact:normalised,estimated,"));
  EXPECT_THAT(place.read("square_radiosity-hottel/compare.svg"), HasSubstr("<svg"));
  EXPECT_THAT(place.read("square_radiosity-hottel/compare.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(lines_of(place.read("square_radiosity-hottel/worst.csv")).at(0),
            "method,from,to,value,exact,error,visibility,distance,angle,reason");
  EXPECT_THAT(outcome.err, HasSubstr("exact:normalised"));
  EXPECT_THAT(outcome.err, HasSubstr("at an error of 0.001 exact"));
}

TEST(Compare, WritesWhereItIsToldAndOneTableRowAMethodInTheOrderAskedFor) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact:normalised,exact,exact -o a/b --repeat 1").code,
            0);
  const auto csv = lines_of(place.read("a/b/compare.csv"));
  ASSERT_EQ(csv.size(), 3u) << "a method that is named twice is run once";
  EXPECT_THAT(csv[1], StartsWith("exact:normalised,"));
  EXPECT_THAT(csv[2], StartsWith("exact,"));
}

TEST(Compare, RunsOneOfEachFamilyUnlessTold) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' -o out --repeat 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  std::vector<std::string> methods;
  for (const auto& method : json["methods"]) methods.push_back(method["method"]);
  EXPECT_THAT(methods, ::testing::Contains("exact"));
  EXPECT_EQ(json["methods"][0]["max_error"], 0);
  EXPECT_EQ(json["methods"][0]["max_radiosity_error"], 0);
  EXPECT_GT(json["methods"][0]["seconds"]["median"], 0);
  EXPECT_EQ(json["methods"][0]["seconds"]["runs"], 1);
}

TEST(Compare, ListsAsManyOfTheWorstPairsAsAsked) {
  const Workplace place;
  const std::string line = "hottel compare '" + kSquare + "' --elements 5 --methods exact:normalised --repeat 1 -o out";
  for (const std::size_t count : {0u, 3u}) {
    ASSERT_EQ(place.run(line + " --worst " + std::to_string(count)).code, 0);
    const auto worst = lines_of(place.read("out/worst.csv"));
    ASSERT_EQ(worst.size(), 1 + count);
    for (std::size_t k = 1; k < worst.size(); ++k) EXPECT_THAT(worst[k], StartsWith("exact:normalised,"));
  }
}

TEST(Compare, DividesAsSolveDoes) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel compare '" + kSquare + "' --elements 3 --methods exact --repeat 1 -o out --json --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["methods"][0]["pairs"], 4 * 3 * 3 * 3);
}

TEST(Compare, LeavesOutWhatFollowsInASweepThatTakesTooLong) {
  const Workplace place;
  const std::string line = "hottel compare '" + kSquare + "' --methods gauss --sweep --repeat 1 -o out";
  ASSERT_EQ(place.run(line).code, 0);
  const std::size_t all = lines_of(place.read("out/compare.csv")).size();
  const Outcome outcome = place.run(line + " --at-most 1e-12");
  ASSERT_EQ(outcome.code, 0);
  EXPECT_GT(all, 3u);
  EXPECT_EQ(lines_of(place.read("out/compare.csv")).size(), 2u);
  EXPECT_THAT(outcome.err, HasSubstr("is left out"));
}

TEST(Compare, DrawsWhereAMethodIsWrong) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel compare '" + kSquare +
                     "' --methods exact:normalised --map exact:normalised --repeat 1 "
                     "-o out")
                .code,
            0);
  EXPECT_THAT(place.read("out/errors.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact --map exact:normalised -o out").code, 2);
}

TEST(Compare, RefusesMethodsThatThereAreNotBeforeItWritesAnything) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' --methods exact,guess");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is no method called 'guess': exact"));
  EXPECT_TRUE(place.files().empty());
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --repeat 0").code, 2);
  EXPECT_EQ(place.run("hottel compare").code, 2);
  EXPECT_EQ(place.run("hottel compare nothing.json").code, 3);
}

TEST(Compare, LeavesEarlierFilesAsTheyAreWhenItFails) {
  const Workplace place;
  ASSERT_EQ(place.run("mkdir out && echo before > out/compare.csv && mkdir out/worst.csv").code, 0);
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact --repeat 1 -o out").code, 3);
  EXPECT_EQ(place.read("out/compare.csv"), "before\n");
}

}  // namespace
}  // namespace hottel
