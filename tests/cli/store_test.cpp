// --store and hottel store, as a stranger runs them.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/sanitizers.h"

namespace hottel::store_test {
namespace {

using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
const std::string kCube = kScenes + "space/cube.json";
const std::string kFactors = "hottel factors " + kCube + " --per element --elements 3 --quiet";

TEST(Store, IsReadByTheNextRun) {
  const Workplace place;
  ASSERT_EQ(place.run(kFactors + " -o none.csv").code, 0);
  for (const char* computed : {"435", "0"}) {
    const Outcome outcome = place.run(kFactors + " -o kept.csv --store s --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    const std::uint64_t sum =
        report["store"]["computed"].get<std::uint64_t>() + report["store"]["read"].get<std::uint64_t>();
    EXPECT_EQ(sum, report["counts"]["pairs"]);
    EXPECT_EQ(report["store"]["computed"] == 0, computed == std::string("0"));
    EXPECT_EQ(place.read("kept.csv"), place.read("none.csv"));
  }
  EXPECT_EQ(place.files(), (std::vector<std::string>{"kept.csv", "none.csv", "s"}));
}

// Radiosities, bounds, light: all files but the report, which has seconds.
TEST(Store, ChangesNoResultOfSolveAndCompare) {
  for (const std::string& scene :
       std::vector<std::string>{kScenes + "showcase/museum.json", kScenes + "space/two_boxes.json"}) {
    const Workplace place;
    for (const std::string& method : std::vector<std::string>{"exact", "gauss:2"})
      for (const std::string& run : std::vector<std::string>{"none", "first --store s", "second --store s"}) {
        const Outcome outcome = place.run("hottel solve " + scene + " --elements 2 --method " + method +
                                          " --no-picture --no-illumination --quiet -o " + run);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::string folder = run.substr(0, run.find(' '));
        for (const char* file : {"radiosity.csv", "flux.csv"})
          EXPECT_EQ(place.read(folder + "/" + file), place.read(std::string("none/") + file)) << run << method;
        const auto report = nlohmann::json::parse(place.read(folder + "/report.json"));
        EXPECT_EQ(report.contains("store"), run != "none");
        if (run != "none") {
          EXPECT_EQ(report["store"]["computed"] == 0, folder == "second");
        }
      }
    const Outcome compared =
        place.run("hottel compare " + scene + " --elements 2 --methods gauss:1 --repeat 1 -o c --store s");
    ASSERT_EQ(compared.code, 0) << compared.err;
    EXPECT_NE(compared.err.find("exact factors: store s: "), std::string::npos) << compared.err;
  }
}

TEST(Store, IsRefusedByNameWhereItIsNone) {
  const Workplace place;
  place.write("scene.json", testing_cli::contents(kCube));
  for (const std::string& command :
       std::vector<std::string>{"factors scene.json -o f.csv --store scene.json", "store scene.json"}) {
    const Outcome outcome = place.run("hottel " + command);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("scene.json: is no store of factors"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(place.read("scene.json"), testing_cli::contents(kCube));
  EXPECT_EQ(place.run("hottel store missing").code, 3);
  EXPECT_EQ(place.files(), std::vector<std::string>{"scene.json"});
}

TEST(Store, ThatCannotBeWrittenIsToldAsOtherOutputsAre) {
  const Workplace place;
  ASSERT_EQ(place.run(kFactors + " -o f.csv").code, 0);
  const std::string before = place.read("f.csv");
  Outcome outcome = place.run(kFactors + " -o f.csv --store no/such/folder/s");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("no/such/folder/s: cannot be written: there is no directory 'no/such/folder'"),
            std::string::npos)
      << outcome.err;
  outcome = place.run("ulimit -f 8; " + kFactors + " -o f.csv --store s");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("s: cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(place.read("f.csv"), before);
  ASSERT_EQ(place.run(kFactors + " -o f.csv --store s").code, 0) << "the store is as whole as before";
  EXPECT_EQ(place.read("f.csv"), before);

  ASSERT_EQ(place.run("mkdir shut; cp s shut/s; chmod 555 shut; chmod 444 shut/s").code, 0);
  const std::string as_nobody =
      ::geteuid() == 0 ? "chmod 755 .. .; setpriv --reuid 65534 --regid 65534 --clear-groups " : "";
  for (const char* file : {"shut/s", "shut/new"}) {
    outcome = place.run(as_nobody + kFactors + " --store " + file);
    EXPECT_EQ(outcome.code, 3) << file;
    EXPECT_NE(outcome.err.find(std::string(file) + ": cannot be written"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(place.run("chmod 755 shut").code, 0);
}

TEST(Store, IsUsedByTwoRunsAtOnce) {
  const Workplace place;
  ASSERT_EQ(place.run(kFactors + " -o none.csv").code, 0);
  for (int k = 0; k < 10; ++k) {
    const Outcome outcome =
        place.run(kFactors + " -o a.csv --store s & " + kFactors + " -o b.csv --store s; a=$?; wait $! && exit $a");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(place.read("a.csv"), place.read("none.csv"));
    EXPECT_EQ(place.read("b.csv"), place.read("none.csv"));
    ASSERT_EQ(place.run("hottel store s --check").code, 0);
    if (k % 2 == 1) {
      ASSERT_EQ(place.run("rm s").code, 0);
    }
  }
}

TEST(Store, IsCheckedAndShrunk) {
  const Workplace place;
  ASSERT_EQ(place.run(kFactors + " -o f.csv --store s").code, 0);
  ASSERT_EQ(place.run("hottel factors " + kScenes + "showcase/museum.json --quiet -o f.csv --store s").code, 0);
  Outcome outcome = place.run("hottel store s --check --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["lists"].size(), 2U);
  EXPECT_TRUE(report["damage"].empty());
  const std::uint64_t bytes = report["bytes"];
  outcome = place.run("hottel store s --shrink " + std::to_string(bytes - 1) + " --json");
  report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["lists"].size(), 1U);
  EXPECT_LT(report["bytes"], bytes);

  // A byte of a record is another one.
  std::string file = place.read("s");
  const std::string about = "museum.json by exact";
  const auto at = file.find(about);
  ASSERT_NE(at, std::string::npos);
  file[at] = 'M';
  place.write("s", file);
  outcome = place.run("hottel store s --check");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("s: is damaged: "), std::string::npos) << outcome.err;
  outcome = place.run("hottel factors " + kScenes + "showcase/museum.json -o f.csv --store s");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("damaged, and as good as not there"), std::string::npos) << outcome.err;
  EXPECT_EQ(place.run("hottel store s --check").code, 0) << "it was computed again";
}

pid_t start(const std::vector<std::string>& words) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int null = ::open("/dev/null", O_WRONLY);
  ::dup2(null, 1);
  ::dup2(null, 2);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execv(HOTTEL_PROGRAM, arguments.data());
  ::_exit(126);
}

bool succeeded(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Every tenth time the store is begun anew, so that runs are killed while they make it, fill it and read it.
TEST(Store, IsNeverWrongAfterItsRunsAreKilled) {
  const Workplace place;
  const std::string store = place.path("s").string();
  const auto run = [&](const std::string& elements, const std::string& out, bool is_kept) {
    std::vector<std::string> words = {"hottel",     "factors", kCube, "--per",         "element",
                                      "--elements", elements,  "-o",  place.path(out), "--quiet"};
    if (is_kept) words.insert(words.end(), {"--store", store});
    return start(words);
  };
  ASSERT_TRUE(succeeded(run("3", "3.csv", false)));
  ASSERT_TRUE(succeeded(run("4", "4.csv", false)));
  // A run that takes all from the store: the shorter one.
  ASSERT_TRUE(succeeded(run("4", "now.csv", true)));
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(succeeded(run("4", "now.csv", true)));
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - began);
  std::mt19937_64 random(1);
  const int kills = kHasAddressSanitizer || kHasThreadSanitizer ? 20 : 100;
  int killed = 0, runs = 0;
  for (int k = 0; killed < kills && k < 10 * kills; ++k, ++runs) {
    if (k % 10 == 0) {
      ASSERT_EQ(place.run("rm -f s s-wal s-shm s-journal").code, 0);
    }
    const std::string elements = random() % 2 == 0 ? "3" : "4";
    const pid_t process = run(elements, "killed.csv", true);
    ::usleep(static_cast<useconds_t>(random() % static_cast<std::uint64_t>(whole.count() + 1)));
    ::kill(process, SIGKILL);
    killed += !succeeded(process);
    if (k % 3 == 0) {
      ASSERT_TRUE(succeeded(run(elements, "now.csv", true))) << "after kill " << k;
      ASSERT_EQ(place.read("now.csv"), place.read(elements + ".csv")) << "after kill " << k;
      ASSERT_EQ(place.run("hottel store s --check").code, 0) << "after kill " << k;
    }
  }
  EXPECT_EQ(killed, kills);
  std::printf("%d of %d runs killed\n", killed, runs);
}

}  // namespace
}  // namespace hottel::store_test
