// Which files are written, how large, and what is refused because it would not fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel::testing_cli::wanted_files_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
const std::string kSolve = "hottel solve " + kScenes + "analytic/furnace.json -o out --grid 8x8 --json --quiet";

bool exists(const Workplace& place, const std::string& file) { return std::filesystem::exists(place.path(file)); }

// Width and height as the head of a PNG file says.
std::pair<unsigned, unsigned> size_of_png(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
    return value;
  };
  return {number(16), number(20)};
}

TEST(WantedFiles, WithoutAPictureThereIsTheGrid) {
  const Workplace place;
  const Outcome outcome = place.run(kSolve + " --no-picture");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(exists(place, "out/illumination.npy"));
  EXPECT_FALSE(exists(place, "out/illumination.png"));
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(report.at("seconds").contains("illumination"));
  EXPECT_FALSE(report.at("seconds").contains("picture"));
  EXPECT_FALSE(report.contains("picture"));
}

TEST(WantedFiles, WithoutIlluminationThereAreNumbersOnly) {
  const Workplace place;
  const std::string solve = "hottel solve " + kScenes + "analytic/furnace.json -o out --json --quiet";
  const Outcome outcome = place.run(solve + " --no-illumination");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"out/radiosity.csv", "out/flux.csv", "out/report.json"}) EXPECT_TRUE(exists(place, file));
  for (const char* file : {"out/illumination.npy", "out/illumination.npy.json", "out/illumination.png"})
    EXPECT_FALSE(exists(place, file)) << file;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(report.at("seconds").contains("illumination"));
  for (const auto& effect : report.at("plan"))
    if (effect.at("effect") == "illumination") {
      EXPECT_FALSE(effect.at("used").get<bool>());
    }
  const std::string radiosities = place.read("out/radiosity.csv");
  ASSERT_EQ(place.run(kSolve).code, 0);
  EXPECT_EQ(place.read("out/radiosity.csv"), radiosities);
}

TEST(WantedFiles, OthersAreLeftAsTheyAre) {
  const Workplace place;
  ASSERT_EQ(place.run(kSolve).code, 0);
  place.write("out/illumination.png", "earlier");
  ASSERT_EQ(place.run(kSolve + " --no-picture").code, 0);
  EXPECT_EQ(place.read("out/illumination.png"), "earlier");
}

TEST(WantedFiles, APictureIsAsWideAsWanted) {
  const Workplace place;
  for (const unsigned width : {8u, 320u, 1600u}) {
    ASSERT_EQ(place.run(kSolve + " --size " + std::to_string(width)).code, 0);
    EXPECT_EQ(size_of_png(place.read("out/illumination.png")).first, width);
  }
  ASSERT_EQ(place.run(kSolve + " --size 3").code, 0);  // a pixel for each cell at least
  EXPECT_EQ(size_of_png(place.read("out/illumination.png")).first, 8u);
}

TEST(WantedFiles, WhatIsNotDrawnHasNoOptions) {
  const Workplace place;
  const std::string solve = "hottel solve " + kScenes + "analytic/furnace.json -o out ";
  for (const std::string bad : {"--no-picture --size 3", "--no-picture --tone max", "--no-illumination --size 3",
                                "--no-illumination --grid 4x4", "--no-illumination --illumination average",
                                "--no-illumination --simulate everything", "--size 0", "--size 99999"}) {
    EXPECT_EQ(place.run(solve + bad).code, 2) << bad;
    EXPECT_FALSE(exists(place, "out")) << bad;
  }
}

TEST(DenseFiles, ThatDoNotFitOnTheDiskAreRefusedBeforeTheWork) {
  const Workplace place;
  const std::string factors = "hottel factors " + kScenes + "analytic/furnace.json --per element --elements 1000000 ";
  for (const std::string out : {"-o dense.npy", "-o dense.bin", "-o dense.txt", "-o dense.csv --matrix factor"}) {
    const Outcome outcome = place.run(factors + out);
    EXPECT_EQ(outcome.code, 1) << out;
    EXPECT_THAT(outcome.err, StartsWith(kScenes + "analytic/furnace.json: a dense matrix of ")) << out;
    EXPECT_THAT(outcome.err, HasSubstr(" bytes; ")) << out;
    EXPECT_THAT(outcome.err, HasSubstr("FILE.csv or FILE.mtx")) << out;
    EXPECT_TRUE(place.files().empty()) << out;
  }
}

TEST(DenseFiles, ThatGoNowhereNeedNoRoom) {
  const Workplace place;
  std::filesystem::create_symlink("/dev/null", place.path("null.csv"));
  EXPECT_EQ(place.run("hottel factors " + kScenes + "analytic/furnace.json --matrix factor -o null.csv").code, 0);
  EXPECT_EQ(place.run("hottel factors " + kScenes + "analytic/furnace.json --matrix factor | cat").code, 0);
}

TEST(FactorsMemory, IsNoMoreThanAllowed) {
  const Workplace place;
  const Outcome outcome = place.run("hottel factors " + kScenes + "showcase/museum.json -o out.csv --memory 1000");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bytes"));
  EXPECT_TRUE(place.files().empty());
}

}  // namespace
}  // namespace hottel::testing_cli::wanted_files_test
