// A run that is killed without warning leaves every file whole: as it was, or as it would have been.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/program.h"
#include "tests/sanitizers.h"

namespace hottel::killed_test {
namespace {

using testing_cli::Workplace;

constexpr int kKills = kHasAddressSanitizer ? 20 : 200;

const std::string kScene = std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/strip_obstructed.json";
const std::vector<std::string> kFiles = {"radiosity.csv", "illumination.npy", "illumination.png"};

// Starts `hottel solve` into the folder, and returns its process.
pid_t start(const std::string& folder, const std::string& elements) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int null = ::open("/dev/null", O_WRONLY);
  ::dup2(null, 1);
  ::dup2(null, 2);
  ::execl(HOTTEL_PROGRAM, "hottel", "solve", kScene.c_str(), "-o", folder.c_str(), "--elements", elements.c_str(),
          "--grid", "64x64", nullptr);
  ::_exit(126);
}

bool succeeded(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Killed, LeavesOldOrNewFilesAlwaysWhole) {
  const Workplace place;
  const std::string folder = place.path("out").string();
  const auto files = [&place](const std::string& in) {
    std::vector<std::string> texts;
    for (const std::string& name : kFiles) texts.push_back(place.read(in + "/" + name));
    return texts;
  };
  ASSERT_TRUE(succeeded(start(place.path("new").string(), "3")));
  ASSERT_TRUE(succeeded(start(folder, "2")));
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(succeeded(start(folder, "2")));
  const auto whole_run = std::chrono::steady_clock::now() - began;
  const auto before = files("out"), after = files("new");
  ASSERT_NE(before[0], after[0]);

  std::mt19937_64 random(1);
  int killed = 0, replaced = 0;
  for (int k = 0; k < kKills; ++k) {
    const pid_t process = start(folder, "3");
    const auto wait = std::chrono::duration_cast<std::chrono::microseconds>(whole_run).count();
    ::usleep(static_cast<useconds_t>(random() % static_cast<std::uint64_t>(wait * 5 / 4 + 1)));
    ::kill(process, SIGKILL);
    killed += !succeeded(process);
    const auto now = files("out");
    bool is_replaced = false;
    for (std::size_t f = 0; f < kFiles.size(); ++f) {
      ASSERT_TRUE(now[f] == before[f] || now[f] == after[f]) << kFiles[f] << " after kill " << k;
      is_replaced |= now[f] == after[f] && before[f] != after[f];
    }
    ASSERT_TRUE(nlohmann::json::accept(place.read("out/report.json"))) << "after kill " << k;
    replaced += is_replaced;
    if (is_replaced) {
      ASSERT_TRUE(succeeded(start(folder, "2")));
    }
  }
  EXPECT_GT(killed, kKills / 4);
  ASSERT_TRUE(succeeded(start(folder, "2")));
  for (const auto& entry : testing_cli::fs::directory_iterator(folder))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".hottel-")) << entry.path();
  std::printf("%d of %d runs killed, %d of all had replaced something\n", killed, kKills, replaced);
}

}  // namespace
}  // namespace hottel::killed_test
