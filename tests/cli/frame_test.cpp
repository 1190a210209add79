// What holds for every command: exit codes, streams, messages, interruption, outputs that appear whole.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/temporary_folder.h"

namespace hottel::frame_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

struct Outcome {
  int code = -1;  // -1: ended by a signal
  std::string out, err;
};

std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// An empty directory to run the program in, in which scenes/ is that of the repository.
class Frame : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(directory_ / "work");
    fs::create_directory_symlink(fs::path(HOTTEL_SOURCE_DIR) / "scenes", directory_ / "work/scenes");
  }

  fs::path file(const std::string& name) const { return directory_ / "work" / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_ / "work"), fs::directory_iterator()));
  }

  // Starts a shell line in which `hottel` is the program; `exec` it to have its process id.
  pid_t start(const std::string& line) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::setenv("PATH", (fs::path(HOTTEL_PROGRAM).parent_path().string() + ":" + std::getenv("PATH")).c_str(), 1);
    const int out = ::open((directory_ / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = ::open((directory_ / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(out, 1);
    ::dup2(err, 2);
    if (::chdir((directory_ / "work").c_str()) == 0) ::execl("/bin/bash", "bash", "-c", line.c_str(), nullptr);
    ::_exit(126);
  }
  Outcome wait(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_all(directory_ / "out"), read_all(directory_ / "err")};
  }
  Outcome run(const std::string& line) const { return wait(start(line)); }

  TemporaryFolder directory_;
};

constexpr const char* kTriangle = "scenes/analytic/triangle_345.json";

std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.rfind("  ", 0) == 0)
    if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST_F(Frame, HelpAndVersionGoToStandardOutput) {
  for (const char* line : {"hottel --help", "hottel --version", "hottel convert --help"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 0) << line;
    EXPECT_NE(outcome.out, "") << line;
    EXPECT_EQ(outcome.err, "") << line;
  }
  EXPECT_THAT(run("hottel --version").out, MatchesRegex("hottel [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(Frame, ExamplesOfEveryHelpWorkWhenPasted) {
  const std::vector<std::string> names = commands_of(run("hottel --help").out);
  EXPECT_THAT(names, ::testing::Contains("convert"));
  for (const std::string& name : names) {
    const std::string help = run("hottel " + name + " --help").out;
    ASSERT_THAT(help, HasSubstr("\nExamples:\n  hottel ")) << name;
    std::istringstream examples(help.substr(help.find("\nExamples:\n") + 11));
    for (std::string line; std::getline(examples, line);) {
      if (line.empty()) continue;
      const Outcome outcome = run(line);
      EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    }
  }
}

TEST_F(Frame, WrongUsageEndsWithTwoAndOneLineWithAHint) {
  for (const char* line :
       {"hottel", "hottel nonsense", "hottel convert", "hottel convert a.json", "hottel convert a.json b.json c.json",
        "hottel convert --nonsense a.json b.json", "hottel --threads 0 convert a.json b.json",
        "hottel convert a.json b.json --threads x", "hottel convert a.json b.json --threads 99999999999999999999",
        "hottel convert a.json b.json --threads 1 --threads 2", "hottel --quiet"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_THAT(outcome.err, StartsWith("hottel: ")) << line;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
  }
}

TEST_F(Frame, WrongEndingsEndWithTwo) {
  for (const char* line : {"convert scenes/analytic/triangle_345.json x.dxf",
                           "convert scenes/drawings/two_rooms.svg x.obj", "convert plan.dxf x.json"}) {
    const Outcome outcome = run(std::string("hottel ") + line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(Frame, WrongFilesEndWithThreeAndNameTheFileAndLine) {
  write("bad.json", "{\n  \"hottel\": 1,\n  \"hottel\": 1\n}\n");
  write("bad.svg", "<svg>\n<circle r='1'/></svg>\n");
  fs::create_directory(file("folder.json"));
  EXPECT_THAT(run("hottel convert missing.json -").err, MatchesRegex("missing\\.json: [^\n]*\n"));
  EXPECT_THAT(run("hottel convert folder.json -").err, MatchesRegex("folder\\.json: [^\n]*\n"));
  EXPECT_THAT(run("hottel convert bad.json -").err, MatchesRegex("bad\\.json:3: [^\n]*\n(  [^\n]+\n)*"));
  EXPECT_THAT(run("hottel convert bad.svg -").err, MatchesRegex("bad\\.svg:2: [^\n]*\n(  [^\n]+\n)*"));
  for (const char* name : {"missing.json", "folder.json", "bad.json", "bad.svg"}) {
    const Outcome outcome = run(std::string("hottel convert ") + name + " -");
    EXPECT_EQ(outcome.code, 3) << name;
    EXPECT_EQ(outcome.out, "") << name;
  }
}

TEST_F(Frame, MessagesAreOneLineWhateverTheFileIsCalled) {
  const Outcome outcome = run("hottel convert $'two\\nlines\\x1b.json' -");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, StartsWith("two\\x0Alines\\x1B.json: "));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST_F(Frame, OutputsThatCannotBeWrittenEndWithThree) {
  write("old.json", "old");
  for (const char* target : {"no/such/place.json", "old.json/x.json", "/dev/full/x.json"}) {
    const Outcome outcome = run(std::string("hottel convert ") + kTriangle + " " + target);
    EXPECT_EQ(outcome.code, 3) << target;
    EXPECT_THAT(outcome.err, StartsWith(std::string(target) + ": cannot be written: "));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(read_all(file("old.json")), "old");
}

TEST_F(Frame, AFullDiskEndsWithThreeAndLeavesTheEarlierFile) {
  write("old.json", "old");
  const std::size_t before = files();
  Outcome outcome = run(std::string("ulimit -f 0; hottel convert ") + kTriangle + " old.json");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(read_all(file("old.json")), "old");
  EXPECT_EQ(files(), before);
  outcome = run(std::string("hottel convert ") + kTriangle + " - > /dev/full");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "standard output: cannot be written: No space left on device\n");
  outcome = run(std::string("hottel convert ") + kTriangle + " - >&-");
  EXPECT_EQ(outcome.code, 3);
}

TEST_F(Frame, AReaderThatLeavesIsNoError) {
  const Outcome outcome = run("hottel generate clutter --n 20000 --quiet | head -1; echo ${PIPESTATUS[0]}");
  EXPECT_EQ(outcome.out, "{\n0\n");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Frame, QuietIsSilentButForErrors) {
  EXPECT_NE(run("hottel convert scenes/drawings/two_rooms.svg a.json").err, "");
  EXPECT_EQ(run("hottel convert scenes/drawings/two_rooms.svg a.json --quiet").err, "");
  EXPECT_EQ(run("hottel --quiet convert scenes/drawings/two_rooms.svg a.json").err, "");
  EXPECT_NE(run("hottel convert --quiet missing.json a.json").err, "");
}

TEST_F(Frame, NoProgressIsDrawnWhereNobodyWatches) {
  EXPECT_EQ(run("hottel factors scenes/showcase/apartment.json -o a.csv").err.find('\r'), std::string::npos);
}

TEST_F(Frame, ConvertingTwiceChangesNothing) {
  ASSERT_EQ(run("hottel convert scenes/drawings/two_rooms.svg a.json").code, 0);
  ASSERT_EQ(run("hottel convert a.json b.json").code, 0);
  EXPECT_EQ(read_all(file("a.json")), read_all(file("b.json")));
  EXPECT_NE(read_all(file("a.json")), "");
}

// Waits until the process is the program and catches Ctrl-C.
void wait_until_ready(pid_t child) {
  const std::string process = "/proc/" + std::to_string(child);
  for (int attempt = 0; attempt < 60'000; ++attempt) {
    const std::string status = read_all(process + "/status");
    const auto caught = status.find("SigCgt:");
    std::error_code error;
    if (caught != std::string::npos && fs::read_symlink(process + "/exe", error).filename() == "hottel" &&
        (std::stoull(status.substr(caught + 7), nullptr, 16) >> (SIGINT - 1) & 1) != 0)
      return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  FAIL() << "the program does not start";
}

TEST_F(Frame, CtrlCEndsWith130AndLeavesTheEarlierFile) {
  write("old.json", "old");
  const std::size_t before = files();
  const pid_t child = start("exec hottel generate clutter --n 3000000 -o old.json");
  wait_until_ready(child);
  ::kill(child, SIGINT);
  const Outcome outcome = wait(child);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(read_all(file("old.json")), "old");
  EXPECT_EQ(files(), before);
}

TEST_F(Frame, CtrlCEndsWorkThatWaitsForAReader) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  const pid_t child = start("exec hottel generate clutter --n 20000 -o - > pipe");
  const int reader = ::open(file("pipe").c_str(), O_RDONLY);
  char first = 0;
  ASSERT_EQ(::read(reader, &first, 1), 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(child, SIGINT);
  EXPECT_EQ(wait(child).code, 130);
  ::close(reader);
}

}  // namespace
}  // namespace hottel::frame_test
