// What --memory allows, what no machine holds, and memory that runs out all the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"
#include "tests/sanitizers.h"

namespace hottel::testing_cli::memory_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kMemoryScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

TEST(Memory, ThatRunsOutInTheSweepIsAnUnmetRequestAndLeavesNoFiles) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate comb --n 300 --seed 5 -o comb.json --quiet").code, 0);
  const std::string solve = "hottel solve comb.json -o out --grid 4x4 --quiet --memory ";
  const Outcome outcome = place.run(solve + "140000");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, testing::StartsWith("comb.json: the scene has more than 700 visible pairs"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"comb.json"});
  EXPECT_EQ(place.run(solve + "200000").code, 0);
}

// In every command, of the plane and of space, from counts alone: a run would take hours and terabytes.
TEST(Memory, ThatNoMachineHasIsAnUnmetRequestAtOnce) {
  const Workplace place;
  const std::string apartment = kMemoryScenes + "showcase/apartment.json",
                    boxes = kMemoryScenes + "space/two_boxes.json";
  std::string divided = contents(boxes);
  divided.insert(divided.find("\"name\""), "\"elements\": 1000000, ");
  place.write("divided.json", divided);
  const auto begin = std::chrono::steady_clock::now();
  for (const std::string& line :
       {"factors " + apartment + " --per element --elements 1000 -o f.csv",
        "factors " + boxes + " --per element --elements 1000 -o f.csv",
        "factors " + boxes + " --per element --elements 1000 --method gauss:4 -o f.csv",
        "solve " + apartment + " --elements 1000 -o out --grid 4x4", "solve " + boxes + " --elements 1000 -o out",
        "solve " + apartment + " --levels 20 -o out --grid 4x4", "solve " + boxes + " --levels 20 -o out",
        "compare " + apartment + " --elements 1000 --methods center -o out",
        "compare " + boxes + " --elements 1000 --methods center -o out", "compare " + boxes + " --divide 1,1000 -o out",
        "animate " + apartment + " --elements 1000 --frames 2 -o out",
        "animate " + boxes + " --elements 1000 --frames 2 -o out", std::string("reference set divided.json"),
        "view " + boxes + " --elements 1000 --screenshot s.png", std::string("view divided.json --screenshot s.png")}) {
    const Outcome outcome = place.run("hottel " + line);
    EXPECT_EQ(outcome.code, 1) << line << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("of memory; the limit is")) << line;
    EXPECT_THAT(outcome.err, HasSubstr("fewer elements")) << line;
    EXPECT_EQ(place.files(), std::vector<std::string>{"divided.json"}) << line;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(2)) << "15 runs";
}

TEST(Memory, IsPlannedWithoutMakingAnything) {
  const Workplace place;
  for (const std::string scene : {"showcase/apartment.json", "space/two_boxes.json"}) {
    const std::string plan = "hottel plan " + kMemoryScenes + scene + " --elements 1000";
    for (const std::string option : {"", " --memory 8000000000"}) {
      const Outcome outcome = place.run(plan + option);
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_THAT(outcome.out, StartsWith("memory\n  elements"));
      EXPECT_THAT(outcome.out, HasSubstr("it does not fit: about"));
    }
    const auto json = nlohmann::json::parse(place.run(plan + " --memory 8000000000 --json").out);
    EXPECT_TRUE(json["plan"].empty());
    EXPECT_FALSE(json["memory"]["fits"].get<bool>());
    EXPECT_EQ(json["memory"]["allowed"]["factors"], 8'000'000'000);
    EXPECT_EQ(json["memory"]["stages"][0]["stage"], "elements");
    EXPECT_GT(json["memory"]["peak"].get<double>(), 1e11);
  }
}

TEST(Memory, OfASmallSceneIsPlannedBesideItsEffects) {
  const Workplace place;
  const std::string plan = "hottel plan " + kMemoryScenes + "space/cube.json --elements 4 --memory ";
  const Outcome much = place.run(plan + "100000000"), little = place.run(plan + "1000");
  EXPECT_THAT(much.out, StartsWith("plan\n"));
  EXPECT_THAT(much.out, HasSubstr("\nit fits\n"));
  EXPECT_THAT(little.out, StartsWith("plan\n")) << "it fits into the machine";
  EXPECT_THAT(little.out, HasSubstr("the limit is 1.0 kB (1000 bytes). Allow more (--memory), take fewer elements"));
  EXPECT_EQ(little.code, 0);
  EXPECT_THAT(place.run("hottel plan " + kMemoryScenes + "space/cube.json --elements 4").out,
              testing::Not(HasSubstr("memory")));
}

// In the plane what lists of the factors take of time and disk is told beside it, also of what does not fit.
TEST(Memory, IsPlannedWithTheDiskOfLists) {
  const Workplace place;
  const std::string plan = "hottel plan " + kMemoryScenes + "showcase/apartment.json --memory 100000000 --json";
  const auto pairs_of = [&](const std::string& options) {
    return nlohmann::json::parse(place.run(plan + options).out)["lists"]["pairs"].get<double>();
  };
  const auto lists = nlohmann::json::parse(place.run(plan).out)["lists"];
  const double computed = 2926;
  EXPECT_GT(lists["pairs"].get<double>(), computed / 3);
  EXPECT_LT(lists["pairs"].get<double>(), computed * 3);
  ASSERT_EQ(place.run("hottel factors " + kMemoryScenes + "showcase/apartment.json -o f.csv").code, 0);
  const auto bytes = static_cast<double>(place.read("f.csv").size());
  EXPECT_GT(lists["bytes"]["csv"].get<double>(), bytes / 4);
  EXPECT_LT(lists["bytes"]["csv"].get<double>(), bytes * 4);
  EXPECT_GT(pairs_of(" --elements 1000"), 1e8) << "more than fit";
  EXPECT_THAT(place.run("hottel plan " + kMemoryScenes + "showcase/apartment.json --elements 1000").out,
              HasSubstr("\nlists of view factors\n  computed"));
}

// Pairs that stay on disk are no reason to refuse a scene, but elements are.
TEST(Memory, IsNotAskedForPairsThatStayOnDisk) {
  const Workplace place;
  const std::string factors =
      "hottel factors " + kMemoryScenes + "showcase/apartment.json --per element -o f.csv --quiet --elements ";
  EXPECT_EQ(place.run(factors + "8 --memory 15000000").code, 1);
  EXPECT_EQ(place.run(factors + "8 --memory 15000000 --out-of-core d").code, 0);
  EXPECT_EQ(place.run(factors + "100000 --out-of-core d").code, 1);
}

// Whatever the system gives less than it promised.
TEST(Memory, ThatRunsOutNamesSceneAndStageAndLeavesNoFiles) {
  if (kHasAddressSanitizer || kHasThreadSanitizer) GTEST_SKIP() << "sanitizers need addresses of their own";
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate clutter --n 20000 --seed 5 -o clutter.json --quiet").code, 0);
  const Outcome outcome =
      place.run("ulimit -v 280000; hottel factors clutter.json --threads 1 --memory 8000000000000 -o f.csv --quiet");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.err, StartsWith("clutter.json: memory ran out"));
  EXPECT_THAT(outcome.err, HasSubstr("fewer elements"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"clutter.json"});
  const Outcome refused = place.run("ulimit -v 280000; hottel factors clutter.json --threads 1 -o f.csv --quiet");
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("visible pairs need about")) << "what is left of addresses is what there is";
}

}  // namespace
}  // namespace hottel::testing_cli::memory_test
