// Pages against the program: each command that stands in them runs, and prints what stands below it.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::pages_test {
namespace {

using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
namespace fs = std::filesystem;

const fs::path kSource = HOTTEL_SOURCE_DIR;

// A command of a page, and what it prints there, on standard output first. "..." stands for any lines, and so does the
// end.
struct Example {
  std::string command;
  bool is_session = false;  // "$ COMMAND": the lines below are what it prints
  std::vector<std::string> printed{};
};

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at)) text.erase(at, part.size());
  return text;
}

// For a folder of its own: files that the page puts into /tmp lie in it, and the program is that which was built.
std::string moved(const std::string& line) { return without(without(line, "/tmp/"), "build/release/"); }

// SCENE: a synopsis, no command.
bool is_command(const std::string& line) {
  return (line.starts_with("hottel ") || line.find("| hottel ") != std::string::npos) &&
         line.find(" SCENE ") == std::string::npos;
}

// The commands in the blocks of a page that are not in a language.
std::vector<Example> examples_of(const std::string& page) {
  std::vector<Example> examples;
  bool is_block = false, is_plain = false, is_session = false;
  for (const std::string& typed : lines_of(contents(kSource / page))) {
    const std::string line = moved(typed);
    if (line.starts_with("```")) {
      is_block = !is_block;
      is_plain = is_block && line == "```";
      is_session = false;
    } else if (is_plain && line.starts_with("$ ")) {
      is_session = true;
      examples.push_back({line.substr(2), true});
    } else if (is_session) {
      examples.back().printed.push_back(line);
    } else if (is_plain && is_command(line)) {
      examples.push_back({line});
    }
  }
  return examples;
}

// The first line that a page has and the output has not in its place; empty where there is none.
std::string first_missing(const std::vector<std::string>& page, const std::vector<std::string>& output) {
  std::size_t at = 0;
  bool skips = false;
  for (const std::string& line : page) {
    if (line == "...") {
      skips = true;
      continue;
    }
    while (skips && at < output.size() && output[at] != line) ++at;
    if (at == output.size() || output[at] != line) return line;
    ++at;
    skips = false;
  }
  return "";
}

// Without a display a window is a picture of it.
std::string without_display(const std::string& command) {
  return command.find("hottel view ") == std::string::npos || command.find("--s") != std::string::npos
             ? command
             : command + " --screenshot seen.png";
}

struct Page {
  const char* file;
  std::size_t sessions, others;  // at least so many commands with and without their output
};
std::ostream& operator<<(std::ostream& stream, const Page& page) { return stream << page.file; }

class EveryPage : public testing::TestWithParam<Page> {};

TEST_P(EveryPage, HasCommandsThatRunAndPrintWhatItSays) {
  const Workplace place;
  fs::create_directory_symlink(kSource / "scenes", place.path("scenes"));
  fs::create_directory(place.path("build"));
  std::size_t sessions = 0, others = 0;
  for (const Example& example : examples_of(GetParam().file)) {
    SCOPED_TRACE(example.command);
    const Outcome outcome = place.run(without_display(example.command));
    const std::string printed = outcome.out + outcome.err;
    EXPECT_EQ(outcome.code, 0) << printed;
    EXPECT_EQ(first_missing(example.printed, lines_of(printed)), "") << printed;
    ++(example.is_session ? sessions : others);
  }
  EXPECT_GE(sessions, GetParam().sessions);
  EXPECT_GE(others, GetParam().others);
}

std::string name_of(const testing::TestParamInfo<Page>& page) {
  std::string name = fs::path(page.param.file).stem().string();
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Pages, EveryPage,
                         testing::Values(Page{"README.md", 1, 24}, Page{"docs/tutorial.md", 10, 2},
                                         Page{"docs/check.md", 3, 0}, Page{"docs/heat.md", 9, 0},
                                         Page{"docs/simulated.md", 3, 0}, Page{"docs/visibility_files.md", 6, 0}),
                         name_of);

TEST(Pages, ALineThatIsNotPrintedIsMissing) {
  EXPECT_EQ(first_missing({"a", "...", "d"}, {"a", "b", "c", "d", "e"}), "");
  EXPECT_EQ(first_missing({"a", "c"}, {"a", "b", "c"}), "c");
  EXPECT_EQ(first_missing({"...", "f"}, {"a", "b"}), "f");
  EXPECT_EQ(first_missing({"a"}, {}), "a");
}

}  // namespace
}  // namespace hottel::pages_test
