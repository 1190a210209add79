// Factors of other programs: as a method, compared, judged in words; from outside.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel::external_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kBox = std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json";
const std::string kApartment = std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/apartment.json";

// A number of a line of csv, counted from its end, where no names are.
double number_from_end(const std::string& line, std::size_t place) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return std::stod(fields.at(fields.size() - place));
}

TEST(External, EveryFormatOfFactorsIsReadBackAsAMethod) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kBox + " --quiet -o exact.csv").code, 0);
  for (const std::string name : {"f.csv", "f.mtx", "f.npy"}) {
    const Outcome outcome = place.run("hottel factors " + kBox + " --quiet -o " + name + " && hottel factors " + kBox +
                                      " --quiet --method file:" + name +
                                      " | cut -d, -f1-3 > a; cut -d, -f1-3 exact.csv "
                                      "| diff a -");
    EXPECT_EQ(outcome.code, 0) << name << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(External, ApproximateFactorsAreMarkedAsSuch) {
  const Workplace place;
  const Outcome outcome = place.run("hottel factors " + kBox + " --method strings");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(lines_of(outcome.out).at(1), testing::EndsWith(",0,1,,estimated"));
  EXPECT_THAT(outcome.err, HasSubstr("view factors by strings: estimated"));
  EXPECT_EQ(place.run("hottel factors " + kBox + " --method strings --pairs facing").code, 2);
  EXPECT_EQ(place.run("hottel factors " + kBox + " --method strings --script-f").code, 2);
  EXPECT_EQ(place.run("hottel factors " + kBox + " --method nonsense").code, 2);
  EXPECT_THAT(place.run("hottel factors " + kBox + " --method nonsense").err, HasSubstr("file:PATH, run:CMD"));
}

// A list has no place for a row that it leaves out, so that nothing refuses it.
TEST(External, ARowThatAListLeavesOutIsNamed) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kBox + " --per element --quiet -o exact.csv").code, 0);
  std::string without_floor;
  for (const std::string& line : lines_of(place.read("exact.csv")))
    if (!line.starts_with("floor,")) without_floor += line + "\n";
  place.write("some.csv", without_floor);
  EXPECT_THAT(place.run("hottel solve " + kBox + " --method file:some.csv -o solved").err,
              HasSubstr("; there is no row of 'floor', taken to see nothing\n"));
}

// The average over elements, put together, is the factor of the face when the elements' factors are exact.
TEST(External, ElementsArePutTogetherToFacesAndGroups) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kBox + " --quiet -o exact.csv").code, 0);
  ASSERT_EQ(place.run("hottel factors " + kBox + " --quiet --method exact:normalised --elements 3 -o a.csv").code, 0);
  const auto exact = lines_of(place.read("exact.csv")), put_together = lines_of(place.read("a.csv"));
  ASSERT_EQ(exact.size(), put_together.size());
  for (std::size_t k = 1; k < exact.size(); ++k)
    EXPECT_NEAR(number_from_end(exact[k], 5), number_from_end(put_together[k], 5), 1e-15) << put_together[k];
}

TEST(External, SolveBoundsAreThoseOfTheFactorsThatWereGiven) {
  const Workplace place;
  for (const std::string method : {"exact", "center"})
    ASSERT_EQ(place.run("hottel solve " + kBox + " --quiet --grid 4x4 -o " + method + " --method " + method).code, 0);
  const auto exact = lines_of(place.read("exact/radiosity.csv")), rough = lines_of(place.read("center/radiosity.csv"));
  ASSERT_EQ(exact.size(), rough.size());
  bool is_any_missed = false;
  for (std::size_t k = 1; k < exact.size(); ++k) {
    const double radiosity = number_from_end(rough[k], 5), lower = number_from_end(rough[k], 4),
                 upper = number_from_end(rough[k], 3), real = number_from_end(exact[k], 5);
    EXPECT_LE(lower, radiosity) << rough[k];
    EXPECT_GE(upper, radiosity) << rough[k];
    EXPECT_LE(upper - lower, 1e-14 * upper) << rough[k];
    is_any_missed |= real < lower || real > upper;
  }
  EXPECT_TRUE(is_any_missed);
  const auto report = nlohmann::json::parse(place.read("center/report.json"));
  EXPECT_THAT(report["notes"][0], StartsWith("view factors by center: estimated"));
  EXPECT_EQ(report["bounds"]["guarantee"], "estimated");
  const auto notes = report["notes"].get<std::vector<std::string>>();
  EXPECT_THAT(notes, testing::Contains(StartsWith("view factors are estimates: the bounds are those of")));
  EXPECT_EQ(nlohmann::json::parse(place.read("exact/report.json"))["bounds"]["guarantee"], "enclosed");
}

// Where lengths are near the resolution of fixed point, enclosed factors are far from the exact ones.
TEST(External, SolveBoundsHoldForEnclosedFactors) {
  const Workplace place;
  place.write("s.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
      "edges": [{"name": "large", "points": [[1, 0], [-1, 0]], "material": "m"},
                {"name": "small", "points": [["-1e-20", "1e-20"], ["1e-20", "1e-20"]], "material": "m"}]})");
  for (const std::string method : {"exact", "arithmetic:bounds"})
    ASSERT_EQ(place.run("hottel solve s.json --quiet --grid 4x4 -o " + method + " --method " + method).code, 0);
  const auto exact = lines_of(place.read("exact/radiosity.csv")),
             rough = lines_of(place.read("arithmetic:bounds/radiosity.csv"));
  ASSERT_EQ(exact.size(), rough.size());
  for (std::size_t k = 1; k < exact.size(); ++k) {
    EXPECT_LE(number_from_end(rough[k], 4), number_from_end(exact[k], 4)) << rough[k];  // lower
    EXPECT_GE(number_from_end(rough[k], 3), number_from_end(exact[k], 3)) << rough[k];  // upper
  }
}

TEST(External, AListWithoutPairsIsAMatrixOfZeros) {
  const Workplace place;
  place.write("f.csv", "from,to,factor\n");
  place.write("f.csv.faces.csv", "face\nwall\n");  // of another file
  const Outcome outcome = place.run("hottel factors " + kBox + " --quiet --method file:f.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "from,to,factor,lower,upper,visibility,guarantee\n");
}

TEST(External, CompareRefusesAListWithoutPairs) {
  const Workplace place;
  place.write("f.csv", "from,to,factor\n");
  const std::string compare = "hottel compare " + kBox + " --repeat 1 -o out --methods ";
  Outcome outcome = place.run(compare + "file:f.csv");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "f.csv: holds no factor of any face: there is nothing to judge\n");
  outcome = place.run(compare + "'run:cp f.csv {out.csv}'");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("what it wrote holds no factor of any face"));
}

TEST(External, CompareTellsOfColumnsOnlyWhereLightGoes) {
  const Workplace place;
  place.write("room.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
    "polylines": [{"name": "room", "points": [[0, 0], [0, 2], [4, 2], [4, 0]], "closed": true, "material": "m"}]})");
  place.write("f.csv", "0,0.3,0.4,0.3\n0.15,0,0.15,0.7\n0.4,0.3,0,0.3\n0.15,0.7,0.15,0\n");
  const Outcome outcome = place.run("hottel compare room.json --repeat 1 -o out --methods file:f.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("column")));
  EXPECT_THAT(place.run("hottel solve room.json --method file:f.csv --grid 2x2 -o out").err,
              HasSubstr("no column for the sky"));
}

TEST(External, SolveRefusesNegativeFactorsAndFailsWithTheCommand) {
  const Workplace place;
  place.write("f.csv", "from,to,factor\nwall,floor,-0.25\n");
  const std::string solve = "hottel solve " + kBox + " --quiet --grid 4x4 -o out --method ";
  Outcome outcome = place.run(solve + "file:f.csv");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("a factor of 'wall' is negative (-0.25)"));
  outcome = place.run(solve + "'run:echo to nowhere >&2; exit 5'");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, StartsWith("to nowhere\n"));
  EXPECT_THAT(outcome.err, HasSubstr("ended with status 5"));
  outcome = place.run("trap '' CHLD; " + solve + "'run:exit 6'");
  EXPECT_THAT(outcome.err, HasSubstr("ended with status 6"));
  outcome = place.run(solve + "file:missing.csv");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, StartsWith("missing.csv: there is no such file"));
}

TEST(External, CompareFindsNothingWrongWithTheExactFactors) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel factors " + kApartment + " --quiet -o f.npy && hottel compare " + kApartment +
                " --methods 'file:f.npy,run:: one,two; hottel factors {scene} --quiet -o {out.mtx}' --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(place.read("out/compare.csv"));
  ASSERT_EQ(lines.size(), 3u);
  for (const std::size_t line : {1u, 2u}) EXPECT_EQ(number_from_end(lines[line], 4), 0) << lines[line];
  EXPECT_THAT(outcome.err, HasSubstr("pairs agree with the exact factors"));
}

TEST(External, CompareGivesEachFileAndCommandItsNameAndCurve) {
  const Workplace place;
  ASSERT_EQ(place
                .run("mkdir a b; hottel factors " + kBox +
                     " --per element --quiet -o a/own.csv && cp a/own.csv b/own.csv && "
                     "hottel compare " +
                     kBox +
                     " --methods 'file:a/own.csv,file:b/own.csv,mine=file:a/own.csv,"
                     "first try=run:cp a/own.csv {out},exact' --repeat 1 --json -o out > report.json")
                .code,
            0);
  const auto csv = lines_of(place.read("out/compare.csv"));
  ASSERT_EQ(csv.size(), 6u);
  EXPECT_THAT(csv[1], StartsWith("file:a/own.csv,estimated,,0,"));
  EXPECT_THAT(csv[3], StartsWith("mine,estimated,,0,"));
  EXPECT_THAT(csv[4], StartsWith("first try,estimated,"));
  const auto methods = nlohmann::json::parse(place.read("report.json"))["methods"];
  std::vector<std::string> curves;
  for (const auto& method : methods) curves.push_back(method["family"]);
  EXPECT_THAT(curves, testing::ElementsAre("own", "file:b/own.csv", "mine", "first try", "exact"));
  EXPECT_EQ(methods[2]["reference"], "a/own.csv");
  EXPECT_THAT(place.read("out/readings.csv"), HasSubstr(",first try,"));
  EXPECT_THAT(place.read("out/readings.csv"), testing::Not(HasSubstr(",mine,")));
}

TEST(External, CompareRefusesNamesThatAreNone) {
  const Workplace place;
  const auto said = [&](const std::string& methods) {
    const Outcome outcome = place.run("hottel compare " + kBox + " --methods '" + methods + "' -o out");
    EXPECT_EQ(outcome.code, 2) << methods;
    return outcome.err;
  };
  EXPECT_THAT(said("mine=gauss:4"), HasSubstr("--methods gives names to file: and run:"));
  EXPECT_THAT(said("exact=file:f.csv"), HasSubstr("'exact' is a method of hottel"));
  EXPECT_THAT(said("a=file:f.csv,a=file:g.csv"), HasSubstr("two methods are called 'a'"));
  EXPECT_THAT(said("=file:f.csv"), HasSubstr("--methods has an empty name before '='"));
  EXPECT_TRUE(place.files().empty());
}

TEST(External, CompareTellsWhatIsMissingApart) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel factors " + kBox +
                     " --per element --quiet -o exact.csv && grep -v '^wall,' exact.csv | "
                     "grep -v ',sky,' | grep -v '^floor,box\\[3\\],' > f.csv && hottel compare " +
                     kBox + " --methods file:f.csv --repeat 1 --json -o out > report.json 2> said")
                .code,
            0);
  const auto method = nlohmann::json::parse(place.read("report.json"))["methods"][0];
  EXPECT_EQ(method["missing"]["rows"], std::vector<std::string>{"wall"});
  EXPECT_EQ(method["missing"]["columns"], std::vector<std::string>{"sky"});
  EXPECT_EQ(method["missing"]["pairs"], 1);
  EXPECT_EQ(method["missing"]["largest"], method["max_error"]);
  EXPECT_EQ(method["missing"]["max_error_of_others"], 0);
  EXPECT_THAT(place.read("said"), HasSubstr("there is no row of 'wall': errors are of the other rows"));
  EXPECT_THAT(place.read("said"), HasSubstr("errors leave out what goes to 'sky'"));
  EXPECT_THAT(place.read("said"), HasSubstr("1 pair is 0 or left out where light goes"));
}

TEST(External, CompareNamesAPairThatIsWrong) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel factors " + kBox +
                " --per element --quiet -o f.csv && sed -i 's/^floor,wall,[^,]*/floor,wall,0.125/' f.csv && "
                "hottel compare " +
                kBox + " --methods file:f.csv --repeat 1 --json -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("1 is wrong by no pattern that is known: 'floor' to 'wall': 0.125 instead of"));
  EXPECT_THAT(outcome.out, HasSubstr("reciprocity A_i F_ij = A_j F_ji is broken by 1 pair ("));
}

TEST(External, CompareJudgesRadiositiesToo) {
  const Workplace place;
  const std::string compare = " --repeat 1 -o out && cat out/compare.csv";
  ASSERT_EQ(place.run("hottel solve " + kBox + " --quiet --grid 4x4 -o solved").code, 0);
  Outcome outcome = place.run("hottel compare " + kBox + " --methods file:solved/radiosity.csv" + compare);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("all 27 radiosities lie within the proven bounds"));
  EXPECT_THAT(outcome.out, HasSubstr("file:solved/radiosity.csv,estimated,,,,,0\n"));
  outcome = place.run(
      "sed 's/^\\(floor,0,g,[^,]*,[^,]*,[^,]*\\),[^,]*/\\1,0.75/' "
      "solved/radiosity.csv > b.csv; hottel compare " +
      kBox + " --methods file:b.csv" + compare);
  EXPECT_THAT(outcome.err, HasSubstr("1 of 27 radiosities lies outside the proven bounds"));
  EXPECT_THAT(outcome.err, HasSubstr("'floor' (g): 0.75 instead of"));
  place.write("c.csv", "face,channel,radiosity\nlamp,r,1\n");
  outcome = place.run("hottel compare " + kBox + " --methods file:c.csv" + compare);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, StartsWith("c.csv:2: the scene has no face with a material called 'lamp'"));
}

TEST(External, CompareNamesChannelsThatAreNotThere) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel solve " + kBox + " --quiet --grid 4x4 -o solved").code, 0);
  const auto said_without = [&](const std::string& lines) {
    const Outcome outcome = place.run("grep -v '" + lines + "' solved/radiosity.csv > less.csv; hottel compare " +
                                      kBox + " --methods file:less.csv -o out");
    EXPECT_EQ(outcome.code, 3);
    return outcome.err;
  };
  EXPECT_THAT(said_without(",g,"), StartsWith("less.csv: lacks the channel 'g': the scene has r, g, b\n"));
  EXPECT_THAT(said_without(",[rb],"), StartsWith("less.csv: lacks the channels 'r', 'b': the scene has r, g, b\n"));
  EXPECT_THAT(said_without("floor,0,g,"), StartsWith("less.csv: has no radiosity of 'floor'\n"));
}

TEST(External, CompareTellsVerdictsBeforeTheTableAndOnce) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kBox + " --per element --method center --quiet -o f.csv").code, 0);
  const Outcome outcome = place.run("hottel compare " + kBox + " --methods file:f.csv,exact --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::size_t off = outcome.err.find("file:f.csv: "), laws = outcome.err.find("reciprocity A_i F_ij"),
                    findings = outcome.err.find("this explains"), table = outcome.err.find("fastest..slowest");
  EXPECT_LT(off, laws);
  EXPECT_LT(laws, findings);
  EXPECT_LT(findings, table);
  EXPECT_LT(table, std::string::npos);
  EXPECT_EQ(outcome.err.find("reciprocity A_i F_ij", laws + 1), std::string::npos);
}

TEST(External, CtrlCStopsTheCommandAndLeavesNothing) {
  const Workplace place;
  const Outcome outcome = place.run(
      "mkdir tmp; export TMPDIR=$PWD/tmp; hottel factors " + kBox +
      " --method 'run:echo $$ > pid; sleep 60; echo {out}' & child=$!; until [ -s pid ]; do sleep 0.02; done; "
      "kill -INT $child; wait $child; code=$?; sleep 0.1; kill -0 $(cat pid) 2>/dev/null && echo alive; ls tmp; exit "
      "$code");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace hottel::external_test
