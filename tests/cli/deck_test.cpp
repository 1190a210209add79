// Decks of View3D as scenes of every command, and written for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::deck_test {
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

// A unit cube with a box on its floor; the bottom of the box is record 12, of the kind and with the base given.
std::string box_on_a_floor(const std::string& controls, const std::string& kind) {
  return controls +
         "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\nV 7 1 1 1\nV 8 0 1 1\n"
         "V 9 .25 .25 0\nV 10 .75 .25 0\nV 11 .75 .75 0\nV 12 .25 .75 0\n"
         "V 13 .25 .25 .5\nV 14 .75 .25 .5\nV 15 .75 .75 .5\nV 16 .25 .75 .5\n"
         "S 1 1 2 3 4 0 0 .5 floor\nS 2 8 7 6 5 0 0 .9 ceiling\nS 3 1 5 6 2 0 0 .9 south\nS 4 4 3 7 8 0 0 .9 north\n"
         "S 5 1 4 8 5 0 0 .9 west\nS 6 2 6 7 3 0 0 .9 east\nS 7 13 14 15 16 0 0 .3 lid\nS 8 9 10 14 13 0 0 .3 side-s\n"
         "S 9 11 12 16 15 0 0 .3 side-n\nS 10 12 9 13 16 0 0 .3 side-w\nS 11 10 11 15 14 0 0 .3 side-e\n" +
         kind + " 12 12 11 10 9 1 0 .3 bottom\n";
}

std::string without(std::string text, const std::string& what, const std::string& with) {
  text.replace(text.find(what), what.size(), with);
  return text;
}

// The base has the area of the mask in its row, and loses to it what it sends there: 1/4.
TEST_F(Deck, AMaskSeesItsBaseAndHidesItFromAllOthers) {
  place_.write("m.vs3", box_on_a_floor("", "M"));
  place_.write("n.vs3", box_on_a_floor("", "N"));
  const std::vector<std::string> with_mask = text_of("m.vs3"), with_null = text_of("n.vs3");
  ASSERT_EQ(with_mask.size(), 15u);
  ASSERT_EQ(with_null.size(), 14u);
  const std::vector<double> areas = numbers_of(with_mask[1]), null_areas = numbers_of(with_null[1]);
  EXPECT_EQ(areas, (std::vector<double>{1, 1, 1, 1, 1, 1, .25, .25, .25, .25, .25, .25}));
  EXPECT_EQ(null_areas, (std::vector<double>{.75, 1, 1, 1, 1, 1, .25, .25, .25, .25, .25}));
  for (std::size_t i = 0; i < 12; ++i) {
    const std::vector<double> row = numbers_of(with_mask[2 + i]);
    double sum = 0;
    for (const double f : row) sum += f;
    EXPECT_NEAR(sum, 1, 1e-9) << i;
    EXPECT_EQ(row[11], i == 0 ? 0.25 : 0) << i;
    if (i == 11) {
      EXPECT_EQ(row[0], 1);
      continue;
    }
    // All other pairs are those of a null surface.
    const std::vector<double> other = numbers_of(with_null[2 + i]);
    for (std::size_t j = 0; j < 11; ++j)
      EXPECT_NEAR(row[j] * areas[i], other[j] * null_areas[i], 1e-10) << i << " " << j;
  }
}

// In a closed room of one temperature there is no net flux, in the gap neither.
TEST_F(Deck, MaskedOnesAreSolvedAsOthers) {
  place_.write("m.vs3", box_on_a_floor("", "M"));
  ASSERT_EQ(run("convert m.vs3 m.json").code, 0);
  std::string json = place_.read("m.json");
  for (std::size_t at = json.find("\"reflectivity\": 0."); at != std::string::npos;
       at = json.find("\"reflectivity\": 0."))
    json.replace(at, 18, "\"temperature\": 300, \"emissivity\": 0.");
  place_.write("warm.json", json);
  const Outcome outcome = run("solve warm.json -o warm --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(place_.read("warm/radiosity.csv"));
  ASSERT_EQ(lines.size(), 13u);
  EXPECT_THAT(lines[12], StartsWith("bottom,0,all,0.25,"));
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double radiosity = numbers_of(without(lines[k].substr(lines[k].find(",0,all,") + 7), ",", " "))[0];
    EXPECT_GT(radiosity, 0) << lines[k];
    EXPECT_NEAR(std::stod(lines[k].substr(lines[k].rfind(',') + 1)), 0, 1e-6) << lines[k];
  }
}

TEST_F(Deck, AMaskIsASurfaceOfEveryCommand) {
  place_.write("m.vs3", box_on_a_floor("", "M"));
  const Outcome pair = run("visibility m.vs3 --from bottom --to floor");
  EXPECT_EQ(pair.code, 0) << pair.err;
  EXPECT_THAT(pair.out, HasSubstr("F from 'bottom'              1  "));
  const Outcome on = run("visibility m.vs3 --on bottom --at 0.5,0.5,0");
  EXPECT_EQ(on.code, 1);
  EXPECT_THAT(on.err, HasSubstr("'bottom' at 0.5,0.5,0 lies on 'floor' and sees nothing else"));
  EXPECT_THAT(run("visibility m.vs3 --on floor --at 0.5,0.5").err, HasSubstr("lies on 'bottom' and sees nothing else"));
  EXPECT_EQ(run("visibility m.vs3 --on floor --at 0.1,0.1").code, 0);
  EXPECT_EQ(run("check m.vs3").code, 0);
  EXPECT_EQ(run("plan m.vs3").code, 0);
  EXPECT_EQ(run("convert m.vs3 again.vs3").code, 0);
  EXPECT_THAT(place_.read("again.vs3"), HasSubstr("   1 0   0.3   bottom\nEnd\n"));
  EXPECT_EQ(text_of("again.vs3"), text_of("m.vs3"));
  const Outcome mesh = run("convert m.vs3 m.obj");
  EXPECT_EQ(mesh.code, 1);
  EXPECT_THAT(mesh.err, HasSubstr("'bottom' is a mask, which a mesh file cannot hold"));
}

TEST_F(Deck, ItsRowAndColumnAreObeyed) {
  place_.write("all.vs3", box_on_a_floor("", "M"));
  place_.write("row.vs3", box_on_a_floor("C row=2\n", "M"));
  place_.write("one.vs3", box_on_a_floor("C row=2 col=7\n", "M"));
  const std::vector<std::string> all = text_of("all.vs3"), row = text_of("row.vs3"), one = text_of("one.vs3");
  EXPECT_EQ(row, (std::vector<std::string>{all[0], all[1], all[3], all[14]}));
  ASSERT_EQ(one.size(), 4u);
  EXPECT_EQ(numbers_of(one[2]), (std::vector<double>{numbers_of(all[3])[6]}));
  const Outcome list = run("factors one.vs3");
  EXPECT_EQ(lines_of(list.out).size(), 2u);
  EXPECT_THAT(list.out, HasSubstr("\nceiling,lid,"));
  EXPECT_THAT(list.err, HasSubstr("row: of all rows that of 'ceiling' is written; col: of that its factor to 'lid'"));
  ASSERT_EQ(run("factors row.vs3 --quiet -o row.mtx").code, 0);
  const std::string market = place_.read("row.mtx");
  EXPECT_EQ(lines_of(market)[2], "25 25 " + std::to_string(lines_of(market).size() - 3));
  for (std::size_t k = 3; k < lines_of(market).size(); ++k) EXPECT_THAT(lines_of(market)[k], StartsWith("3 "));
  EXPECT_THAT(run("factors row.vs3 -o row.npy").err, HasSubstr("for lists and View3D's files: .npy has all"));
  for (const char* command : {"plan row.vs3", "check row.vs3", "convert row.vs3 row.json", "solve row.vs3 -o out"})
    EXPECT_THAT(run(command).err, HasSubstr("row: obeyed by `hottel factors` only")) << command;
}

TEST_F(Deck, ItsEmitAsksForScriptF) {
  place_.write("plain.vs3", box_on_a_floor("", "M"));
  place_.write("emit.vs3", box_on_a_floor("C emit=1\n", "M"));
  const std::vector<std::string> plain = text_of("plain.vs3"), asked = text_of("plain.vs3 --script-f"),
                                 emit = text_of("emit.vs3");
  EXPECT_EQ(emit, asked);
  EXPECT_THAT(emit[0], StartsWith("View3D 4.0.0 0 0 1 "));
  EXPECT_NE(emit[2], plain[2]);
  // Rows sum to the emittance where the deck is closed.
  const std::vector<double> floor = numbers_of(emit[2]), emittances = numbers_of(emit.back());
  EXPECT_NEAR(std::accumulate(floor.begin(), floor.end(), 0.0), emittances[0], 1e-9);
  EXPECT_THAT(run("factors emit.vs3 -o f.csv").err, HasSubstr("emit=1: gray-body exchange factors, script-F, are"));
  EXPECT_THAT(run("factors emit.vs3 --matrix visibility -o v.csv").err,
              HasSubstr("emit=1 asks for script-F; view factors are written: --matrix visibility is of these"));
  EXPECT_EQ(run("factors emit.vs3 --method gauss:2 -o g.csv").code, 0);
  EXPECT_THAT(run("solve emit.vs3 -o out").err, HasSubstr("emit: obeyed by `hottel factors` only"));
}

// What is combined has one row, which is that of each of its parts.
TEST_F(Deck, ARowOfWhatIsCombinedIsThatOfTheWhole) {
  const std::string deck = without(box_on_a_floor("C row=5\n", "M"), "0 0 .9 north", "0 3 .9 north");
  place_.write("row.vs3", deck);
  // floor, ceiling, south with north, and west itself, which sees neither itself nor the gap.
  const std::vector<double> row = numbers_of(text_of("row.vs3")[2]);
  ASSERT_EQ(row.size(), 11u);
  EXPECT_EQ(row[3], 0);
  EXPECT_EQ(row[10], 0);
  EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 1, 1e-9);
  place_.write("part.vs3", without(deck, "row=5", "row=4"));
  const Outcome outcome = run("factors part.vs3");
  EXPECT_THAT(outcome.out, HasSubstr("\nsouth,ceiling,"));
  EXPECT_THAT(outcome.err, HasSubstr("that of 'north', which is combined in 'south' is written"));
}

TEST_F(Deck, ItsFormatIsThatOfAFileWhoseEndingSaysNone) {
  const auto write = [this](const std::string& controls) { place_.write("o.vs3", box_on_a_floor(controls, "M")); };
  write("C out=0\n");
  ASSERT_EQ(run("factors o.vs3 --quiet -o result && hottel factors o.vs3 --quiet -o result.txt").code, 0);
  EXPECT_EQ(place_.read("result"), place_.read("result.txt"));
  write("C out=1\n");
  ASSERT_EQ(run("factors o.vs3 --quiet -o result.vf && hottel factors o.vs3 --quiet -o result.bin").code, 0);
  EXPECT_EQ(place_.read("result.vf"), place_.read("result.bin"));
  EXPECT_THAT(run("factors o.vs3 -o result.txt").err, HasSubstr("out=1 asks for View3D's binary file, .bin"));
  EXPECT_THAT(place_.read("result.txt"), StartsWith("View3D 4.0.0 0 0 0 12"));
  write("C out=2\n");
  EXPECT_THAT(run("factors o.vs3 -o result.txt").err, HasSubstr("out=2, a sparse list, is not written as such"));
  EXPECT_EQ(run("factors o.vs3 -o result.sparse").code, 2);
  write("");
  EXPECT_EQ(run("factors o.vs3 -o result.vf").code, 2);
}

TEST_F(Deck, ItsListTellsTheRows) {
  const auto told = [this](const std::string& controls) {
    place_.write("l.vs3", box_on_a_floor(controls, "M"));
    return run("factors l.vs3 -o l.txt").err;
  };
  EXPECT_THAT(told("C list=0\n"), ::testing::Not(HasSubstr("rows: number")));
  const std::string one = told("C list=1\n"), two = told("C list=2\n"), three = told("C list=3\n");
  const std::string floor = "    1        floor  1.0000e+00 0.500  1.000000  0.000000\n";
  for (const std::string& text : {one, two, three}) EXPECT_THAT(text, HasSubstr(floor));
  EXPECT_THAT(one, HasSubstr("   12       bottom  2.5000e-01 0.300  1.000000  0.000000\n"));
  EXPECT_THAT(one, ::testing::Not(HasSubstr("1.000000 0.000000 0.000000")));
  EXPECT_THAT(two, HasSubstr("0.300  1.000000  0.000000\n      1.000000 0.000000 0.000000"));
  EXPECT_THAT(two, ::testing::Not(HasSubstr("(0, 0, 0)")));
  EXPECT_THAT(three, HasSubstr(floor + "      (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0)\n"));
  EXPECT_EQ(run("factors l.vs3 -o l.txt --quiet").err, "");
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
  EXPECT_THAT(outcome.err, HasSubstr("1 back with a material is a surface NAME-back"));
  EXPECT_THAT(place_.read("faces.vs3"), HasSubstr("   0 0   0.25   low.side_1\n"));
  EXPECT_THAT(place_.read("groups.vs3"), HasSubstr("   0 9   0.25   low.side_1\n"));
  EXPECT_EQ(numbers_of(text_of("faces.vs3")[0].substr(12)).back(), 18);
  EXPECT_EQ(text_of("faces.vs3")[1], text_of("boxes.json")[1]);
}

}  // namespace
}  // namespace hottel::deck_test
