// Lists of factors in space do not depend on where pairs are until their rows are written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::rows_in_space_test {
namespace {

using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/";

// By rows, by way of the disk, and in a matrix, as for a store.
TEST(RowsInSpace, AreTheSameBytesHoweverTheyAreWritten) {
  for (const char* command :
       {"attic.json", "cube.json --per element --elements 3", "city_block.json", "cornell_box.json --rows fronts",
        "duct.json --guarantee enclosed", "partition.vs3", "pierced_triangles.json", "room_boxes.obj --per group",
        "two_boxes.json --per element --elements 2 --areas", "city_block.json --sky closure --digits 5"}) {
    const Workplace place;
    const std::string factors = "hottel factors " + kScenes + command + " --quiet -o ";
    ASSERT_EQ(place.run(factors + "rows.csv").code, 0) << command;
    ASSERT_EQ(place.run(factors + "disk.csv --out-of-core d").code, 0) << command;
    ASSERT_EQ(place.run(factors + "matrix.csv --store s").code, 0) << command;
    EXPECT_FALSE(place.read("rows.csv").empty());
    EXPECT_EQ(place.read("rows.csv"), place.read("disk.csv")) << command;
    EXPECT_EQ(place.read("rows.csv"), place.read("matrix.csv")) << command;
    EXPECT_FALSE(testing_cli::fs::exists(place.path("d"))) << "it was made for this run";
  }
}

TEST(RowsInSpace, TellHowMuchWasOnDisk) {
  const Workplace place;
  const Outcome outcome = place.run("hottel factors " + kScenes + "cube.json -o f.csv --out-of-core d");
  EXPECT_THAT(outcome.err, testing::HasSubstr("kB of sums were in d\n"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"f.csv"});
}

// A promise is kept by rows as by a matrix.
TEST(RowsInSpace, AreRefusedWhereASceneIsNotClosedAsItPromises) {
  const Workplace place;
  place.write("open.json", R"({"hottel": 1, "dimension": 3, "closed": true, "materials": {"m": {"reflectivity": 0.5}},
    "polygons": [{"name": "plate", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"}]})");
  for (const char* options : {"", " --out-of-core d", " --store s"}) {
    const Outcome outcome = place.run("hottel factors open.json -o f.csv" + std::string(options));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, testing::StartsWith("open.json:2: the scene promises to be closed, but the front of"));
  }
}

}  // namespace
}  // namespace hottel::rows_in_space_test
