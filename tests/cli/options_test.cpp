// No option is ignored in silence: a table of all options of all commands, each with a line in which it has an effect
// and lines in which it would have none, which are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/cli/option_table.h"
#include "tests/cli/program.h"

namespace hottel::options_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

// A place with the scenes of the table; $S, $Q, ... stand for them in its lines.
class OptionPlace {
 public:
  OptionPlace() {
    std::filesystem::create_directory_symlink(std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes",
                                              place_.path("scenes"));
    for (const auto& [name, text] : option_scenes()) place_.write(name, text);
  }
  Outcome run(const std::string& line) const { return place_.run(kOptionVariables + ("; " + line)); }

 private:
  Workplace place_;
};

// "--threads" of a line "  --threads N    Number of ...", "--help" of "  -h,--help   Print ...", "-o" of "  -o FILE".
std::set<std::string> options_of(const std::string& help) {
  std::set<std::string> names;
  for (const std::string& line : lines_of(help)) {
    if (!line.starts_with("  -")) continue;
    const std::string spelled = line.substr(2, line.find(' ', 2) - 2);
    names.insert(spelled.substr(spelled.find(',') + 1));
  }
  return names;
}

TEST(Options, OfEveryCommandAreInTheTable) {
  const OptionPlace place;
  std::set<std::string> there, listed;
  for (const OptionCommand& command : option_commands()) {
    const std::string name = command.name;
    for (const std::string& option : options_of(place.run("hottel " + name + " --help").out))
      there.insert(name + " " + option);
    for (const char* option : {"--help", "--quiet", "--threads"}) listed.insert(name + " " + option);
  }
  for (const OptionEntry& entry : option_entries()) listed.insert(entry.command + (" " + std::string(entry.option)));
  EXPECT_EQ(there, listed) << "an option that is new needs an entry in tests/cli/option_table.cpp";
}

TEST(Options, OfEveryCommandThereIsAreLookedAt) {
  const OptionPlace place;
  const auto help = lines_of(place.run("hottel --help").out);
  const auto head = std::find(help.begin(), help.end(), "Subcommands:");
  ASSERT_NE(head, help.end());
  std::set<std::string> there, listed;
  for (auto line = head + 1; line != help.end() && line->starts_with("  "); ++line)
    if ((*line)[2] != ' ') there.insert(line->substr(2, line->find(' ', 2) - 2));
  for (const OptionCommand& command : option_commands()) listed.insert(command.name);
  EXPECT_EQ(there, listed);
}

std::string test_name(const std::string& text) {
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

class EveryOption : public testing::TestWithParam<OptionEntry> {};

TEST_P(EveryOption, HasAnEffectOrIsRefused) {
  const OptionEntry& entry = GetParam();
  ASSERT_TRUE(entry.with != nullptr || !entry.refused.empty());
  if (entry.with != nullptr) {
    EXPECT_THAT(entry.with, HasSubstr(entry.option));
    const Outcome with = OptionPlace().run(entry.with), without = OptionPlace().run(entry.without);
    EXPECT_EQ(with.code, 0) << entry.with << "\n" << with.err;
    EXPECT_EQ(without.code, 0) << entry.without << "\n" << without.err;
    EXPECT_NE(with.out, "") << entry.with;
    EXPECT_NE(with.out, without.out) << entry.with << "\n" << entry.without;
  }
  const OptionPlace place;
  for (const OptionRefusal& refusal : entry.refused) {
    const Outcome outcome = place.run(refusal.line);
    EXPECT_EQ(outcome.code, 2) << refusal.line << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << refusal.line;
    EXPECT_THAT(outcome.err, StartsWith("hottel: ")) << refusal.line;
    EXPECT_THAT(lines_of(outcome.err).at(0), HasSubstr(refusal.message)) << refusal.line;
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryOption, testing::ValuesIn(option_entries()), [](const auto& test) {
  return test_name(std::string(test.param.command) + test.param.option);
});

class EveryCommand : public testing::TestWithParam<OptionCommand> {};

TEST_P(EveryCommand, IsQuietAndTheSameForAnyNumberOfThreads) {
  const std::string line = GetParam().line;
  const Outcome quiet = OptionPlace().run(line + " --quiet");
  EXPECT_EQ(quiet.code, 0) << quiet.err;
  EXPECT_EQ(quiet.err, "");
  const Outcome one = OptionPlace().run(line + " --threads 1"), two = OptionPlace().run(line + " --threads 02");
  EXPECT_EQ(two.code, 0) << two.err;
  EXPECT_EQ(one.out, two.out);
  for (const char* number : {"0", "4097", "-1", "1.5", "x", "18446744073709551617"})
    EXPECT_EQ(OptionPlace().run(line + " --threads " + number).code, 2) << number;
  const Outcome twice = OptionPlace().run("hottel --threads 1 " + line.substr(7) + " --threads 2");
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("--threads is given twice"));
}

// Of every option that takes a value, as `--option ''` and as `--option=`.
TEST_P(EveryCommand, RefusesValuesThatAreEmpty) {
  const OptionPlace place;
  const std::string line = GetParam().line, name = GetParam().name;
  for (const OptionEntry& entry : option_entries()) {
    if (entry.command != name) continue;
    const std::string option = entry.option;
    const Outcome outcome = place.run(line + " " + option + " ''");
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, StartsWith("hottel: " + option + " is empty\n"));
    if (!option.starts_with("--")) continue;
    EXPECT_THAT(place.run(line + " " + option + "=").err, StartsWith("hottel: " + option + " is empty\n"));
  }
  const Outcome argument = place.run("hottel " + name + " ''");
  EXPECT_EQ(argument.code, 2);
  EXPECT_THAT(argument.err, StartsWith("hottel: an argument is empty\n"));
}

INSTANTIATE_TEST_SUITE_P(, EveryCommand, testing::ValuesIn(option_commands()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Options, NumbersAreDecimalAndRefusedWhereTheyWouldBeCut) {
  const OptionPlace place;
  EXPECT_EQ(place.run("hottel generate plates --n 0100").out, place.run("hottel generate plates --n 100").out);
  EXPECT_NE(place.run("hottel generate plates --seed 18446744073709551615").out,
            place.run("hottel generate plates --seed 18446744073709551614").out);
  for (const char* line : {"hottel generate plates --seed 18446744073709551616", "hottel generate plates --seed 1e3",
                           "hottel generate plates --n 10000001", "hottel generate plates --digits 0",
                           "hottel generate plates --digits 19", "hottel generate lattice --k 0",
                           "hottel generate lattice --k 100001", "hottel solve $Q --iterations 1000000001",
                           "hottel solve $Q --memory 18446744073709551616", "hottel factors $S --elements 1000001",
                           "hottel compare $Q --worst 18446744073709551616", "hottel compare $Q --repeat 0"}) {
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_EQ(outcome.out, "") << line;
  }
}

}  // namespace
}  // namespace hottel::options_test
