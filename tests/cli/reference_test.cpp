// hottel reference, from outside: a set that can be checked without hottel, and that hottel agrees with.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel {
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
  EXPECT_EQ(outcome.out, "13\n12\n");  // all but SHA256SUMS itself
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

TEST(Reference, NamesMustDiffer) {
  const Workplace place;
  const std::string scene = kScenes + "analytic/hexagon.json";
  EXPECT_EQ(place.run("hottel reference set " + scene + " " + scene).code, 2);
  EXPECT_EQ(place.run("hottel reference set missing.json").code, 3);
  EXPECT_TRUE(place.files().empty());
}

}  // namespace
}  // namespace hottel
