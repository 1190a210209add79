// Factors from a store against factors without one: bit for bit.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "io/scene/scene_json.h"
#include "io/store/factor_store.h"
#include "kernel/support/interrupt.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/simulation/cached_sweep.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/simulation/simulation.h"
#include "solver/store.h"
#include "tests/same_matrix.h"
#include "tests/sanitizers.h"
#include "tests/solver/dimensions.h"
#include "tests/temporary_folder.h"

namespace hottel::cached_factors_test {
namespace {

class StoreFile {
 public:
  std::shared_ptr<FactorStore> open() const { return open_factor_store(path()); }
  std::filesystem::path path() const { return folder_ / "store"; }

 private:
  TemporaryFolder folder_;
};

Scene2 plane_scene(const std::string& name) { return read_scene_2(HOTTEL_SOURCE_DIR "/scenes/" + name); }
Scene3 space_scene(const std::string& name) { return read_scene_3(HOTTEL_SOURCE_DIR "/scenes/space/" + name); }

void divide(SceneTable& scene, std::uint32_t elements) {
  for (Surface& surface : scene.surfaces) surface.elements = elements;
}

const std::vector<std::string> kPlaneScenes = {"showcase/apartment.json", "showcase/maze.json", "showcase/museum.json",
                                               "analytic/square_radiosity.json", "analytic/strip_obstructed.json"};

void expect_kept(const Scene2& scene, SimulationRequest2 request) {
  const StoreFile file;
  const auto alone = Simulation2(scene, request).factors();
  for (int run = 0; run < 2; ++run) {
    request.store = file.open();
    const auto factors = Simulation2(scene, request).factors();
    expect_same(alone->matrix, factors->matrix);
    EXPECT_EQ(alone->report.notes, factors->report.notes);
    EXPECT_EQ(alone->report.row_defect, factors->report.row_defect);
    EXPECT_EQ(alone->report.counts.pairs, factors->report.counts.pairs);
    EXPECT_EQ(alone->report.counts.vertices, factors->report.counts.vertices);
    const StoreUse use = request.store->use();
    EXPECT_EQ(run == 0 ? use.read : use.computed, 0U);
    EXPECT_GT(run == 0 ? use.computed : use.read, 0U);
  }
}

void expect_kept(const Scene3& scene, SimulationRequest3 request) {
  const StoreFile file;
  const auto alone = Simulation3(scene, request).factors();
  for (int run = 0; run < 2; ++run) {
    request.factors.store = file.open();
    const auto factors = Simulation3(scene, request).factors();
    expect_same(alone->matrix, factors->matrix);
    EXPECT_EQ(alone->notes, factors->notes);
    EXPECT_EQ(alone->report.pairs, factors->report.pairs);
    EXPECT_EQ(alone->report.max_error, factors->report.max_error);
    EXPECT_EQ(alone->report.max_defect, factors->report.max_defect);
    const StoreUse use = request.factors.store->use();
    EXPECT_EQ(run == 0 ? use.read : use.computed, 0U);
    EXPECT_GT(run == 0 ? use.computed : use.read, 0U);
  }
}

TEST(CachedFactors, OfThePlaneAreThoseOfNoStore) {
  for (const std::string& name : kPlaneScenes)
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
      for (const bool wants_all : {false, true}) {
        SCOPED_TRACE(name);
        Scene2 scene = plane_scene(name);
        if (granularity == Granularity::kElement) divide(scene, 2);
        expect_kept(scene, {.granularity = granularity, .wants_visibility = wants_all, .wants_measures = wants_all});
      }
}

TEST(CachedFactors, OfEveryMethodOfThePlaneAreThoseOfNoStore) {
  const MethodCatalogue2 methods = methods_2();
  for (const MethodFamily2& family : methods.families()) {
    const std::string& name = family.sweep.front();
    for (const std::string& variant : {name, name + ":normalised"}) {
      SCOPED_TRACE(variant);
      Scene2 scene = plane_scene("showcase/museum.json");
      divide(scene, 2);
      for (const Granularity granularity : {Granularity::kElement, Granularity::kFace})
        expect_kept(scene, {.method = methods.make(variant), .granularity = granularity});
    }
  }
}

TEST(CachedFactors, OfSpaceAreThoseOfNoStore) {
  for (const char* name : {"cube.json", "two_boxes.json", "attic.json", "duct.json", "cornell_box.json"})
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
      for (const bool wants_all : {false, true}) {
        if (kHasAddressSanitizer && wants_all && std::string_view(name) != "two_boxes.json") continue;
        SCOPED_TRACE(name);
        Scene3 scene = space_scene(name);
        if (granularity == Granularity::kElement) divide(scene, 2);
        expect_kept(
            scene,
            {.factors = {.granularity = granularity, .wants_visibility = wants_all, .wants_measures = wants_all}});
      }
}

TEST(CachedFactors, OfEveryMethodOfSpaceAreThoseOfNoStore) {
  Scene3 scene = space_scene("two_boxes.json");
  divide(scene, 2);
  const MethodCatalogue3 methods = methods_3();
  for (const MethodFamily3& family : methods.families()) {
    const std::string& name = family.sweep.front();
    for (const std::string& variant : {name, name + ":normalised"}) {
      if (variant == "exact") continue;  // as a method it has bounds of its own, and is not kept; without one it is
      SCOPED_TRACE(variant);
      for (const Granularity granularity : {Granularity::kElement, Granularity::kFace})
        expect_kept(scene, {.factors = {.method = methods.make(variant), .granularity = granularity}});
    }
  }
}

// What a run has in common with those before it is read, and nothing else.
TEST(CachedFactors, ServeRunsWithOtherElements) {
  const StoreFile file;
  std::uint64_t read = 0, computed = 0;
  const auto run = [&](const Scene3& scene, Granularity granularity, bool wants_visibility) {
    const FactorsRequest3 asked{.granularity = granularity, .wants_visibility = wants_visibility};
    FactorsRequest3 kept = asked;
    kept.store = file.open();
    expect_same(Simulation3(scene, {.factors = asked}).factors()->matrix,
                Simulation3(scene, {.factors = kept}).factors()->matrix);
    read = kept.store->use().read;
    computed = kept.store->use().computed;
  };
  Scene3 scene = space_scene("two_boxes.json");
  run(scene, Granularity::kElement, true);
  EXPECT_EQ(read, 0U);
  const std::uint64_t all = computed;
  run(scene, Granularity::kElement, true);
  EXPECT_TRUE(read == all && computed == 0);
  run(scene, Granularity::kFace, false);  // the same elements by name
  EXPECT_TRUE(read == all && computed == 0);
  scene.surfaces[0].elements = 2;
  run(scene, Granularity::kElement, true);
  EXPECT_TRUE(read > all / 2 && read < all && computed > 0) << read << " and " << computed << " of " << all;
  scene.surfaces[1].elements = 3;
  run(scene, Granularity::kElement, false);
  EXPECT_TRUE(read > 0 && computed > 0);
  scene.surfaces[0].elements = 1;
  scene.surfaces[1].elements = 1;
  run(scene, Granularity::kElement, false);
  EXPECT_TRUE(read == all && computed == 0);
  run(scene, Granularity::kGroup, false);  // rows of their own
  EXPECT_EQ(read, 0U);

  // In the plane all that is missing is missing for all.
  Scene2 plane = plane_scene("showcase/museum.json");
  const auto in_plane = [&](const Scene2& now) {
    SimulationRequest2 request{.granularity = Granularity::kElement};
    const auto alone = Simulation2(now, request).factors();
    request.store = file.open();
    expect_same(alone->matrix, Simulation2(now, request).factors()->matrix);
    read = request.store->use().read;
    computed = request.store->use().computed;
  };
  in_plane(plane);
  plane.surfaces[0].elements = 3;
  in_plane(plane);
  EXPECT_EQ(read, 0U);
  plane.surfaces[0].elements = 1;
  in_plane(plane);
  EXPECT_EQ(computed, 0U);
}

// Waits for the factors until so much of them is done.
template <class Simulation>
void begin_factors(const Simulation& simulation, double fraction) {
  try {
    simulation.factors([fraction](std::string_view stage, double done) {
      if (stage == "view factors" && done >= fraction) throw Interrupted();
    });
  } catch (const Interrupted&) {
  }
}

TEST(CachedFactors, OfARunThatIsEndedServeTheNextOne) {
  for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup})
    for (const double fraction : {0.1, 0.5, 0.9}) {
      SCOPED_TRACE(fraction);
      const StoreFile file;
      Scene3 scene = space_scene("two_boxes.json");
      divide(scene, 2);
      SimulationRequest3 request{.factors = {.granularity = granularity, .wants_visibility = true}};
      const auto alone = Simulation3(scene, request).factors();
      request.factors.store = file.open();
      begin_factors(Simulation3(scene, request), fraction);
      request.factors.store = file.open();
      const auto factors = Simulation3(scene, request).factors();
      expect_same(alone->matrix, factors->matrix);
      const StoreUse use = request.factors.store->use();
      EXPECT_EQ(use.computed + use.read, alone->report.pairs);
      if (granularity == Granularity::kElement && fraction > 0.3) {  // nobody sees the sky, which comes first
        EXPECT_GT(use.read, 0U);
      }
      EXPECT_EQ(use.damaged, 0U);
    }
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
    for (const double fraction : {0.1, 0.5}) {
      SCOPED_TRACE(fraction);
      const StoreFile file;
      Scene2 scene = plane_scene("showcase/museum.json");
      divide(scene, 3);
      SimulationRequest2 request{.granularity = granularity};
      const auto alone = Simulation2(scene, request).factors();
      request.store = file.open();
      begin_factors(Simulation2(scene, request), fraction);
      request.store = file.open();
      // Another grouping, and other elements, of the same scene have sums of their own.
      Scene2 other = scene;
      divide(other, 2);
      for (const Granularity others : {Granularity::kFace, Granularity::kGroup}) {
        SimulationRequest2 asked{.granularity = others};
        const auto expected = Simulation2(other, asked).factors();
        asked.store = file.open();
        expect_same(expected->matrix, Simulation2(other, asked).factors()->matrix);
      }
      const auto factors = Simulation2(scene, request).factors();
      expect_same(alone->matrix, factors->matrix);
      if (request.store->use().computed == 0) continue;  // the first run was done before it could be ended
      EXPECT_EQ(factors->report.counts.gaps, alone->report.counts.gaps);
      EXPECT_EQ(factors->report.counts.terms, alone->report.counts.terms);
    }
}

// What is left of a sweep is taken out of the store with the end of it.
TEST(CachedFactors, OfThePlaneLeaveNoSumsBehind) {
  const StoreFile file;
  Scene2 scene = plane_scene("showcase/museum.json");
  divide(scene, 9);  // so many that none is done before it is ended
  SimulationRequest2 request{.granularity = Granularity::kElement};
  request.store = file.open();
  begin_factors(Simulation2(scene, request), 0.3);
  const StoreContents begun = store_contents(file.path(), true);
  ASSERT_EQ(begun.lists.size(), 1U);
  EXPECT_NE(begun.lists[0].about.find(", begun"), std::string::npos) << begun.lists[0].about;
  EXPECT_TRUE(begun.damage.empty());
  Simulation2(scene, request).factors();
  const StoreContents done = store_contents(file.path(), true);
  ASSERT_EQ(done.lists.size(), 1U);
  EXPECT_EQ(done.lists[0].about.find("begun"), std::string::npos) << done.lists[0].about;
}

TEST(CachedFactors, PartsOfASweepAreReadAsTheyWereWritten) {
  std::mt19937_64 random(1);
  SweptPart2 part{.begin = 12, .end = 700, .counts = {.gaps = 1ULL << 40, .updates = 9}, .sums = {}};
  for (std::uint64_t key = 0; part.sums.size() < 1000; key += 1 + (random() >> (random() % 60 + 4))) {
    PairSum2& sum = part.sums.emplace_back();
    sum.key = key;
    sum.inexact = (random() >> (1 + random() % 60)) & (~std::uint64_t{0} >> 1);
    sum.is_obstructed = random() % 2;
    const int shift = static_cast<int>(random() % 127);
    sum.value = static_cast<Int128>(static_cast<UInt128>(random()) << 64 | random()) >> shift;
    if (part.sums.size() == 1) sum.value = static_cast<Int128>(UInt128{1} << 127);
  }
  const std::string bytes = bytes_of(part, 5);
  const auto read = swept_part_2(bytes, 5);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->begin, part.begin);
  EXPECT_EQ(read->end, part.end);
  EXPECT_EQ(read->counts.gaps, part.counts.gaps);
  EXPECT_EQ(read->counts.updates, part.counts.updates);
  ASSERT_EQ(read->sums.size(), part.sums.size());
  for (std::size_t k = 0; k < part.sums.size(); ++k) {
    EXPECT_EQ(read->sums[k].key, part.sums[k].key);
    EXPECT_EQ(read->sums[k].inexact, part.sums[k].inexact);
    EXPECT_EQ(read->sums[k].is_obstructed, part.sums[k].is_obstructed);
    EXPECT_TRUE(read->sums[k].value == part.sums[k].value);
  }
  EXPECT_FALSE(swept_part_2(bytes, 6)) << "of another order";
  EXPECT_FALSE(swept_part_2(bytes.substr(0, bytes.size() - 1), 5));
  EXPECT_FALSE(swept_part_2(bytes + "x", 5));
  EXPECT_FALSE(swept_part_2("", 5));
}

// Only what was measured is kept: whichever way the sky is told, a store of the other way serves, and gives it no
// value.
TEST(CachedFactors, ServeTheSkyByClosureAndByIntegrals) {
  Scene3 scene = space_scene("city_block.json");
  for (const SkyBy first : {SkyBy::kClosure, SkyBy::kIntegral}) {
    const StoreFile file;
    std::uint64_t read = 0, computed = 0;
    const auto run = [&](SkyBy sky) {
      const FactorsRequest3 asked{.sky = sky};
      FactorsRequest3 kept = asked;
      kept.store = file.open();
      const auto alone = Simulation3(scene, {.factors = asked}).factors();
      const auto with_store = Simulation3(scene, {.factors = kept}).factors();
      expect_same(alone->matrix, with_store->matrix);
      EXPECT_EQ(alone->report.sky.has_value(), sky == SkyBy::kClosure);
      EXPECT_EQ(with_store->report.sky.has_value(), sky == SkyBy::kClosure);
      if (alone->report.sky) {
        EXPECT_EQ(alone->report.sky->told, with_store->report.sky->told);
        EXPECT_EQ(alone->report.sky->max_difference, with_store->report.sky->max_difference);
      }
      read = kept.store->use().read;
      computed = kept.store->use().computed;
    };
    run(first);
    EXPECT_EQ(read, 0U);
    const std::uint64_t all = computed;
    run(first);
    EXPECT_TRUE(read == all && computed == 0) << read << ' ' << computed;
    run(first == SkyBy::kClosure ? SkyBy::kIntegral : SkyBy::kClosure);
    EXPECT_EQ(read, all);
    EXPECT_EQ(computed > 0, first == SkyBy::kClosure) << "the skies that were told by closure";
    run(first);
    EXPECT_EQ(computed, 0U);
  }
}

TEST(CachedFactors, DependOnTheToleranceAndOnSolids) {
  const StoreFile file;
  const auto computed = [&](const Scene3& scene, double tolerance = 1e-9) {
    const auto store = file.open();
    const FactorsRequest3 asked{.tolerance = tolerance};
    FactorsRequest3 kept = asked;
    kept.store = store;
    expect_same(Simulation3(scene, {.factors = asked}).factors()->matrix,
                Simulation3(scene, {.factors = kept}).factors()->matrix);
    return store->use().computed;
  };
  Scene3 scene = space_scene("two_boxes.json");
  EXPECT_GT(computed(scene), 0U);
  EXPECT_EQ(computed(scene), 0U);
  EXPECT_GT(computed(scene, 1e-8), 0U) << "tolerance";
  scene.camera.reset();
  EXPECT_EQ(computed(scene), 0U) << "a camera";
  for (Group& group : scene.groups) group.behind = Behind::kOpen;
  EXPECT_GT(computed(scene), 0U) << "solids";
}

template <class D>
class CachedFactorsTest : public testing::Test {
 protected:
  // How many pairs are computed with what is kept, which are those of no store.
  std::uint64_t computed(const typename D::Scene& scene) const {
    typename D::Request request;
    const auto alone = typename D::Simulation(scene, request).factors();
    const auto store = file_.open();
    D::set_store(request, store);
    expect_same(alone->matrix, typename D::Simulation(scene, request).factors()->matrix);
    return store->use().computed;
  }

 private:
  StoreFile file_;
};
TYPED_TEST_SUITE(CachedFactorsTest, BothDimensions, DimensionNames);

TYPED_TEST(CachedFactorsTest, DependOnGeometryAndNotOnColours) {
  const auto scene = TypeParam::room();
  EXPECT_GT(this->computed(scene), 0U);
  EXPECT_EQ(this->computed(scene), 0U);
  auto other = scene;
  for (Material& material : other.materials) material.reflectivity.value[0] = Rational(1, 3);
  for (Material& material : other.materials) material.reflectivity.is_scalar = false;
  for (Material& material : other.materials) material.name += "'";
  other.sky_emission.value[1] = 7;
  other.sky_emission.is_scalar = false;
  other.file = "elsewhere";
  EXPECT_EQ(this->computed(other), 0U) << "colours";
  other = scene;
  TypeParam::move_wall(other);
  EXPECT_GT(this->computed(other), 0U) << "a place";
  other = scene;
  other.surfaces.front().back = 0;
  // In the plane pairs of black backs are kept too.
  EXPECT_EQ(this->computed(other) > 0, (std::is_same_v<TypeParam, SpaceTests>)) << "a back with a material";
  other = scene;
  other.surfaces.back().name += "'";
  EXPECT_GT(this->computed(other), 0U) << "a name";
  EXPECT_EQ(this->computed(scene), 0U) << "what was there before";
}

}  // namespace
}  // namespace hottel::cached_factors_test
