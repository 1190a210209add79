// Binary scenes, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::testing_cli::binary_scene_test {
namespace {

using testing::HasSubstr;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

// What a command says and writes of a scene and of the same one in bytes, where the name stands as SCENE.
void expect_alike(const std::string& scene, const std::string& command) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel convert '" + kScenes + scene + "' s.hs --quiet").code, 0);
  const auto told = [&](const std::string& file) {
    std::string line = command;
    line.replace(line.find("SCENE"), 5, file);
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(told("'" + kScenes + scene + "'"), told("s.hs")) << command;
  EXPECT_EQ(told("- < '" + kScenes + scene + "'"), told("- < s.hs")) << command;
}

TEST(BinaryScene, IsReadByEveryCommandAsItsTextIs) {
  expect_alike("showcase/apartment.json", "hottel factors SCENE --quiet");
  expect_alike("showcase/apartment.json", "hottel visibility SCENE --at 3,1 --quiet");
  expect_alike("showcase/apartment.json", "hottel check SCENE --json | grep -v -e standard -e seconds");
  expect_alike("space/two_boxes.json", "hottel factors SCENE --tolerance 1e-4 --quiet");
  expect_alike("space/two_boxes.json", "hottel plan SCENE --json --quiet | grep -v -e hottel -e '\"scene\"'");
  expect_alike("space/two_boxes.json", "hottel convert SCENE - --quiet");
}

TEST(BinaryScene, IsMadeOfWhateverConvertReadsAndBecomesThatAgain) {
  const Workplace place;
  const std::string hall = "'" + kScenes + "drawings/hall.wkt' ", mesh = "'" + kScenes + "space/room_boxes.obj' ";
  ASSERT_EQ(place
                .run("hottel convert " + hall + "h.hs && hottel convert " + hall +
                     "h.json && hottel convert h.hs hh.json && "
                     "hottel convert " +
                     mesh + "m.hs && hottel convert m.hs m.ply && hottel convert " + mesh + "n.ply")
                .code,
            0);
  EXPECT_EQ(place.read("h.json"), place.read("hh.json"));
  EXPECT_EQ(place.read("m.ply"), place.read("n.ply"));
}

TEST(BinaryScene, ThatIsDamagedIsRefused) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel convert '" + kScenes + "analytic/triangle_345.json' s.hs").code, 0);
  const Outcome cut = place.run("head -c 90 s.hs > c.hs; hottel factors c.hs");
  EXPECT_EQ(cut.code, 3);
  EXPECT_EQ(cut.err, "c.hs: is a binary scene that breaks off or is damaged: its bytes have another sum\n");
  const Outcome other =
      place.run("printf '\\x93hottel scene\\n\\7\\0\\0\\0' > o.hs; tail -c +19 s.hs >> o.hs; hottel solve o.hs");
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("o.hs: is a binary scene of the layout 7, and this hottel reads 3"));
}

}  // namespace
}  // namespace hottel::testing_cli::binary_scene_test
