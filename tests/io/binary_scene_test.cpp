// Scenes as bytes: all scenes there are, there and back.
#include "io/scene/binary_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "tests/temporary_folder.h"

namespace hottel::binary_scene_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytes_of(const Scene& scene) {
  return std::visit([](const auto& any) { return binary_scene(any); }, scene);
}
std::string text_of(const Scene& scene) {
  const auto* plane = std::get_if<Scene2>(&scene);
  return plane ? write_scene_2(*plane) : write_scene_3(std::get<Scene3>(scene));
}

std::vector<fs::path> all_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(std::string(HOTTEL_SOURCE_DIR) + "/scenes"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  return files;
}

TEST(BinaryScene, IsTheSameSceneForAllThereAre) {
  std::size_t count = 0;
  for (const fs::path& file : all_scenes()) {
    Scene scene;
    try {
      scene = changeable(read_scene(file));
    } catch (const InputError&) {
      continue;  // one that is to be refused
    }
    ++count;
    const std::string bytes = bytes_of(scene);
    const Scene again = changeable(parse_binary_scene(bytes, "s.hs"));
    EXPECT_EQ(bytes_of(again), bytes) << file;
    EXPECT_EQ(text_of(again), text_of(scene)) << file;
    const auto table = [](const Scene& s) -> const SceneTable& {
      return std::visit([](const auto& any) -> const SceneTable& { return any; }, s);
    };
    EXPECT_EQ(table(again).file, table(scene).file);
    EXPECT_EQ(table(again).surfaces, table(scene).surfaces) << file;
  }
  EXPECT_GT(count, 50u);
}

constexpr const char* kNumbers = R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": "1/3"}},
  "edges": [{"name": "a", "points": [[0, "-1e-400"], ["12345678901234567890123/7", 3.25]], "material": "m"}]})";

TEST(BinaryScene, KeepsNumbersOfAnyLength) {
  const Scene2 scene = parse_scene_2(kNumbers, "n.json");
  const Scene2 again = std::get<ValidScene2>(parse_binary_scene(binary_scene(scene), "n.hs"));
  EXPECT_EQ(again.edges, scene.edges);
  EXPECT_EQ(again.materials, scene.materials);
}

std::string why(const std::string& bytes) {
  try {
    parse_binary_scene(bytes, "s.hs");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BinaryScene, KeepsAListOfGridsWithNames) {
  Scene2 scene = parse_scene_2(kNumbers, "n.json");
  scene.grids = {{{0, 0}, {4, 3}, 40, 30, "floor"}, {{1, 1}, {2, Rational(4, 3)}, 3, 1, "desk 1"}};
  EXPECT_EQ(std::get<ValidScene2>(parse_binary_scene(binary_scene(scene), "n.hs"))->grids, scene.grids);
  scene.grids[1].name = "floor";
  EXPECT_THAT(why(binary_scene(scene)), HasSubstr("two are called 'floor'"));
}

TEST(BinaryScene, IsReadByItsFirstBytesWhateverItIsCalled) {
  const TemporaryFolder folder;
  const Scene2 scene = parse_scene_2(kNumbers, "n.json");
  for (const char* name : {"n.hs", "n.json"}) {
    write_output_file(folder / name, binary_scene(scene));
    EXPECT_EQ(read_scene_2(folder / name)->edges, scene.edges);
    EXPECT_THROW(read_scene_3(folder / name), InputError);
  }
  EXPECT_TRUE(std::holds_alternative<ValidScene2>(parse_any_scene(binary_scene(scene), "standard input")));
}

TEST(BinaryScene, OfAnotherLayoutOrDamagedAnywhereIsRefused) {
  const std::string bytes = binary_scene(parse_scene_2(kNumbers, "n.json"));
  EXPECT_EQ(why(bytes), "");
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::string broken = bytes;
    broken[k] = static_cast<char>(broken[k] ^ 0x10);
    EXPECT_THAT(why(broken), testing::StartsWith("s.hs: is ")) << k;
    EXPECT_NE(why(bytes.substr(0, k)), "") << k;
  }
  std::string other = bytes;
  for (const int before : {1, 2}) {
    other[14] = static_cast<char>(before);
    EXPECT_THAT(why(other), HasSubstr("of the layout " + std::to_string(before) + ", and this hottel reads 3"));
  }
  EXPECT_NE(why(bytes + "x"), "");
}

}  // namespace
}  // namespace hottel::binary_scene_test
