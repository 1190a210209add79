// hottel-mpi on several ranks against hottel: the same files, the same standard output, the same exit code.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::ranks_test {
namespace {

using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

std::string mpirun(int ranks) {
  return "timeout 300 mpirun --oversubscribe --allow-run-as-root --bind-to none -n " + std::to_string(ranks) + " '" +
         HOTTEL_MPI_PROGRAM + "' ";
}

// The files of a folder, but for the seconds that reports tell.
std::vector<std::pair<std::string, std::string>> files_in(const Workplace& place, const std::string& folder) {
  static const std::regex kSeconds(R"("seconds": \{[^}]*\})");
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& entry : testing_cli::fs::recursive_directory_iterator(place.path(folder)))
    if (entry.is_regular_file()) {
      std::string text = testing_cli::contents(entry.path());
      if (entry.path().extension() == ".json") text = std::regex_replace(text, kSeconds, "");
      files.emplace_back(entry.path().lexically_relative(place.path(folder)).string(), std::move(text));
    }
  std::sort(files.begin(), files.end());
  return files;
}

void expect_same_on(const std::vector<int>& numbers_of_ranks, const std::string& arguments) {
  const Workplace place;
  place.run("mkdir one");
  const Outcome one = place.run("cd one && hottel " + arguments + " --threads 1 --quiet");
  const auto expected = files_in(place, "one");
  for (const int ranks : numbers_of_ranks) {
    place.run("rm -rf some; mkdir some");
    const Outcome some = place.run("cd some && " + mpirun(ranks) + arguments + " --threads 1 --quiet");
    EXPECT_EQ(some.code, one.code) << ranks << " ranks: " << arguments << "\n" << some.err;
    EXPECT_EQ(some.out, one.out) << ranks << " ranks: " << arguments;
    const auto files = files_in(place, "some");
    ASSERT_EQ(files.size(), expected.size()) << ranks << " ranks: " << arguments;
    for (std::size_t k = 0; k < files.size(); ++k) {
      EXPECT_EQ(files[k].first, expected[k].first);
      EXPECT_TRUE(files[k].second == expected[k].second) << ranks << " ranks: " << arguments << ": " << files[k].first;
    }
  }
}

// A few scenes, for every run of the tests.
TEST(Ranks, GiveTheFilesOfOneProcess) {
  for (const std::string scene : {"showcase/apartment.json", "space/two_boxes.json"}) {
    expect_same_on({2, 3}, "factors " + kScenes + scene);
    expect_same_on({2, 3}, "solve " + kScenes + scene + " -o out --no-illumination");
  }
}

TEST(RanksOnManyScenes, GiveTheFilesOfOneProcess) {
  for (const std::string scene :
       {"analytic/circles_equal_16.json", "analytic/strip_obstructed.json", "analytic/wedge_30deg.json",
        "analytic/patch_on_strip.json", "degenerate/blockers_on_one_bitangent.json", "degenerate/kettner_b2.json",
        "degenerate/rounding_tie.json", "degenerate/three_concurrent_bitangents.json", "showcase/museum.json",
        "space/cube.json", "space/hat_in_a_box.json", "analytic/space/patch_on_floor.json",
        "analytic/space/nested_cubes.json", "degenerate/space/interpenetrating.json",
        "degenerate/space/cube_in_cube.json", "degenerate/space/window.json"}) {
    expect_same_on({1, 2, 3, 5}, "factors " + kScenes + scene + " -o f.csv");
    expect_same_on({3}, "solve " + kScenes + scene + " -o out");
  }
}

TEST(Ranks, GiveEveryFormatOfFactors) {
  for (const std::string scene : {"showcase/apartment.json", "space/two_boxes.json"})
    for (const std::string ending : {"csv", "npy", "mtx",
#ifdef HOTTEL_HDF5
                                     "h5"
#else
                                     "csv"
#endif
         })
      expect_same_on({2}, "factors " + kScenes + scene + " -o f." + ending);
}

TEST(Ranks, GiveWhatOtherCommandsGive) {
  const std::string boxes = kScenes + "space/two_boxes.json";
  expect_same_on({3}, "factors " + boxes + " --per element --elements 3 --guarantee enclosed -o f.csv");
  expect_same_on({3}, "factors " + boxes + " --per group -o f.csv");
  expect_same_on({2}, "check " + boxes);
  expect_same_on({2}, "convert " + boxes + " out.json");
  expect_same_on({2}, "visibility " + boxes + " --from lamp --to floor");
  expect_same_on({2}, "--version");
  expect_same_on({2}, "factors " + kScenes + "showcase/apartment.json --rows 'window*' -o f.csv");
  expect_same_on({2}, "factors " + kScenes + "showcase/apartment.json --checkpoint sums -o f.csv");
}

// Systems so large that their rows are shared, in both dimensions.
TEST(Ranks, GiveTheRadiositiesOfOneProcess) {
  const Workplace place;
  place.run("hottel generate clutter --n 1500 --view long --seed 3 -o clutter.json");
  const std::string clutter = place.path("clutter.json").string();
  expect_same_on({1, 2, 3, 5}, "solve " + clutter + " -o out --no-illumination --no-picture");
  expect_same_on({3}, "solve " + clutter + " -o out --no-illumination --no-picture --solver bicgstab");
  expect_same_on({1, 2, 3, 5}, "solve " + kScenes + "space/cube.json --elements 10 -o out --render none.png");
}

// Planar grids and volumes, lights among solids, and a picture of what is lit.
TEST(Ranks, GiveTheLightOfOneProcess) {
  const Workplace place;
  std::string scene = testing_cli::contents(kScenes + "lights/stage.json");
  scene.insert(scene.rfind('}'), R"(, "grid": [
    {"name": "plan", "origin": [-2, -2, 1], "u": [8, 0, 0], "v": [0, 8, 0], "cells": [20, 16]},
    {"name": "air", "origin": [0, 0, 0.5], "u": [4, 0, 0], "v": [0, 4, 0], "w": [0, 0, 2], "cells": [6, 5, 4]}])");
  place.write("stage.json", scene);
  expect_same_on({1, 2, 3, 5}, "solve " + kScenes + "showcase/apartment.json --grid 300x220 -o out");
  expect_same_on({1, 2, 3, 5}, "solve " + place.path("stage.json").string() + " --tolerance 1e-4 -o out");
  expect_same_on({3}, "solve " + place.path("stage.json").string() + " --tolerance 1e-4 --illumination average -o out");
}

TEST(Ranks, RefuseOnceWithTheCodeOfOneProcess) {
  const Workplace place;
  const auto count_of = [](const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
  };
  for (const std::string& arguments :
       {"factors " + kScenes + "degenerate/space/window.json --tolerance 1e-16 --guarantee enclosed -o f.csv",
        "factors " + kScenes + "space/two_boxes.json --per element --elements 16 --memory 100K -o f.csv",
        "factors " + kScenes + "space/no_such_scene.json", std::string("factors --no-such-option")}) {
    const Outcome one = place.run("hottel " + arguments);
    ASSERT_NE(one.code, 0) << arguments;
    const std::string first_line = one.err.substr(0, one.err.find('\n'));
    const Outcome some = place.run(mpirun(3) + arguments);
    EXPECT_EQ(some.code, one.code) << arguments << "\n" << some.err;
    EXPECT_EQ(count_of(some.err, first_line), 1u) << some.err;
    EXPECT_EQ(some.out, one.out);
    EXPECT_TRUE(place.files().empty());
  }
}

// Whichever rank dies, the job ends, and no file is there. Where mpirun kills rank 0 before it has removed its
// temporary file the next run removes it.
TEST(Ranks, EndWithoutFilesWhereOneIsTerminated) {
  for (const std::string victim : {"0", "1", "2"}) {
    const Workplace place;
    const std::string work =
        "factors " + kScenes + "space/cornell_box.json --elements 6 --per element -o f.csv --quiet";
    const Outcome some = place.run(
        "timeout 120 mpirun --oversubscribe --allow-run-as-root --bind-to none -n 3 sh -c 'echo $$ > "
        "../pid.$OMPI_COMM_WORLD_RANK; exec \"" +
        std::string(HOTTEL_MPI_PROGRAM) + "\" " + work + "' & job=$!; for k in $(seq 200); do [ -s ../pid." + victim +
        " ] && break; sleep 0.1; done; sleep 2; kill -TERM $(cat ../pid." + victim + "); wait $job");
    EXPECT_NE(some.code, 0);
    EXPECT_NE(some.code, 124) << "the job hangs";
    place.run("hottel factors " + kScenes + "analytic/square_radiosity.json -o next.csv --quiet");
    EXPECT_EQ(place.files(), std::vector<std::string>{"next.csv"}) << victim;
  }
}

TEST(Ranks, SpeakAsTheProtocolSays) {
  const Workplace place;
  const Outcome some = place.run("timeout 120 mpirun --oversubscribe --allow-run-as-root --bind-to none -n 4 '" +
                                 std::string(HOTTEL_PROTOCOL_PROGRAM) + "'");
  EXPECT_EQ(some.code, 0) << some.out << some.err;
}

}  // namespace
}  // namespace hottel::ranks_test
