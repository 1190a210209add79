// What is told of the light in a scene before it is solved for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/solver/plane/check_scenes.h"

namespace hottel::scene_check_light_test {
namespace {

using namespace check_scenes;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneCheck2, ARoomOfMirrorsHasNoSolutionWhenItEmits) {
  const std::string mirrors = ring("[0,0],[0,3],[4,3],[4,0]", "mirror");
  const Scene2 scene = scene_of(edge("lamp", "[1, 1], [2, 1]", "glowing mirror", "mirror"), rings({mirrors}));
  EXPECT_THAT(kinds(found(scene)), ElementsAre("error no-solution"));
  EXPECT_THROW(solve_radiosity(exact_exchange(prepare(scene)), scene.materials, {}), RequestError);

  const Scene2 dark = scene_of(edge("screen", "[1, 1], [2, 1]", "mirror", "mirror"), rings({mirrors}));
  EXPECT_THAT(kinds(found(dark)), ElementsAre("note all-reflecting", "note no-light"));
  EXPECT_NO_THROW(solve_radiosity(exact_exchange(prepare(dark)), dark.materials, {}));
}

TEST(SceneCheck2, ABrightRoomTellsHowManyIterationsItTakes) {
  const Findings2 findings = found(scene_of("", rings({ring("[0,0],[0,3],[4,3],[4,0]", "bright")})));
  ASSERT_THAT(kinds(findings), ElementsAre("note slow-convergence"));
  EXPECT_THAT(findings[0].message, HasSubstr("2.8e+07 iterations"));  // log(1e-12) / log(1 - 1e-6)
}

// Would prepare, the promise to be closed, or solve fail?
bool cannot_be_solved(const Scene2& scene) {
  try {
    const ExchangeMatrix matrix =
        exact_exchange(prepare(scene, Divided2::kYes), {.granularity = Granularity::kElement});
    for (std::uint32_t i = 0; i < matrix.size() && scene.closed; ++i)
      for (const FactorEntry& entry : matrix.row(i))
        if (matrix.has_row(i) && !matrix.elements()[i].is_back && entry.to == matrix.sky()) return true;
    if (below_doubles(matrix, scene.materials)) return true;
    require_doubles(matrix, scene.sky_emission, solve_radiosity(matrix, scene.materials, scene.sky_emission));
  } catch (const InputError&) {
    return true;
  } catch (const RequestError&) {
    return true;
  }
  return false;
}

TEST(SceneCheck2, TellsAnErrorIffTheSceneCannotBeSolved) {
  std::size_t errors = 0, scenes = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const bool closed : {false, true}) {
      Scene2 scene = testing_scenes::generated("lattice", 24 + seed % 7, seed);
      scene.closed = closed;
      if (seed % 3 == 0)  // mirrors all around, and lamps
        for (Material& material : scene.materials) material.reflectivity = Spectrum::scalar(1);
      if (seed % 2 == 0) {
        scene.surfaces.erase(scene.surfaces.begin());
        scene.edges.erase(scene.edges.begin());
      }
      if (seed % 5 == 0) scene.surfaces[3].elements = 2;
      const bool told = has_error(Simulation2(scene).check()->findings);
      EXPECT_EQ(told, cannot_be_solved(scene)) << "seed " << seed << (closed ? ", closed" : "");
      errors += told;
      ++scenes;
    }
  EXPECT_GT(errors, 10u);
  EXPECT_LT(errors, scenes);
}

TEST(SceneCheck2, ForeseesWhatDoublesCannotTell) {
  const auto number = [](const std::string& text) { return parse_rational(text).value(); };
  std::size_t errors = 0, scenes = 0;
  for (const char* scale : {"1e-400", "1e-200", "1", "1e200", "1e308", "1e400"})
    for (const char* emission : {"1e-400", "1e-300", "1e-100", "1", "1e150", "1e308", "1e400"})
      for (const char* loss : {"1e-400", "1e-320", "1e-200", "1e-100", "1/2", "1"})
        for (const bool is_open : {false, true}) {
          Scene2 scene = scene_of(kLamp, rings({kRoom}));
          if (is_open) scene.edges.back().from.x -= number("1e-180");  // a slit in the floor
          for (Edge2& surface : scene.edges)
            for (Point2* point : {&surface.from, &surface.to})
              *point = {point->x * number(scale), point->y * number(scale)};
          for (const std::uint32_t used : {scene.surfaces.front().material, scene.surfaces.back().material}) {
            scene.materials[used].reflectivity = Spectrum::scalar(1 - number(loss));
            scene.materials[used].emission = Spectrum::scalar(number(emission));
          }
          const Findings2 findings = Simulation2(scene).check()->findings;
          EXPECT_EQ(has_error(findings), cannot_be_solved(scene))
              << "scale " << scale << ", emission " << emission << ", loss " << loss << (is_open ? ", open" : "");
          for (const Finding2& finding : findings)
            if (finding.severity == Severity::kError) {
              EXPECT_EQ(finding.kind, "beyond-doubles");
              EXPECT_FALSE(finding.surfaces.empty());
            }
          errors += has_error(findings);
          ++scenes;
        }
  EXPECT_GT(errors, scenes / 4);
  EXPECT_LT(errors, scenes * 4 / 5);
}

TEST(SceneCheck2, NamesWhatIsBeyondDoubles) {
  const auto with = [](auto&& change) {
    Scene2 scene = scene_of(kLamp, rings({kRoom}));
    change(scene);
    return scene;
  };
  const Rational large = parse_rational("1e400").value();
  const Scene2 bright =
      with([&](Scene2& scene) { scene.materials[scene.surfaces.front().material].emission = Spectrum::scalar(large); });
  EXPECT_THAT(kinds(found(bright)), ElementsAre("error beyond-doubles"));
  EXPECT_THAT(names(bright, found(bright).front()), ElementsAre("lamp"));
  EXPECT_THAT(found(bright).front().message, HasSubstr("the emission of 'lamp' is beyond the range of doubles"));
  const Scene2 sky = with([&](Scene2& scene) { scene.sky_emission = Spectrum::scalar(large); });
  EXPECT_THAT(found(sky).front().message, HasSubstr("the emission of the sky is beyond the range of doubles"));
  const Scene2 wide = with([&](Scene2& scene) { scene.edges.front().to.x = large; });
  EXPECT_THAT(names(wide, found(wide).front()), ElementsAre("lamp"));
  const Scene2 mirrors = with([&](Scene2& scene) {
    for (Material& material : scene.materials) material.reflectivity = Spectrum::scalar(1 - 1 / large);
  });
  EXPECT_THAT(kinds(found(mirrors)), ElementsAre("error beyond-doubles"));
  EXPECT_THAT(found(mirrors).front().message,
              HasSubstr("the light of 'lamp', 'room[0]', 'room[1]' and 2 more is beyond"));
  EXPECT_EQ(found(mirrors).front().surfaces.size(), 5u);
}

}  // namespace
}  // namespace hottel::scene_check_light_test
