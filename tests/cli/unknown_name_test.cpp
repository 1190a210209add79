// Names that there are not: refused in one line, with near names as one hint.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::unknown_name_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

constexpr const char* kRooms = R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.5}},
  "edges": [{"name": "wall", "points": [[2, 0], [0, 0]], "material": "white"},
            {"name": "window1", "points": [[0, 1], [2, 1]], "material": "white", "back": "white"},
            {"name": "window2", "points": [[0, 2], [2, 2]], "material": "white"}],
  "polylines": [{"name": "room", "points": [[5, 0], [5, 1], [6, 1]], "closed": true, "material": "white"}]})";

struct Lookup {
  const char *name, *line, *message, *hint;
};

void PrintTo(const Lookup& lookup, std::ostream* out) { *out << lookup.line; }

const Lookup kLookups[] = {
    {"toward", "factors rooms.json --picture p.png --toward wal", "no surface of rooms.json is called 'wal'",
     "did you mean 'wall'?"},
    {"toward_a_beginning", "factors rooms.json --picture p.png --toward 'windo*'", "", ""},
    {"toward_no_beginning", "factors rooms.json --picture p.png --toward 'widnow*'", "fits 'widnow*'",
     "did you mean 'window*'?"},
    {"toward_the_sky", "factors rooms.json --picture p.png --toward skye", "is called 'skye'", "did you mean 'sky'?"},
    {"from", "visibility rooms.json --from window3 --to wall", "no face of rooms.json is called 'window3'",
     "did you mean 'window1', 'window2'?"},
    {"to", "visibility rooms.json --from wall --to wal", "no face of rooms.json is called 'wal'",
     "did you mean 'wall', 'wall:back'?"},
    {"on_a_polyline", "visibility rooms.json --on room --at 1/2", "no face of rooms.json is called 'room'",
     "did you mean 'room[0]', 'room[1]', 'room[2]'?"},
    {"on_the_sky", "visibility rooms.json --on sky --at 1/2", "--on is a face, which the sky is not", nullptr},
    {"exact_form", "factors rooms.json --exact-form Wall window1:bakc", "there is no face called 'Wall'",
     "did you mean 'wall', 'wall:back'?"},
    {"method", "factors rooms.json --method gaus:4", "there is no method called 'gaus:4'", "did you mean 'gauss'?"},
    {"method_of_solve", "solve rooms.json --method hemicub:8", "there is no method called", "did you mean 'hemicube'?"},
    {"methods", "compare rooms.json --methods exact,stings", "there is no method called", "did you mean 'strings'?"},
    {"map", "compare rooms.json --methods gauss:4 --map gauss:2", "--map takes one of", "did you mean 'gauss:4'?"},
    {"solver", "solve rooms.json --solver jacoby", "there is no solver called 'jacoby'", "did you mean 'jacobi'?"},
    {"tone", "solve rooms.json --tone lineal", "there is no tone curve called 'lineal'", "did you mean 'linear'?"},
    {"kind", "generate clutterr", "there is no kind of scene called 'clutterr'", "did you mean 'clutter'?"},
    {"command", "factor rooms.json", "there is no command 'factor'", "did you mean 'factors'?"},
    {"option", "factors rooms.json --pictur p.png", "factors has no option '--pictur'", "did you mean '--picture'?"},
    {"output", "factors rooms.json --output f.csv", "factors has no option '--output'", "-o says where to write"},
    {"output_as_an_argument", "convert rooms.json -o new.json", "convert has no option '-o'",
     "where to write is an argument: hottel convert IN OUT"},
    {"output_of_none", "plan rooms.json -o plan.json", "plan has no option '-o'", nullptr},
    {"nothing_near", "visibility rooms.json --from fluorescent --to wall", "is called 'fluorescent'",
     "its surfaces are 'wall', 'window1', 'window2' and 3 more"},
    {"no_pattern_near", "factors rooms.json --rows 'fluo*t'", "no surface of rooms.json fits 'fluo*t'",
     "its surfaces are 'wall', 'window1', 'window2' and 3 more"},
};

class UnknownNames : public testing::TestWithParam<Lookup> {};

TEST_P(UnknownNames, AreRefusedWithNearOnes) {
  const Lookup& lookup = GetParam();
  const Workplace place;
  place.write("rooms.json", kRooms);
  const Outcome outcome = place.run("hottel " + std::string(lookup.line));
  if (lookup.message[0] == '\0') {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return;
  }
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(place.files(), std::vector<std::string>{"rooms.json"});
  const auto lines = lines_of(outcome.err);
  EXPECT_THAT(lines.at(0), HasSubstr(lookup.message));
  if (lookup.hint != nullptr)
    EXPECT_EQ(lines.at(1), "  " + std::string(lookup.hint));
  else
    EXPECT_THAT(lines, Not(Contains(HasSubstr("did you mean"))));
}

INSTANTIATE_TEST_SUITE_P(, UnknownNames, testing::ValuesIn(kLookups),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(UnknownNamesInFiles, AreRefusedWithNearOnes) {
  const Workplace place;
  std::string scene = kRooms;
  scene.replace(scene.find("\"material\": \"white\""), 19, "\"material\": \"whtie\"");
  place.write("bad.json", scene);
  place.write("rooms.json", kRooms);
  const Outcome material = place.run("hottel plan bad.json");
  EXPECT_EQ(material.code, 3);
  EXPECT_EQ(
      material.err,
      "bad.json:2: edge 'wall': material 'whtie' is not defined\n  did you mean 'white'?\n  defined are: 'white'\n");
  place.write("factors.csv", "from,to,factor\nwal,window1,0.1\n");
  const Outcome factors = place.run("hottel factors rooms.json --method file:factors.csv");
  EXPECT_EQ(factors.code, 3) << factors.err;
  EXPECT_THAT(factors.err, HasSubstr("  did you mean 'wall'?\n"));
  place.write("radiosity.csv", "face,radiosity\nwindow11,0.1\n");
  const Outcome radiosity = place.run("hottel compare rooms.json --methods file:radiosity.csv");
  EXPECT_EQ(radiosity.code, 3) << radiosity.err;
  EXPECT_THAT(radiosity.err, HasSubstr("  did you mean 'window1', 'window2'?\n"));
}

}  // namespace
}  // namespace hottel::unknown_name_test
