// Decks of View3D as scenes of every command, and written for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string worked_deck() { return contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/partition.vs3"); }

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream in(line);
  for (double number = 0; in >> number;) numbers.push_back(number);
  return numbers;
}

class Deck : public testing::Test {
 protected:
  void SetUp() override { place_.write("box.vs3", worked_deck()); }

  Outcome run(const std::string& line) const { return place_.run("hottel " + line); }

  // The lines of View3D's text of a scene.
  std::vector<std::string> text_of(const std::string& line) const {
    const Outcome outcome = run("factors " + line + " --quiet -o out.txt");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return lines_of(place_.read("out.txt"));
  }

  Workplace place_;
};

TEST_F(Deck, IsWrittenAsView3dDoesWithOneRowForWhatIsCombined) {
  const std::vector<std::string> lines = text_of("box.vs3");
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_EQ(lines[0], "View3D 4.0.0 0 0 0 9          ");
  EXPECT_EQ(numbers_of(lines[1]), (std::vector<double>{2, 2, 2, 2, 1, 0.75, 0.25, 0.5, 0.5}));
  for (std::size_t i = 0; i < 9; ++i) {
    const std::vector<double> row = numbers_of(lines[2 + i]);
    ASSERT_EQ(row.size(), 9u);
    double sum = 0;
    for (const double factor : row) sum += factor;
    EXPECT_NEAR(sum, 1, 1e-8) << i;
  }
  EXPECT_EQ(lines[11],
            "0.90000000000000002 0.90000000000000002 0.90000000000000002 0.90000000000000002 "
            "0.90000000000000002 0.90000000000000002 0.83999999999999997 0.5 0.5");
  // A wall and its window do not see each other, nor do the sides of the partition.
  EXPECT_EQ(numbers_of(lines[2 + 5])[6], 0);
  EXPECT_EQ(numbers_of(lines[2 + 7])[8], 0);
}

TEST_F(Deck, HasARowForEachSurfaceIfAskedFor) {
  EXPECT_EQ(numbers_of(text_of("box.vs3 --per face")[1]),
            (std::vector<double>{1, 2, 2, 2, 1, 0.75, 0.25, 0.5, 0.5, 1}));
}

TEST_F(Deck, IsASceneOfEveryCommand) {
  EXPECT_THAT(run("plan box.vs3").err, HasSubstr("encl=1 promises"));
  EXPECT_THAT(run("plan box.vs3").out, HasSubstr("exchange"));
  EXPECT_THAT(run("visibility box.vs3 --from window --to west").out, HasSubstr("window"));
  EXPECT_THAT(run("visibility box.vs3 --at 0.5,0.5,0.25").out, HasSubstr("partition-w"));
  for (const char* line : {"plan", "visibility --at 0.5,0.5,0.25", "factors"})
    EXPECT_EQ(run(std::string(line) + " box.vs3").code, 0) << line;
}

TEST_F(Deck, BecomesASceneOfTheSameFactors) {
  ASSERT_EQ(run("convert box.vs3 box.json").code, 0);
  EXPECT_THAT(place_.read("box.json"), HasSubstr("\"closed\": true"));
  EXPECT_EQ(text_of("box.vs3"), text_of("box.json --per group"));
}

TEST_F(Deck, IsWrittenAgainWithTheSameFactors) {
  const Outcome outcome = run("convert box.vs3 again.vs3");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("cut into pieces")));
  const std::vector<std::string> one = text_of("box.vs3"), two = text_of("again.vs3");
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    const std::vector<double> a = numbers_of(one[k]), b = numbers_of(two[k]);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t j = 0; j < a.size(); ++j) EXPECT_NEAR(a[j], b[j], 2e-9) << k << " " << j;
  }
}

TEST_F(Deck, OfAnObstructionThereIsNoRowAndItIsSeen) {
  place_.write("o.vs3",
               "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\nV 7 1 1 1\nV 8 0 1 1\n"
               "V 9 -9 -9 .5\nV 10 9 -9 .5\nV 11 9 9 .5\nV 12 -9 9 .5\n"
               "S 1 1 2 3 4 0 0 .5 low\nS 2 8 7 6 5 0 0 .5 high\nO 3 9 10 11 12\n");
  const std::vector<std::string> lines = text_of("o.vs3");
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[2], "0 0");
  EXPECT_EQ(lines[3], "0 0");
  const Outcome outcome = run("factors o.vs3 --quiet");
  EXPECT_THAT(outcome.out, HasSubstr("\nlow,O~3:back,"));
  EXPECT_THAT(outcome.out, HasSubstr("\nhigh,O~3,"));
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("\nO~3")));
}

TEST_F(Deck, IsCheckedAndItsObstructionsAreNoWarning) {
  place_.write("o.vs3",
               "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 0 1\nV 5 1 0 1\nV 6 1 1 1\n"
               "S 1 1 2 3 0 0 0 .5 low\nO 2 4 5 6 0\n");
  const Outcome outcome = run("check o.vs3 --json --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("black-back")));
  EXPECT_EQ(run("check box.vs3 --quiet").code, 0);
}

TEST_F(Deck, NullTakesItsAreaFromTheBase) {
  place_.write("n.vs3",
               "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\nV 7 1 1 1\nV 8 0 1 1\n"
               "V 9 .25 .25 0\nV 10 .75 .25 0\nV 11 .75 .75 0\nV 12 .25 .75 0\n"
               "S 1 1 2 3 4 0 0 .5 low\nS 2 8 7 6 5 0 0 .5 high\nN 3 12 11 10 9 1 0 .5 under\n");
  const std::vector<std::string> lines = text_of("n.vs3");
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(numbers_of(lines[1]), (std::vector<double>{0.75, 1}));
  EXPECT_THAT(run("factors n.vs3 --quiet").out, HasSubstr("\nhigh,under:back,"));
}

TEST_F(Deck, WrongOnesEndWithThreeAndNameFileLineAndSurface) {
  place_.write("bad.vs3", "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nS 1 1 2 3 0 0 0 2 warm\n");
  for (const char* command :
       {"factors bad.vs3", "plan bad.vs3", "convert bad.vs3 -", "visibility bad.vs3 --at 1,1,1"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 3) << command;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_THAT(outcome.err, StartsWith("bad.vs3:5: surface 1: the emittance 2 is not from 0 to 1")) << command;
  }
}

TEST_F(Deck, HoldsScenesInSpaceOnly) {
  place_.write("flat.json", contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/triangle_345.json"));
  const Outcome outcome = run("convert flat.json flat.vs3");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, StartsWith("flat.json: the scene is in the plane (dimension 2); a deck (.vs3) is in space"));
  EXPECT_EQ(run("convert flat.json flat2.json --per face").code, 2);
  EXPECT_THAT(place_.files(), ElementsAre("box.vs3", "flat.json"));
}

TEST_F(Deck, IsWrittenForFacesUnlessGroupsAreAskedFor) {
  place_.write("boxes.json", contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json"));
  const Outcome outcome = run("convert boxes.json faces.vs3 && hottel convert boxes.json groups.vs3 --per group");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("materials that are not gray have the mean of their channels"));
  EXPECT_THAT(outcome.err, HasSubstr("1 backs with a material are surfaces NAME-back"));
  EXPECT_THAT(place_.read("faces.vs3"), HasSubstr("   0 0   0.25   low.side_1\n"));
  EXPECT_THAT(place_.read("groups.vs3"), HasSubstr("   0 9   0.25   low.side_1\n"));
  EXPECT_EQ(numbers_of(text_of("faces.vs3")[0].substr(12)).back(), 18);
  EXPECT_EQ(text_of("faces.vs3")[1], text_of("boxes.json")[1]);
}

}  // namespace
}  // namespace hottel
