// What a point sees, as `hottel visibility` prints it: of analytic scenes, and beyond the range of doubles.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "kernel/rational.h"
#include "tests/cli/program.h"

namespace hottel::point_rows_test {
namespace {

using testing_cli::Outcome;
using testing_cli::Workplace;
namespace fs = std::filesystem;

TEST(PointRows, ArePrintedCorrectlyRounded) {
  const Workplace place;
  std::size_t rows = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(HOTTEL_SOURCE_DIR) / "scenes/analytic")) {
    if (entry.path().extension() != ".json") continue;
    const auto scene = nlohmann::json::parse(testing_cli::contents(entry.path()));
    for (const auto& row : scene.at("expect")) {
      if (row.at("kind") != "point") continue;
      const std::string from = row.at("of").at(0), to = row.at("of").at(1), at = row.at("at"), value = row.at("value");
      const Outcome outcome =
          place.run("hottel visibility '" + entry.path().string() + "' --on " + from + " --at " + at + " --json");
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      double printed = 0;
      const auto answer = nlohmann::json::parse(outcome.out);
      for (const auto& factor : answer.at("factors"))
        if (factor.at("to") == to) printed = factor.at("factor").at("value");
      EXPECT_EQ(printed, to_double(parse_rational(value).value())) << entry.path();
      ++rows;
    }
  }
  EXPECT_GE(rows, 3u);
}

TEST(Visibility, OfNumbersBeyondTheRangeOfDoublesIsToldInShortAndInFullInJson) {
  const Workplace place;
  place.write("room.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": "1e400"}},
 "polylines": [{"name": "p", "points": [[0, 0], [0, "1e200"], ["1e200", "1e200"], ["1e200", 0]], "closed": true,
                "material": "m"}]})");
  const Outcome outcome = place.run("hottel visibility room.json --at 1,1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("area ≈ 1e+400\n"), std::string::npos) << outcome.out;
  const std::string exact = "\"1" + std::string(400, '0') + "\"";
  const std::string json = place.run("hottel visibility room.json --at 1,1 --json").out;
  EXPECT_NE(json.find(exact), std::string::npos) << json;
  EXPECT_NE(outcome.out.find("no mean irradiance: "), std::string::npos) << outcome.out;
}

TEST(Visibility, IsToldOnStandardOutputOnlyWhereNoFileIsAskedFor) {
  const Workplace place;
  const std::string line = "hottel visibility " + std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/triangle_345.json";
  const Outcome told = place.run(line + " --at 1,1"), drawn = place.run(line + " --at 1,1 -o seen.svg"),
                quiet = place.run(line + " --at 1,1 -o seen.svg --quiet");
  EXPECT_EQ(told.err, "");
  EXPECT_EQ(drawn.out, "");
  EXPECT_NE(drawn.err.find("fraction of the full turn"), std::string::npos);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const Outcome dash = place.run(line + " --at 1,1 -o -"), json = place.run(line + " --at 1,1 --json -o -");
  EXPECT_EQ(dash.code, 0);
  EXPECT_EQ(dash.out, told.out);
  EXPECT_EQ(json.out, place.run(line + " --at 1,1 --json").out);
  EXPECT_EQ(place.files(), std::vector<std::string>{"seen.svg"});
}

}  // namespace
}  // namespace hottel::point_rows_test
