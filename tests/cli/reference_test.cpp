// hottel reference, from outside: a set that can be checked without hottel, and that hottel agrees with.
#include <gmock/gmock.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel::reference_test {
namespace {

using testing::HasSubstr;
using testing_cli::contents;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
const std::string kTwo = kScenes + "analytic/square_radiosity.json " + kScenes + "analytic/strip_obstructed.json";

TEST(Reference, ChecksumsHold) {
  const Workplace place;
  const Outcome outcome = place.run("hottel reference set " + kTwo +
                                    " --quiet && cd set && sha256sum --strict -c SHA256SUMS "
                                    "> /dev/null && find . -type f | wc -l && wc -l < SHA256SUMS");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "14\n13\n");  // all but SHA256SUMS itself
  const auto manifest = nlohmann::json::parse(place.read("set/reference.json"));
  ASSERT_EQ(manifest["scenes"].size(), 2u);
  EXPECT_EQ(manifest["scenes"][0]["name"], "square_radiosity");
  EXPECT_EQ(manifest["scenes"][0]["factors"]["closure_is_exact"], true);
  EXPECT_LT(manifest["scenes"][0]["radiosities"]["max_relative_width"].get<double>(), 1e-14);
  for (const auto& file : manifest["scenes"][1]["files"]) {
    EXPECT_EQ(place.read("set/" + file["file"].get<std::string>()).size(), file["bytes"]);
    EXPECT_THAT(place.read("set/SHA256SUMS"),
                HasSubstr(file["sha256"].get<std::string>() + "  " + file["file"].get<std::string>() + "\n"));
  }
}

TEST(Reference, IsTheSameByteForByteForAnyNumberOfThreads) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel reference a " + kTwo + " --quiet --threads 1 && hottel reference b " + kTwo +
                " --quiet --threads 2 && diff -r a b && hottel reference c a/*/scene.json --quiet && "
                "diff -r a c");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(place.read("a/square_radiosity/scene.json"), contents(kScenes + "analytic/square_radiosity.json"));
}

TEST(Reference, AgreesWithCompare) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel reference set " + kTwo +
                " --quiet && cd set/strip_obstructed && hottel compare scene.json "
                "--methods file:factors.csv,file:factors.mtx --repeat 1 -o /dev/shm/$$ && rm -r /dev/shm/$$");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("pairs agree with the exact factors"));
}

TEST(Reference, ABrokenPromiseToBeClosedIsRefused) {
  const Workplace place;
  place.write("open.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1}}, "closed": true,
 "polylines": [{"name": "r", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "material": "m"}]})");
  const Outcome outcome = place.run("hottel reference set open.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("open.json:2: the scene promises to be closed, but the front of 'r[0]' sees the"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"open.json"});
}

// Factors in space with their guarantees; meshes and decks as scene files that need no other file.
TEST(Reference, HoldsScenesInSpace) {
  const Workplace place;
  const std::string space = kScenes + "space/";
  const Outcome outcome =
      place.run("hottel reference set " + space + "cube.json " + space + "room_boxes.json " + space +
                "crate.vs3 --threads 2 && cd set && sha256sum --strict -c SHA256SUMS > /dev/null && cd .. && "
                "hottel reference again set/cube/scene.json set/room_boxes/scene.json set/crate/scene.json --quiet "
                "--threads 1 && diff -r set again");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(
      outcome.err,
      HasSubstr(
          "cube: 12 elements, 30 factors, enclosed; discrete radiosities of these elements enclosed, bounds within"));
  EXPECT_EQ(place.read("set/cube/scene.json"), contents(space + "cube.json"));
  EXPECT_THAT(place.read("set/room_boxes/scene.json"), testing::Not(HasSubstr("\"mesh\"")));
  const auto manifest = nlohmann::json::parse(place.read("set/reference.json"));
  const auto& cube = manifest["scenes"][0]["factors"];
  EXPECT_EQ(cube["guarantee"], "enclosed");
  EXPECT_EQ(cube["tolerance"], 1e-12);
  EXPECT_EQ(cube["enclosed"], 30);
  EXPECT_EQ(manifest["scenes"][0]["radiosities"]["of"], "the discrete problem of these elements");
  EXPECT_THAT(place.read("set/README.md"), HasSubstr("The problem is discrete"));
  const auto& room = manifest["scenes"][1]["factors"];
  EXPECT_EQ(room["guarantee"], "estimated");
  EXPECT_EQ(room["enclosed"].get<int>() + room["estimated"].get<int>(),
            manifest["scenes"][1]["counts"]["factors"].get<int>());
  EXPECT_LT(room["max_defect"].get<double>(), 1e-11);
  const Outcome compared = place.run(
      "cd set/room_boxes && hottel compare scene.json --methods file:factors.csv --repeat 1 -o /dev/shm/$$ && rm -r "
      "/dev/shm/$$");
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.err, HasSubstr("pairs agree with the exact factors"));
}

// Their scene files hold what was asked for: they are computed from as they are.
TEST(Reference, DividedScenesSayTheirElementsAndGrids) {
  const Workplace place;
  const Outcome outcome = place.run("hottel reference set " + kScenes + "lights/hall.json " + kScenes +
                                    "analytic/square_radiosity.json --elements 2 --grid 4x3 --tolerance 1e-6 --quiet "
                                    "&& hottel reference again set/*/scene.json --tolerance 1e-6 --quiet && "
                                    "diff -r set again");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const auto scenes = nlohmann::json::parse(place.read("set/reference.json"))["scenes"];
  EXPECT_EQ(scenes[0]["light"]["shape"], (std::vector{3, 4, 3}));
  EXPECT_EQ(scenes[1]["light"]["shape"], (std::vector{3, 4, 1}));
  EXPECT_EQ(scenes[0]["units"]["areas"], "m²");
  EXPECT_EQ(scenes[1]["units"]["areas"], "m");
  EXPECT_EQ(scenes[1]["problem"]["unknowns"], 8);
  const Outcome solved = place.run("hottel solve set/hall/scene.json -o solved --tolerance 1e-6 --quiet");
  EXPECT_EQ(solved.code, 0) << solved.err;
  EXPECT_EQ(place.read("set/hall/illumination.npy"), place.read("solved/illumination.npy"));
}

// One unit of its last digit off a plane: two triangles in one row, also as it is written.
TEST(Reference, OfAMeshThatIsNearlyPlaneStaysSo) {
  const Workplace place;
  place.write("bent.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 1e-7\n0 1 0\n4 0 1 2 3\n");
  const Outcome outcome = place.run("hottel reference set bent.off");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("set/bent/scene.json"), HasSubstr("[1, 1, 0.0000001]"));
}

// Binary floats have more digits as decimals, within which they are not plane.
TEST(Reference, OfAMeshThatIsNotPlaneAsDecimalsIsRefused) {
  const Workplace place;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const auto add = [&bytes](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const float coordinate : {0.f, 0x1p-20f, 0.f, 1.f, 0.f, .1f, 1.f, 1.f, .3f, 0.f, 1.f, .2f}) add(coordinate);
  bytes += '\4';
  for (const std::int32_t corner : {0, 1, 2, 3}) add(corner);
  place.write("bent.ply", bytes);
  ASSERT_EQ(place.run("hottel factors bent.ply").code, 0);
  const Outcome outcome = place.run("hottel reference set bent.ply");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bent.ply: as a scene file by itself, which `hottel convert` writes, it cannot"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"bent.ply"});
}

TEST(Reference, NamesMustDiffer) {
  const Workplace place;
  const std::string scene = kScenes + "analytic/hexagon.json";
  EXPECT_EQ(place.run("hottel reference set " + scene + " " + scene).code, 2);
  EXPECT_EQ(place.run("hottel reference set missing.json").code, 3);
  EXPECT_TRUE(place.files().empty());
}

}  // namespace
}  // namespace hottel::reference_test
