// What plan --out-of-core and --checkpoint tell, held against what runs with these take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/killed_run.h"
#include "tests/cli/program.h"
#include "tests/sanitizers.h"

namespace hottel::planned_on_disk_test {
namespace {

using namespace testing_cli;
using testing::HasSubstr;

// Bytes, the most at any one time.
struct Taken {
  bool succeeded = false;
  double memory = 0, disk = 0;
};

// What is neither program nor file.
double memory_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("RssAnon:")) return 1024 * std::atof(line.c_str() + 8);
  return 0;
}

// Files of a folder: those that have a name, and those that stand in the memory of a process.
double disk_of(pid_t process, const fs::path& folder) {
  double bytes = 0;
  std::error_code gone;
  for (fs::recursive_directory_iterator entry(folder, gone), end; !gone && entry != end; entry.increment(gone)) {
    std::error_code ignored;
    const auto size = entry->file_size(ignored);
    if (!ignored) bytes += static_cast<double>(size);
  }
  std::ifstream maps("/proc/" + std::to_string(process) + "/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find(folder.string() + "/") == std::string::npos || !line.ends_with("(deleted)")) continue;
    char* second = nullptr;
    const std::uint64_t begin = std::strtoull(line.c_str(), &second, 16);
    bytes += static_cast<double>(std::strtoull(second + 1, nullptr, 16) - begin);
  }
  return bytes;
}

Taken taken_by(const std::vector<std::string>& words, const fs::path& folder) {
  Taken taken;
  taken.succeeded = run(words, 1e9, [&](pid_t process) {
                      taken.memory = std::max(taken.memory, memory_of(process));
                      taken.disk = std::max(taken.disk, disk_of(process, folder));
                    }).succeeded;
  return taken;
}

struct OnDiskCase {
  const char* generated;
  const char* options = "";
  const char* where = "out-of-core";
};

class PlannedOnDisk : public testing::TestWithParam<OnDiskCase> {};

TEST_P(PlannedOnDisk, IsWhatARunTakesWithinAFactor) {
  const Workplace place;
  const OnDiskCase& asked_for = GetParam();
  const std::string options = asked_for.options, where = asked_for.where;
  ASSERT_EQ(place.run("hottel generate " + std::string(asked_for.generated) + " --seed 1 -o scene.json --quiet").code,
            0);
  fs::create_directory(place.path("d"));
  const std::string asked = options + " --memory 50000000 --" + where + " d";
  const auto planned = nlohmann::json::parse(
      place.run("hottel plan scene.json --json " + asked).out)[where == "checkpoint" ? where : "out_of_core"];
  EXPECT_TRUE(planned["fits"].get<bool>());
  EXPECT_GT(planned["seconds_estimate"].get<double>(), 0);
  std::vector<std::string> words = {"hottel",
                                    "solve",
                                    place.path("scene.json").string(),
                                    "--no-illumination",
                                    "--no-picture",
                                    "--quiet",
                                    "-o",
                                    place.path("out").string(),
                                    "--memory",
                                    "50000000",
                                    "--" + where,
                                    place.path("d").string()};
  for (std::istringstream more{options}; more >> words.emplace_back();) continue;
  words.pop_back();
  const Taken taken = taken_by(words, place.path("d"));
  ASSERT_TRUE(taken.succeeded);
  const double memory = planned["memory"].get<double>(), disk = planned["disk"].get<double>();
  EXPECT_GT(disk, taken.disk / 1.2) << taken.disk;
  EXPECT_LT(disk, taken.disk * 2.5) << taken.disk;
  if (kHasAddressSanitizer || kHasThreadSanitizer) return;  // they take memory of their own
  EXPECT_GT(memory, taken.memory / 1.5) << taken.memory;
  EXPECT_LT(memory, taken.memory * 1.5) << taken.memory;
}

INSTANTIATE_TEST_SUITE_P(, PlannedOnDisk,
                         testing::Values(OnDiskCase{"clutter --n 20000"}, OnDiskCase{"clutter --n 2000 --view long"},
                                         OnDiskCase{"clutter --n 2000", "--elements 6"},
                                         OnDiskCase{"clutter --n 2000 --view long", "", "checkpoint"}));

TEST(PlanOutOfCore, TellsOfADiskWithoutRoom) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate clutter --n 200 --seed 1 -o scene.json --quiet").code, 0);
  const Outcome outcome = place.run("hottel plan scene.json --elements 100000 --memory 8000000000000 --out-of-core .");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("it does not fit")) << "elements";
  const Outcome fits = place.run("hottel plan scene.json --out-of-core .");
  EXPECT_THAT(fits.out, HasSubstr("\nsolve --out-of-core .\n  memory"));
  EXPECT_THAT(fits.out, testing::Not(HasSubstr("the disk has no room")));
}

}  // namespace
}  // namespace hottel::planned_on_disk_test
