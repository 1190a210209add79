// Solids as a stranger meets them: what check, solve and visibility say, and what --fix writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::solids_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::ordered_json;

// A room with a lamp, and a polyline 'box'.
std::string scene(const std::string& box, const std::string& room = "[0,0],[0,3],[4,3],[4,0]") {
  return R"({"hottel": 1, "dimension": 2,
  "materials": {"white": {"reflectivity": 0.5}, "lamp": {"emission": 1, "reflectivity": 0.5}},
  "edges": [{"name": "lamp", "points": [[1, 2], [1.5, 2]], "material": "lamp", "back": "lamp"}],
  "polylines": [{"name": "room", "points": [)" +
         room + R"(], "closed": true, "material": "white"},
    {"name": "box", "material": "white", )" +
         box + "}]}\n";
}
const std::string kClosed = R"("points": [[1,0],[2,0],[2,1],[1,1]], "closed": true)";
const std::string kThreeSides = R"("points": [[2,0],[2,1],[1,1],[1,0]])";

TEST(Solids, SolveWarnsOnceAGroupOfBlackBacksOnStderrAndInTheReport) {
  const Workplace place;
  place.write("s.json", scene(kThreeSides));
  const Outcome outcome = place.run("hottel solve s.json -o out --grid 4x3");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::size_t warnings = 0, notes = 0;
  for (const std::string& line : lines_of(outcome.err))
    warnings += line.find(": warning: black-back") != std::string::npos;
  EXPECT_EQ(warnings, 1u);
  const Json report = Json::parse(place.read("out/report.json"));
  for (const Json& note : report["notes"]) {
    if (!note.get<std::string>().starts_with("warning: black-back: the back of 'box[")) continue;
    EXPECT_THAT(note.get<std::string>(), AllOf(HasSubstr("'room[3]' loses F = "), HasSubstr("\"behind\": \"solid\"")));
    ++notes;
  }
  EXPECT_EQ(notes, 1u);
  EXPECT_EQ(place.run("hottel solve s.json -o out --grid 4x3 --quiet").err, "");
}

TEST(Solids, SolveAsksAboutARoomListedTheWrongWayRound) {
  const Workplace place;
  place.write("s.json", scene(kClosed, "[0,0],[4,0],[4,3],[0,3]"));
  const Outcome outcome = place.run("hottel solve s.json -o out --grid 4x3");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning: filled-room at"));
  EXPECT_THAT(Json::parse(place.read("out/report.json"))["notes"][0].get<std::string>(),
              AllOf(StartsWith("warning: filled-room: 'room' is solid"), HasSubstr("was a room meant?")));
}

TEST(Solids, CommandsRefuseABehindThatHasNoRegionAndNameTheGap) {
  const Workplace place;
  place.write("s.json", scene(R"("points": [[2,0.01],[2,1],[1,1],[1,0]], "behind": "solid")"));
  for (const char* command : {"check", "factors", "solve", "visibility --at 1,1"}) {
    const Outcome outcome = place.run(std::string("hottel ") + command + " s.json");
    EXPECT_EQ(outcome.code, 3) << command;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_THAT(outcome.err, HasSubstr("s.json:5: 'box': \"behind\" is \"solid\", but")) << command;
    EXPECT_THAT(outcome.err, HasSubstr("there is a gap at (2, 0.01), 0.01 from 'room[3]'")) << command;
  }
  EXPECT_THAT(place.files(), testing::ElementsAre("s.json"));
}

TEST(Solids, FixSaysSolidAndNothingIsLeftToWarnOf) {
  const Workplace place;
  place.write("s.json", scene(kThreeSides));
  const Outcome outcome = place.run("hottel check s.json --fix t.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("s.json:5: solid: 'box' says \"behind\": \"solid\" now\nfrom,to,before,after\n"));
  EXPECT_THAT(outcome.out, HasSubstr("0 errors, 0 warnings"));
  EXPECT_THAT(place.read("t.json"), HasSubstr("\"behind\": \"solid\""));
  EXPECT_THAT(place.run("hottel check t.json --fix u.json").out, StartsWith("t.json: nothing was repaired"));
  EXPECT_EQ(place.read("u.json"), place.read("t.json"));
}

TEST(Solids, FixSaysThatItLeavesARoomListedTheWrongWayRound) {
  const Workplace place;
  place.write("s.json", scene(kClosed, "[0,0],[4,0],[4,3],[0,3]"));
  const Outcome outcome = place.run("hottel check s.json --fix t.json");
  EXPECT_THAT(outcome.out,
              HasSubstr(": not-repaired: 'room' is left as it is, for it may be meant as a solid: where it "
                        "is a room, list its points the other way round\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("from,to,before,after")));
  EXPECT_EQ(Json::parse(place.run("hottel check s.json --fix t.json --json").out)["changes"], Json::array());
}

TEST(Solids, FixClosesAGapFirstAndThenSaysSolid) {
  const Workplace place;
  place.write("s.json", scene(R"("points": [[2,0.0001],[2,1],[1,1],[1,0]])"));
  EXPECT_THAT(place.run("hottel check s.json --fix t.json").out, StartsWith("s.json: nothing was repaired"));
  const Outcome outcome = place.run("hottel check s.json --json --fix t.json --within 0.001");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> kinds;
  const Json report = Json::parse(outcome.out);
  for (const Json& step : report["repairs"]) kinds.push_back(step["kind"]);
  EXPECT_THAT(kinds, testing::ElementsAre("snapped", "solid"));
}

TEST(Solids, FixDoesNotOpenAnOutline) {
  const Workplace place;
  // The edge repeats a side of the box.
  const std::string both = scene(kClosed);
  const std::string with_edge = std::string(both).replace(
      both.find("\"edges\": ["), 10, R"("edges": [{"name": "lid", "points": [[2, 1], [1, 1]], "material": "white"}, )");
  place.write("s.json", with_edge);
  const Outcome outcome = place.run("hottel check s.json --fix t.json --within 0.001");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("not-repaired: 'box[2]' repeats 'lid', but its outline would be open without it"));
  EXPECT_THAT(place.read("t.json"), HasSubstr(R"("points": [[1, 0], [2, 0], [2, 1], [1, 1]], "closed": true)"));
}

TEST(Solids, APointInASolidSeesNothing) {
  const Workplace place;
  place.write("s.json", scene(kClosed));
  const Outcome text = place.run("hottel visibility s.json --at 1.5,0.5");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, AllOf(StartsWith("from (1.5, 0.5), in the solid 'box': nothing is seen there\n"),
                              HasSubstr("mean irradiance NaN")));
  const Json answer = Json::parse(place.run("hottel visibility s.json --at 1.5,0.5 --json").out);
  EXPECT_EQ(answer["solid"], "box");
  EXPECT_TRUE(answer["area"].is_null());
  EXPECT_TRUE(answer["mean_irradiance"].is_null());
  EXPECT_TRUE(answer["polygon"].empty());
  EXPECT_TRUE(answer["parts"].empty());
  EXPECT_EQ(place.run("hottel visibility s.json --at 1.5,0.5 -o p.svg").code, 0);
  EXPECT_THAT(place.read("p.svg"), HasSubstr("<svg"));
}

TEST(Solids, APointOnTheBorderSeesTheFreeSideOnly) {
  const Workplace place;
  place.write("s.json", scene(kClosed));
  for (const auto& [at, area, solid] : {std::tuple{"1.5,1", "29/4", 0.5}, std::tuple{"2,1", "37/4", 0.25}}) {
    const Json answer = Json::parse(place.run(std::string("hottel visibility s.json --json --at ") + at).out);
    EXPECT_EQ(answer["area"]["exact"], area);
    ASSERT_EQ(answer["solids"].size(), 1u);
    EXPECT_EQ(answer["solids"][0]["solid"], "box");
    EXPECT_EQ(answer["solids"][0]["angle_fraction"]["value"], solid);
    double sum = solid;
    for (const Json& face : answer["faces"]) {
      EXPECT_NE(face["face"], "");
      sum += face["angle_fraction"]["value"].get<double>();
    }
    EXPECT_NEAR(sum, 1, 1e-15);
  }
}

TEST(Solids, ACoveredPlaceOfAFaceIsRefusedByName) {
  const Workplace place;
  place.write("s.json", scene(kClosed));
  const Outcome covered = place.run("hottel visibility s.json --on room[3] --at 5/8");
  EXPECT_EQ(covered.code, 1);
  EXPECT_EQ(covered.out, "");
  EXPECT_THAT(covered.err, HasSubstr("s.json:4: the front of 'room[3]' looks into the solid 'box' at t = 5/8"));
  EXPECT_EQ(place.run("hottel visibility s.json --on room[3] --at 1/4").code, 0);
  EXPECT_EQ(place.run("hottel visibility s.json --on room[3] --at 1/2").code, 1);  // just after it, as ever
  EXPECT_EQ(place.run("hottel visibility s.json --on room[3] --at 3/4").code, 0);
  place.write("w.json", scene(R"("points": [[0,0],[4,0],[4,1],[0,1]], "closed": true)"));
  const Outcome pair = place.run("hottel visibility w.json --from room[3] --to room[1]");
  EXPECT_EQ(pair.code, 1);
  EXPECT_THAT(pair.err, HasSubstr("the front of 'room[3]' looks into the solid 'box' all along: it has no area"));
}

}  // namespace
}  // namespace hottel::solids_test
