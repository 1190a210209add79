// Every byte changed, every length cut: a file is read, or refused by name; nothing else happens.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "io/scene/mtl_reader.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "io/scene/space/mesh_writer.h"
#include "io/scene/space/obj_reader.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"

namespace hottel::damaged_files_test {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(HOTTEL_SOURCE_DIR) + "/" + file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

using Reader = std::function<void(const std::string& text, const std::string& name)>;

struct Counts {
  int read = 0, refused = 0;
};

void read_damaged(const Reader& reader, const std::string& text, Counts& counts) {
  try {
    reader(text, "damaged");
    ++counts.read;
  } catch (const InputError& error) {
    ++counts.refused;
    ASSERT_TRUE(std::string(error.what()).starts_with("damaged")) << error.what();
    ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

Counts damage(const Reader& reader, const std::string& text) {
  Counts counts;
  for (std::size_t length = 0; length < text.size(); ++length) read_damaged(reader, text.substr(0, length), counts);
  std::string changed = text;
  for (std::size_t k = 0; k < text.size(); ++k) {
    for (const char byte :
         {static_cast<char>(text[k] ^ 1), static_cast<char>(text[k] ^ 0x80), '\0', '"', '{', '9', '-'}) {
      changed[k] = byte;
      read_damaged(reader, changed, counts);
      if (testing::Test::HasFatalFailure()) return counts;
    }
    changed[k] = text[k];
  }
  return counts;
}

TEST(DamagedFiles, AScene) {
  const std::string text = text_of("tests/contract/scene.json");
  const Counts counts = damage([](const std::string& t, const std::string& name) { parse_scene_2(t, name); }, text);
  EXPECT_GT(counts.read, 0);  // a digit that is another one
  EXPECT_GT(counts.refused, static_cast<int>(text.size()));
}

TEST(DamagedFiles, ADrawing) {
  const std::string text = text_of("scenes/drawings/two_rooms.svg");
  const Counts counts = damage([](const std::string& t, const std::string& name) { parse_svg_2(t, name); }, text);
  EXPECT_GT(counts.read, 0);
  EXPECT_GT(counts.refused, static_cast<int>(text.size()));
}

TEST(DamagedFiles, ASceneInSpace) {
  const std::string text = text_of("scenes/space/cube.json");
  const Counts counts = damage([](const std::string& t, const std::string& name) { parse_scene_3(t, name); }, text);
  EXPECT_GT(counts.read, 0);
  EXPECT_GT(counts.refused, static_cast<int>(text.size()));
}

TEST(DamagedFiles, AMesh) {
  // The file that it names may be called anything.
  const std::string library = text_of("scenes/space/room_boxes.mtl");
  const TextSource files = [&](const std::filesystem::path&) { return library; };
  const std::string text = text_of("scenes/space/room_boxes.obj");
  const auto read = [&](const std::string& t, const std::string& name) { scene_of(parse_obj_3(t, name, files)); };
  const Counts counts = damage(read, text);
  EXPECT_GT(counts.read, 0);
  EXPECT_GT(counts.refused, static_cast<int>(text.size()));
}

// Two triangles of a cube, as each format has them.
Scene3 small_scene() {
  return scene_of(parse_obj_3("v 0 0 0\nv 1 0 0\nv 1 .5 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n", "a.obj")).scene;
}

Counts damage_mesh(MeshFormat3 format, const std::string& bytes) {
  return damage([=](const std::string& t, const std::string& name) { scene_of(parse_mesh_3(format, t, name)); }, bytes);
}

TEST(DamagedFiles, AMeshInEveryOtherFormat) {
  for (const MeshFormat3 format : {MeshFormat3::kPly, MeshFormat3::kOff, MeshFormat3::kStl}) {
    const std::string bytes = write_mesh_3(small_scene(), format, "").bytes;
    const Counts counts = damage_mesh(format, bytes);
    EXPECT_GT(counts.read, 0);
    EXPECT_GT(counts.refused, static_cast<int>(bytes.size()));
  }
}

TEST(DamagedFiles, ABinaryPlyAndATextStl) {
  const Counts ply = damage_mesh(
      MeshFormat3::kPly,
      std::string("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty "
                  "char z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n") +
          std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13));
  EXPECT_GT(ply.read, 0);
  EXPECT_GT(ply.refused, 100);
  const Counts stl = damage_mesh(MeshFormat3::kStl,
                                 "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e1 0\n"
                                 "endloop\nendfacet\nendsolid a\n");
  EXPECT_GT(stl.read, 0);
  EXPECT_GT(stl.refused, 100);
}

TEST(DamagedFiles, ADeck) {
  const std::string text = text_of("tests/contract/deck.vs3");
  const Counts counts = damage([](const std::string& t, const std::string& name) { parse_vs3_3(t, name); }, text);
  EXPECT_GT(counts.read, 0);
  EXPECT_GT(counts.refused, static_cast<int>(text.size()));
}

TEST(DamagedFiles, MaterialsOfAMesh) {
  const std::string mesh = text_of("scenes/space/room_boxes.obj");
  const auto read = [&](const std::string& t, const std::string& name) {
    parse_mtl(t, name);
    scene_of(parse_obj_3(mesh, name, [&](const std::filesystem::path&) { return t; }));
  };
  const Counts counts = damage(read, text_of("scenes/space/room_boxes.mtl"));
  EXPECT_GT(counts.read, 0);
  EXPECT_GT(counts.refused, 0);
}

}  // namespace
}  // namespace hottel::damaged_files_test
