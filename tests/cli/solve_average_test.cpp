#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel::solve_average_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing_cli::Outcome;
using testing_cli::Workplace;

const char* const kRoom = R"({"hottel": 1, "dimension": 2,
  "materials": {"white": {"reflectivity": "1/2"}, "lamp": {"emission": 8}},
  "edges": [{"name": "lamp", "points": [[0, 0], [0, 1]], "material": "lamp"}],
  "polylines": [{"name": "walls", "points": [[0, 1], [1, 1], [1, 0], [0, 0]], "material": "white"}]})";

TEST(SolveAverage, ReportsTheBoundOfTheAveragesAndOfNothingElse) {
  const Workplace place;
  place.write("room.json", kRoom);
  for (const std::string way : {"point", "average", "inverse-square"}) {
    const Outcome outcome = place.run("hottel solve room.json --grid 4x4 --illumination " + way + " -o " + way);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto bounds = nlohmann::json::parse(place.read(way + "/report.json")).at("bounds");
    EXPECT_EQ(bounds.contains("illumination_max_error"), way == "average");
    if (way != "average") {
      EXPECT_THAT(outcome.err, Not(HasSubstr("averages over cells")));
      continue;
    }
    EXPECT_GT(bounds["illumination_max_error"].get<double>(), 0);
    EXPECT_LT(bounds["illumination_max_error"].get<double>(), 1e-10);
    EXPECT_THAT(outcome.err, HasSubstr("averages over cells"));
    EXPECT_THAT(place.read("average/illumination.npy"), HasSubstr("'shape': (4, 4, 1), "));
    EXPECT_THAT(place.read("average/illumination.png"), StartsWith("\x89PNG"));
  }
  EXPECT_NE(place.read("average/illumination.npy"), place.read("point/illumination.npy"));
}

}  // namespace
}  // namespace hottel::solve_average_test
