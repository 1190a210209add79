// What commands tell of files that were not made for them, and of what they leave or overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::notes_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::json;

std::string plates(const std::string& more, const std::string& emission) {
  return "{\"hottel\": 1, \"dimension\": 2, " + more +
         "\n \"materials\": {\"w\": {\"reflectivity\": 0.5}, \"l\": {\"emission\": " + emission +
         "}},\n \"edges\": [\n"
         "  {\"name\": \"b\", \"points\": [[0,0],[0,4]], \"material\": \"w\"},\n"
         "  {\"name\": \"a\", \"points\": [[4,4],[4,0]], \"material\": \"l\"}]}\n";
}

TEST(Notes, TellHowManyRepeatedPointsAndEmptyGeometriesArePassedOver) {
  const Workplace place;
  place.write("map.wkt", "SRID=4326;POLYGON((0 0,4 0,4 0,4 3,0 3,0 0),EMPTY)");
  place.write("room.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 3 4\n");
  place.write("plan.svg", "<svg xmlns='http://www.w3.org/2000/svg'><polygon points='0 0 4 0 4 0 4 3'/></svg>");
  for (const char* line : {"hottel convert map.wkt out.json", "hottel check map.wkt", "hottel solve map.wkt -o out",
                           "hottel visibility map.wkt --at 1,1", "hottel visibility map.wkt --events"}) {
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 0) << line;
    EXPECT_THAT(outcome.err,
                HasSubstr("1 repeated point passed over at map.wkt:1\n1 empty geometry passed over at map.wkt:1\n"))
        << line;
  }
  for (const char* line :
       {"hottel convert room.obj room.json", "hottel check room.obj", "hottel convert plan.svg plan.json"})
    EXPECT_THAT(place.run(line).err, HasSubstr("1 repeated point passed over: of ")) << line;
  EXPECT_THAT(place.run("hottel check room.json").err, Not(HasSubstr("passed over")));
}

TEST(Notes, PlacesMayHaveBlanksAfterCommas) {
  const Workplace place;
  place.write("map.wkt", "POLYGON((0 0,4 0,4 3,0 3,0 0))");
  const Outcome plain = place.run("hottel visibility map.wkt --at 1,2"),
                spaced = place.run("hottel visibility map.wkt --at '1, 2'");
  EXPECT_EQ(spaced.code, 0) << spaced.err;
  EXPECT_EQ(spaced.out, plain.out);
}

TEST(Notes, AnAreaIsADecimalWhereItsFractionIsLong) {
  const Workplace place;
  place.write("map.wkt", "POLYGON((0 0,4 0,4 3,0 3,0 0),(1 1,2.1 1,2.3 2.7,1 2,1 1))");
  const std::string line = "hottel visibility map.wkt --at 0.123456789012345678901,0.3456789012345678901";
  const Outcome text = place.run(line);
  EXPECT_THAT(text.out, HasSubstr("\narea ≈ "));
  for (const std::string& each : testing_cli::lines_of(text.out)) EXPECT_LT(each.size(), 300u);
  const std::string exact = Json::parse(place.run(line + " --json").out)["area"]["exact"];
  EXPECT_GT(exact.size(), 40u);
  EXPECT_THAT(place.run("hottel visibility map.wkt --at 1/3,1/7").out, HasSubstr(" = (1/3, 1/7)"));
}

TEST(Notes, HelpAndErrorsOfPlotsHaveNamesOnly) {
  const Workplace place;
  const std::string help = place.run("hottel compare --help").out;
  for (const char c : help) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= ' ') << static_cast<int>(c);
  EXPECT_THAT(help, HasSubstr("{elements,parameter,time}"));
  place.write("s.json", plates("", "1"));
  const Outcome wrong = place.run("hottel compare s.json --plot-x size");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("size not in {elements,parameter,time}"));
}

TEST(Notes, EveryCommandThatComputesFactorsStopsAtABrokenPromise) {
  const Workplace place;
  place.write("s.json", plates("\"closed\": true,", "1"));
  const std::string told = "s.json:4: the scene promises to be closed, but the front of 'b' sees the sky";
  const auto before = place.files();
  for (const char* line :
       {"factors s.json", "factors s.json --method gauss:2", "factors s.json -o x.npy", "factors s.json --per group",
        "factors s.json --exact-form", "factors s.json --script-f", "solve s.json", "solve s.json --method gauss:2",
        "compare s.json --methods center -o out", "compare s.json --divide 1,2 -o out", "reference set s.json",
        "animate s.json --frames 1 --fps 1 -o film"}) {
    const Outcome outcome = place.run("hottel " + std::string(line));
    EXPECT_EQ(outcome.code, 1) << line;
    EXPECT_THAT(outcome.err, HasSubstr(told)) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_EQ(place.files(), before) << line;
  }
  EXPECT_EQ(place.run("hottel check s.json").code, 1);
  for (const char* line :
       {"plan s.json", "visibility s.json --from a --to b", "visibility s.json --at 0,1/2", "convert s.json t.json"})
    EXPECT_EQ(place.run("hottel " + std::string(line)).code, 0) << line;
}

TEST(Notes, LightBeyondDoublesIsToldWithTheLineOfItsFace) {
  const Workplace place;
  place.write("s.json", plates("", "1e309"));
  const Outcome outcome = place.run("hottel solve s.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("s.json:4: the light of 'b' is beyond the range of doubles"));
}

TEST(Notes, RepairingAFileInItsPlaceIsTold) {
  const Workplace place;
  const std::string fine = plates("", "1");
  place.write("s.json", fine);
  const Outcome nothing = place.run("hottel check s.json --fix ./s.json");
  EXPECT_THAT(nothing.err, HasSubstr("s.json is left as it is: nothing is repaired"));
  EXPECT_EQ(place.read("s.json"), fine);
  EXPECT_THAT(place.run("hottel check s.json --fix t.json").err, Not(HasSubstr("s.json is")));
  std::string ajar = fine;
  ajar.replace(ajar.find("[4,4],[4,0]"), 11, "[0.0000001,4],[4,0]");
  place.write("s.json", ajar);
  const Outcome repaired = place.run("hottel check s.json --fix s.json --within 0.001");
  EXPECT_THAT(repaired.err, HasSubstr("s.json is overwritten by the repaired scene"));
  EXPECT_NE(place.read("s.json"), ajar);
}

TEST(Notes, FramesOfALongerRunAreNamed) {
  const Workplace place;
  place.write("s.json", plates("", "1"));
  EXPECT_THAT(place.run("hottel animate s.json --frames 5 --no-film -o film").err, Not(HasSubstr("earlier run")));
  EXPECT_THAT(place.run("hottel animate s.json --frames 3 --fps 3 --no-film -o film").err,
              HasSubstr("film holds 2 frames of an earlier run beyond these, frame_00003.png to frame_00004.png"));
  EXPECT_THAT(place.run("hottel animate s.json --frames 4 --fps 3 --no-film -o film").err,
              HasSubstr("film holds 1 frame of an earlier run beyond these, frame_00004.png: it is not"));
}

}  // namespace
}  // namespace hottel::notes_test
