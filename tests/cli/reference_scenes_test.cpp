// The reference set of scenes/reference: its checksums, and that what is made now agrees with it.
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "kernel/version.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::reference_scenes_test {
namespace {

using testing::HasSubstr;
using testing_cli::contents;
using testing_cli::Outcome;
using testing_cli::table;
using testing_cli::Workplace;

const std::string kSource = HOTTEL_SOURCE_DIR;
const std::string kSet = kSource + "/scenes/reference/";

nlohmann::json manifest() { return nlohmann::json::parse(contents(kSet + "reference.json")); }

// The bounds in columns `lower` and `lower` + 1 of every line of a table overlap those of another.
void expect_bounds_overlap(const std::string& made, const std::string& cited, std::size_t keys, std::size_t lower) {
  const auto ours = table(made, keys), theirs = table(cited, keys);
  ASSERT_EQ(ours.size(), theirs.size());
  for (const auto& [key, cells] : ours) {
    ASSERT_TRUE(theirs.contains(key)) << key;
    const auto& others = theirs.at(key);
    if (cells[lower] == "lower") continue;
    EXPECT_LE(std::stod(cells[lower]), std::stod(others[lower + 1])) << key;
    EXPECT_GE(std::stod(cells[lower + 1]), std::stod(others[lower])) << key;
  }
}

// The numbers of a .npy of doubles, after its header.
std::vector<double> numbers_of(const std::string& npy) {
  const std::size_t begin = 10 + static_cast<unsigned char>(npy[8]) + 256 * static_cast<unsigned char>(npy[9]);
  std::vector<double> numbers((npy.size() - begin) / sizeof(double));
  std::memcpy(numbers.data(), npy.data() + begin, numbers.size() * sizeof(double));
  return numbers;
}

TEST(ReferenceScenes, HaveTheirChecksums) {
  const Workplace place;
  const Outcome outcome = place.run("cd '" + kSet +
                                    "' && sha256sum --strict --quiet -c SHA256SUMS && find . -type f | "
                                    "wc -l && wc -l < SHA256SUMS");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto counts = testing_cli::lines_of(outcome.out);
  ASSERT_EQ(counts.size(), 2u) << outcome.out;
  EXPECT_EQ(std::stoi(counts[0]), std::stoi(counts[1]) + 1);  // all but SHA256SUMS itself
}

TEST(ReferenceScenes, AreTwentyOfBothDimensionsAllProven) {
  std::size_t in_space = 0, with_light = 0;
  const auto scenes = manifest()["scenes"];
  for (const auto& scene : scenes) {
    EXPECT_NE(scene["factors"]["guarantee"], "estimated") << scene["name"];
    EXPECT_EQ(scene["radiosities"]["guarantee"], "enclosed") << scene["name"];
    EXPECT_EQ(scene["problem"]["is"], "discrete");
    in_space += scene["units"]["areas"].get<std::string>().ends_with("²") ? 1 : 0;
    EXPECT_EQ(scene["units"]["radiosities"], "W/m²");
    with_light += scene.contains("light") ? 1 : 0;
  }
  EXPECT_EQ(scenes.size(), 20u);
  EXPECT_EQ(in_space, 10u);
  EXPECT_GE(with_light, 3u);
}

// Correctly rounded: the same bytes on every machine.
TEST(ReferenceScenes, OfThePlaneAreMadeAgainByteForByte) {
  const Workplace place;
  for (const std::string name : {"strip_obstructed", "crack_2_to_minus_50", "square_radiosity", "torch"}) {
    const Outcome outcome = place.run("hottel reference set " + kSet + name + "/scene.json --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string file : {"/scene.json", "/factors.csv", "/factors.mtx", "/factors.mtx.faces.csv"})
      EXPECT_EQ(place.read("set/" + name + file), contents(kSet + name + file)) << name << file;
    expect_bounds_overlap(place.read("set/" + name + "/radiosity.csv"), contents(kSet + name + "/radiosity.csv"), 3, 7);
  }
}

TEST(ReferenceScenes, InSpaceAreMadeAgainWithinTheirBounds) {
  const Workplace place;
  for (const std::string name : {"obstructed_squares_corner", "office_zone", "attic", "tetrahedron"}) {
    const Outcome outcome =
        place.run("hottel reference set " + kSet + name + "/scene.json --tolerance 1e-11 --guarantee enclosed --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_bounds_overlap(place.read("set/" + name + "/factors.csv"), contents(kSet + name + "/factors.csv"), 2, 3);
    expect_bounds_overlap(place.read("set/" + name + "/radiosity.csv"), contents(kSet + name + "/radiosity.csv"), 3, 7);
  }
}

TEST(ReferenceScenes, HaveLightThatIsMadeAgain) {
  const Workplace place;
  for (const std::string name : {"torch", "hall"}) {
    ASSERT_EQ(place.run("hottel reference set " + kSet + name + "/scene.json --quiet").code, 0);
    const auto ours = numbers_of(place.read("set/" + name + "/illumination.npy")),
               theirs = numbers_of(contents(kSet + name + "/illumination.npy"));
    ASSERT_EQ(ours.size(), theirs.size());
    double largest = 0;
    for (const double value : theirs) largest = std::isnan(value) ? largest : std::max(largest, value);
    ASSERT_GT(largest, 0);
    for (std::size_t k = 0; k < ours.size(); ++k)
      EXPECT_TRUE(std::isnan(theirs[k]) ? std::isnan(ours[k]) : std::abs(ours[k] - theirs[k]) <= 1e-10 * largest) << k;
  }
}

TEST(ReferenceScenes, AreCitedByThePageAndTheVersion) {
  const std::string citation = contents(kSource + "/CITATION.cff");
  EXPECT_THAT(citation, HasSubstr("cff-version: 1.2.0\n"));
  EXPECT_THAT(citation, HasSubstr(std::string("\nversion: ") + kVersion + "\n"));
  EXPECT_THAT(contents(kSet + "README.md"), HasSubstr("CITATION.cff"));
  EXPECT_THAT(contents(kSet + "README.md"), HasSubstr(manifest()["made_by"].get<std::string>()));
  EXPECT_THAT(contents(kSet + "LICENSE.txt"), HasSubstr("SPDX-License-Identifier: CC0-1.0\n"));
}

}  // namespace
}  // namespace hottel::reference_scenes_test
