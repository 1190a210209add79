// Scenes larger than doubles, through every command: told exactly, or refused in words; never inf.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::beyond_doubles_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::ordered_json;

// A room of 4 by 3 times 10^exponent.
std::string room(const std::string& exponent) {
  const std::string three = "\"3e" + exponent + "\"", four = "\"4e" + exponent + "\"";
  return R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1, "reflectivity": 0.5}},
 "polylines": [{"name": "room", "points": [[0, 0], [0, )" +
         three + "], [" + four + ", " + three + "], [" + four +
         R"(, 0]], "closed": true, "material": "m"}]}
)";
}

class BeyondDoubles : public testing::Test {
 protected:
  BeyondDoubles() {
    place_.write("large.json", room("400"));
    place_.write("single.json", room("39"));  // beyond single precision
    place_.write("small.json", room("-400"));
  }

  // Exits with 1, says so in one line that begins so, and writes nothing anywhere.
  void expect_refused(const std::string& line, const std::string& message) const {
    const auto before = place_.files();
    const Outcome outcome = place_.run("hottel " + line);
    EXPECT_EQ(outcome.code, 1) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_THAT(outcome.err, StartsWith(message)) << line;
    EXPECT_THAT(outcome.err, EndsWith("\n")) << line;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << line;
    EXPECT_EQ(place_.files(), before) << line;
  }

  Workplace place_;
};

TEST_F(BeyondDoubles, FactorsAreWhatTheyAreInAnyScale) {
  place_.write("plain.json", room("0"));
  for (const std::string options : {"", " --exact-form room[0] room[1]"})
    for (const std::string scene : {"large", "small"}) {
      const Outcome outcome = place_.run("hottel factors " + scene + ".json --quiet" + options);
      EXPECT_EQ(outcome.code, 0);
      EXPECT_THAT(outcome.out, Not(HasSubstr("inf")));
      if (options.empty()) {
        EXPECT_EQ(outcome.out, place_.run("hottel factors plain.json --quiet").out);
      }
    }
}

TEST_F(BeyondDoubles, WhatHoldsLengthsIsRefusedNamingTheFace) {
  expect_refused("factors large.json --matrix exchange",
                 "large.json: the direct exchange area of 'room[0]' and 'room[1]' is beyond the range of doubles; "
                 "--exact-form gives it");
  expect_refused("factors large.json --matrix exchange --method gauss:4",
                 "large.json: the direct exchange area of 'room[0]' and 'room[1]' is beyond the range of doubles");
  for (const std::string ending : {"mtx", "txt"})
    expect_refused("factors large.json -o x." + ending,
                   "large.json: the area of 'room[0]' is beyond the range of doubles");
  expect_refused("factors single.json -o x.bin",
                 "single.json: the area of 'room[0]' is beyond the range of single precision");
  EXPECT_EQ(place_.run("hottel factors single.json -o x.txt").code, 0);
}

TEST_F(BeyondDoubles, CoordinatesOfFacesFarAwayAreRefused) {
  place_.write("far.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
 {"name": "near", "points": [[0, 0], [1, 0]], "material": "m"},
 {"name": "far", "points": [["1e309", 0], ["1e309", 1]], "material": "m"}]})");
  expect_refused("factors far.json -o x.mtx", "far.json: a coordinate of 'far' is beyond the range of doubles");
}

// A box of 4 by 3 by 3 times 10^exponent.
std::string box(const std::string& exponent) {
  const std::string x = "\"4e" + exponent + "\"", y = "\"3e" + exponent + "\"", z = y;
  const auto polygon = [](const std::string& name, const std::string& points) {
    return "{\"name\": \"" + name + "\", \"points\": [" + points + "], \"material\": \"m\"}";
  };
  const auto point = [](const std::string& a, const std::string& b, const std::string& c) {
    return "[" + a + "," + b + "," + c + "]";
  };
  const auto four = [](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
    return a + "," + b + "," + c + "," + d;
  };
  const std::string o = "0";
  const std::string p[8] = {point(o, o, o), point(x, o, o), point(x, y, o), point(o, y, o),
                            point(o, o, z), point(x, o, z), point(x, y, z), point(o, y, z)};
  return R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": 1, "reflectivity": 0.5}}, "polygons": [)"
         "\n" +
         polygon("bottom", four(p[0], p[1], p[2], p[3])) + ",\n" + polygon("top", four(p[4], p[7], p[6], p[5])) +
         "]}\n";
}

TEST_F(BeyondDoubles, WhatIsNotZeroIsNeverWrittenAsZero) {
  const std::string area = "small.json: the area of 'room[0]' is below the range of doubles";
  expect_refused("factors small.json --matrix exchange",
                 "small.json: the direct exchange area of 'room[0]' and 'room[1]' is below the range of doubles; "
                 "--exact-form gives it");
  expect_refused("factors small.json --matrix exchange --method gauss:4",
                 "small.json: the direct exchange area of 'room[0]' and 'room[1]' is below the range of doubles");
  expect_refused("factors small.json -o x.csv --areas", area);
  for (const std::string ending : {"mtx", "txt"}) expect_refused("factors small.json -o x." + ending, area);
  expect_refused("factors small.json -o x.bin",
                 "small.json: the area of 'room[0]' is below the range of single precision, which is that of this");
  place_.write("single.json", room("-50"));
  expect_refused("factors single.json -o x.bin", "single.json: the area of 'room[0]' is below the range of single");
  EXPECT_EQ(place_.run("hottel factors single.json -o x.txt").code, 0);
  expect_refused("solve small.json -o out --quiet",
                 "small.json:2: the area of 'room[0]' is below the range of doubles");
  // Factors have no unit.
  for (const char* line : {"factors small.json", "factors small.json -o x.npy", "factors small.json -o x.csv",
                           "factors small.json --matrix factor", "factors small.json --script-f"})
    EXPECT_EQ(place_.run(std::string("hottel ") + line).code, 0) << line;
  EXPECT_TRUE(Json::parse(place_.read("x.npy.json"))["areas"][0].is_null());
}

TEST_F(BeyondDoubles, WhatIsNotZeroIsNeverWrittenAsZeroInSpace) {
  place_.write("tiny.json", box("-200"));
  const std::string area = "tiny.json: the area of 'bottom' is below the range of doubles";
  expect_refused("factors tiny.json --matrix exchange",
                 "tiny.json: the direct exchange area of 'bottom' and 'top' is below the range of doubles");
  expect_refused("factors tiny.json -o x.csv --areas", area);
  for (const std::string ending : {"mtx", "txt"}) expect_refused("factors tiny.json -o x." + ending, area);
  expect_refused("factors tiny.json -o x.bin",
                 "tiny.json: the area of 'bottom' is below the range of single precision");
  expect_refused("solve tiny.json -o out --quiet", "tiny.json:2: the area of 'bottom' is below the range of doubles");
  place_.write("plain.json", box("0"));
  const std::string first = place_.run("hottel factors tiny.json --quiet").out;
  EXPECT_EQ(first, place_.run("hottel factors plain.json --quiet").out);
  EXPECT_EQ(place_.run("hottel factors tiny.json -o x.npy").code, 0);
  EXPECT_TRUE(Json::parse(place_.read("x.npy.json"))["areas"][0].is_null());
}

TEST_F(BeyondDoubles, CornersNextToZeroAreRefusedUnlessExact) {
  place_.write("near.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1}}, "edges": [
 {"name": "a", "points": [["1e-330", 0], [1, 0]], "material": "m"},
 {"name": "b", "points": [[1, 1], [0, 1]], "material": "m"}]})");
  expect_refused("factors near.json -o x.mtx", "near.json: a coordinate of 'a' is below the range of doubles");
  place_.write("points.csv", "0.5,0.5\n");
  for (const std::string ending : {"csv", "geojson", "wkt", "npz"})
    expect_refused(
        "visibility near.json --points points.csv -o x." + ending,
        "near.json: a corner of what point 0 sees is below the range of doubles; --exact writes it to a csv");
  const Outcome exact = place_.run("hottel visibility near.json --points points.csv --exact -o x.csv");
  EXPECT_EQ(exact.code, 0) << exact.err;
  EXPECT_THAT(place_.read("x.csv"), HasSubstr("1/1" + std::string(330, '0')));
  EXPECT_EQ(place_.run("hottel factors near.json").code, 0);
  place_.write("near3.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": 1}}, "polygons": [
 {"name": "a", "points": [[0, 0, "1e-330"], [1, 0, "1e-330"], [1, 1, "1e-330"], [0, 1, "1e-330"]], "material": "m"}]})");
  expect_refused("factors near3.json -o x.mtx", "near3.json: a coordinate of 'a' is below the range of doubles");
  expect_refused("solve near3.json -o out --quiet",
                 "near3.json: a coordinate of a corner in radiosity.vtu is below the range of doubles");
  expect_refused("convert near3.json x.stl", "near3.json: the coordinate 1e-330 is below the least float");
}

TEST_F(BeyondDoubles, MethodsAreComparedWithoutDistancesAndWithoutLight) {
  const Outcome outcome = place_.run("hottel compare large.json --methods center,strings --repeat 1 -o out --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place_.read("out/compare.csv"), Not(HasSubstr("inf")));
  EXPECT_THAT(place_.read("out/worst.csv"), Not(HasSubstr("inf")));
  EXPECT_THAT(place_.read("out/worst.csv"), HasSubstr("center,room[1],room[3],0.6666666666666666,0.5,"));
  expect_refused("compare large.json --methods strings --map strings -o map",
                 "large.json:2: the coordinates of 'room[1]' are larger than 1e300");
}

TEST_F(BeyondDoubles, ErrorsOfNoLightAreNotDrawn) {
  std::string mirrors = room("0");
  mirrors.replace(mirrors.find("0.5"), 3, "1");
  place_.write("mirrors.json", mirrors);
  expect_refused(
      "compare mirrors.json --methods strings --map strings -o map",
      "mirrors.json: --map draws errors of the light, and there is none to compare: no radiosity: 'room[0]'");
}

TEST_F(BeyondDoubles, CheckForeseesWhatSolveRefuses) {
  const auto scene = [](const std::string& material) {
    std::string text = room("0");
    return text.replace(text.find("\"emission\""), text.find('}') - text.find("\"emission\""), material);
  };
  place_.write("bright.json", scene("\"emission\": \"1e400\""));
  place_.write("mirrors.json", scene("\"emission\": 1, \"reflectivity\": \"0." + std::string(400, '9') + "\""));
  std::string wide = room("200");
  place_.write("wide.json", wide.replace(wide.find("\"emission\": 1"), 13, "\"emission\": 1e200"));
  place_.write("plain.json", scene("\"emission\": 1e300, \"reflectivity\": 0.5"));
  for (const std::string name : {"large", "small", "bright", "mirrors", "wide"}) {
    const Outcome outcome = place_.run("hottel check " + name + ".json --json");
    EXPECT_EQ(outcome.code, 1) << name;
    const Json findings = Json::parse(outcome.out)["findings"];
    ASSERT_EQ(findings.size(), 1u) << name;
    EXPECT_EQ(findings[0]["kind"], "beyond-doubles") << name;
    EXPECT_EQ(findings[0]["severity"], "error") << name;
    EXPECT_EQ(findings[0]["line"], 2) << name;
    EXPECT_THAT(place_.run("hottel check " + name + ".json").out, Not(HasSubstr("inf"))) << name;
    expect_refused("solve " + name + ".json -o out --quiet", name + ".json:");
  }
  EXPECT_EQ(place_.run("hottel check plain.json").out, "0 errors, 0 warnings, 0 notes\n");
  EXPECT_EQ(place_.run("hottel solve plain.json --quiet -o out").code, 0);
}

// A face of a material and a warm one opposite, with more beside the lists.
std::string two_faces(const std::string& material, const std::string& more = "") {
  return R"({"hottel": 1, "dimension": 2, "materials": {"m": )" + material +
         R"(, "w": {"emissivity": 1, "temperature": 300}},
 "edges": [{"name": "a", "points": [[0, 0], [0, 1]], "material": "m"},
           {"name": "c", "points": [[1, 1], [1, 0]], "material": "w"}])" +
         more + "}\n";
}

TEST_F(BeyondDoubles, WhatIsGivenAndWouldBeWrittenAsZeroIsRefused) {
  for (const auto& [material, what] :
       {std::pair(R"({"emission": "1e-400"})", "emission"), std::pair(R"({"reflectivity": "1e-400"})", "reflectivity"),
        std::pair(R"({"emissivity": 0.5, "flux": "1e-400"})", "flux")}) {
    place_.write("given.json", two_faces(material));
    const std::string message = std::string("the ") + what + " of 'a' is below the range of doubles";
    expect_refused("solve given.json -o out --quiet", "given.json:2: " + message);
    EXPECT_THAT(place_.run("hottel check given.json").out, HasSubstr("error: beyond-doubles at (0, 0.5): " + message));
  }
  place_.write("given.json", two_faces(R"({"emissivity": 0.5, "flux": "1e-322"})"));
  EXPECT_EQ(place_.run("hottel solve given.json -o out --quiet --no-illumination").code, 0);
}

TEST_F(BeyondDoubles, ATemperatureThatIsIsRefused) {
  place_.write("hot.json", two_faces(R"({"emissivity": "1e-309", "flux": 10})"));
  const std::string message = "sigma T^4 of 'a' is beyond the range of doubles";
  expect_refused("solve hot.json -o out --quiet", "hot.json:2: " + message);
  EXPECT_THAT(place_.run("hottel check hot.json").out, HasSubstr("error: beyond-doubles at (0, 0.5): " + message));
}

TEST_F(BeyondDoubles, TheEstimateOfMuchLightIsANumber) {
  place_.write("bright.json", two_faces(R"({"emission": "1e300", "reflectivity": 0.5})"));
  const Outcome outcome = place_.run("hottel solve bright.json -o out --no-picture");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("inf")));
}

TEST_F(BeyondDoubles, AGridThatReachesThereIsRefusedAndALargeOneIsLit) {
  const auto grid = [](const std::string& end) {
    return two_faces(R"({"emission": 1})",
                     R"(, "grid": {"min": [0, 0], "max": [")" + end + R"(", 1], "cells": [4, 4]})");
  };
  place_.write("grid.json", grid("1e309"));
  const Outcome beyond = place_.run("hottel solve grid.json -o out");
  EXPECT_EQ(beyond.code, 1);
  EXPECT_THAT(beyond.err, HasSubstr("the grid reaches beyond the range of doubles\n"));
  for (const char* end : {"1e140", "1e160", "1e300", "1.7e308"}) {
    place_.write("grid.json", grid(end));
    EXPECT_EQ(place_.run("hottel solve grid.json -o out --quiet --no-picture").code, 0) << end;
  }
}

TEST_F(BeyondDoubles, ALightBesideAnEndThatIsAllButZeroLightsPoints) {
  const auto scene = [](const std::string& end) {
    return R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1}},
 "edges": [{"name": "a", "points": [[0, 0], [0, 1]], "material": "m", "back": "m"},
           {"name": "c", "points": [[0, 1], [1, )" +
           end + R"(]], "material": "m"}],
 "lights": [{"type": "point", "name": "p", "position": [0.2, 0.2], "power": 2}]})";
  };
  place_.write("zero.json", scene("0"));
  place_.write("near.json", scene("\"1e-400\""));
  const auto light = [&](const std::string& file) {
    const std::string text = place_.run("hottel visibility " + file + " --at 0.4,0.45").out;
    return std::stod(text.substr(text.rfind("all") + 3));
  };
  EXPECT_NEAR(light("near.json"), light("zero.json"), 1e-14);
}

TEST_F(BeyondDoubles, ANumberTooLongToBeWrittenIsToldByItsSize) {
  std::string text = room("0");
  place_.write("s.json", text.replace(text.find("\"emission\": 1"), 34,
                                      "\"emissivity\": \"1/3\", \"temperature\": [\"1e2000\", 1, 1]"));
  expect_refused("convert s.json out.json", "s.json: a number of ");
  EXPECT_THAT(place_.run("hottel convert s.json out.json").err, HasSubstr("e+7992, does not fit into a scene file"));
}

TEST_F(BeyondDoubles, AnExponentBeyondWhatIsReadIsNamed) {
  for (const std::string number : {"\"1e5000\"", "1e4500", "\"-2.5E-4097\""}) {
    std::string text = room("0");
    place_.write("s.json", text.replace(text.find("[0, 0]"), 6, "[0, " + number + "]"));
    const Outcome outcome = place_.run("hottel plan s.json");
    EXPECT_EQ(outcome.code, 3) << number;
    EXPECT_THAT(outcome.err,
                StartsWith("s.json:2: polyline 'room': coordinate is beyond the range in which numbers are "
                           "read: '"))
        << number;
    EXPECT_THAT(outcome.err, EndsWith("\n  an exponent is at most 4096 in absolute value\n")) << number;
  }
}

TEST_F(BeyondDoubles, VisibilityTellsDecimalsThatGoOnAndExactForms) {
  const Outcome pair = place_.run("hottel visibility large.json --from room[0] --to room[1]");
  EXPECT_EQ(pair.code, 0) << pair.err;
  EXPECT_THAT(pair.out,
              HasSubstr("S, direct exchange area      1e+400                 = 1" + std::string(400, '0') + "\n"));
  EXPECT_THAT(pair.out,
              HasSubstr("A of 'room[0]'               3e+400                 = 3" + std::string(400, '0') + "\n"));
  EXPECT_THAT(pair.out, HasSubstr("F from 'room[0]'             0.3333333333333333 "));
  const Outcome point = place_.run("hottel visibility large.json --at 1,1");
  EXPECT_EQ(point.code, 0) << point.err;
  EXPECT_THAT(point.out, HasSubstr("\narea ≈ 1.2e+801\n"));
  EXPECT_THAT(point.out, HasSubstr("\n  ≈ (4e+400, 3e+400)\n"));
  const Outcome on = place_.run("hottel visibility large.json --on room[0] --at 1/2");
  EXPECT_THAT(on.out, HasSubstr("of 'room[0]', ≈ (0, 1.5e+400)\n"));
  for (const Outcome& outcome : {pair, point, on}) EXPECT_THAT(outcome.out, Not(HasSubstr("inf")));
}

TEST_F(BeyondDoubles, VisibilityHasNullForADoubleAndTheExactForm) {
  const Outcome outcome = place_.run("hottel visibility large.json --from room[0] --to room[1] --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_TRUE(answer["exchange"]["value"].is_null());
  EXPECT_EQ(answer["exchange"]["exact"], "1" + std::string(400, '0'));
  EXPECT_EQ(answer["visibility"]["value"], 1.0);
}

TEST_F(BeyondDoubles, VisibilityIsBelowOneWhereAnythingIsHidden) {
  // A wall of length 1e-30 stands before a corner.
  place_.write("s.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
 {"name": "a", "points": [[1, 0], [0, 0]], "material": "m"}, {"name": "b", "points": [[0, 1], [1, 1]], "material": "m"},
 {"name": "speck", "points": [["1/2", 0.5], ["1/2", "0.500000000000000000000000000001"]], "material": "m"}]})");
  const Outcome outcome = place_.run("hottel visibility s.json --from b --to a --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_NE(answer["exchange"]["exact"], answer["unobstructed"]["exact"]);
  EXPECT_LT(answer["visibility"]["value"].get<double>(), 1.0);
  EXPECT_EQ(answer["visibility"]["lower"], answer["visibility"]["value"]);
  EXPECT_EQ(answer["visibility"]["upper"], 1.0);
}

TEST_F(BeyondDoubles, WhatIsSeenIsNotDrawn) {
  for (const std::string what : {"--at 1,1", "--on room[0] --at 1/2", "--from room[0] --to room[1]"})
    for (const std::string ending : {"png", "svg"}) {
      expect_refused("visibility large.json " + what + " -o x." + ending,
                     "large.json:2: the coordinates of 'room[1]' are larger than 1e300");
      expect_refused("visibility small.json " + what + " -o x." + ending,
                     "small.json:2: the coordinates of 'room[1]' are smaller than 1e-300");
    }
  expect_refused("visibility single.json --at 1e305,1 -o x.png", "single.json: the point 1e305,1 is too far away");
  place_.write("far.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
 {"name": "a", "points": [[1e20, 0], ["100000000000000000001", 0]], "material": "m"}]})");
  expect_refused("visibility far.json --at 1e20,1 -o x.png",
                 "far.json:2: the coordinates of 'a' are too large for the size of the scene");
}

}  // namespace
}  // namespace hottel::beyond_doubles_test
