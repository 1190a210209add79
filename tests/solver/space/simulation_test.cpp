// A scene in space in stages: what is made once, shared, refused and cancelled.
#include "solver/space/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "solver/memory_store.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/queries.h"

namespace hottel::simulation_test {
namespace {

using ::testing::StartsWith;

Scene3 cube() { return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json"); }

TEST(Simulation3, EveryValueIsThatOfTheFunctionBehindIt) {
  const Simulation3 simulation(cube(), {.factors = {.wants_visibility = true, .wants_measures = true}});
  const auto factors = simulation.factors();
  const ExchangeMatrix expected = exact_exchange(*simulation.prepared(), {.wants_measures = true});
  ASSERT_EQ(factors->matrix.entry_count(), expected.entry_count());
  for (std::uint32_t i = 0; i < expected.size(); ++i)
    for (std::size_t k = 0; k < expected.row(i).size(); ++k) {
      EXPECT_EQ(factors->matrix.row(i)[k].factor, expected.row(i)[k].factor);
      EXPECT_EQ(factors->matrix.row(i)[k].visibility, expected.row(i)[k].visibility);
      EXPECT_EQ(factors->matrix.measures(i)[k], expected.measures(i)[k]);
    }
  EXPECT_EQ(*simulation.hidden(), hidden_pairs(*simulation.prepared(), Granularity::kFace, expected));
  EXPECT_EQ(factors->report.pairs, 15u);
}

// A row that was not chosen is empty, which says nothing of its factors.
TEST(Simulation3, OfRowsThatWereNotChosenNothingIsTold) {
  const Scene3 scene = cube();
  const Simulation3 simulation(scene, {.factors = {.rows = RowChoice::of(scene, "floor", Granularity::kFace)}});
  EXPECT_GT(view_factor(simulation, "floor", "ceiling").value, 0);
  EXPECT_THROW(view_factor(simulation, "ceiling", "floor"), UsageError);
  EXPECT_THROW(simulation.radiosities(), UsageError);
  const ExchangeMatrix& matrix = simulation.factors()->matrix;
  for (const auto& [from, to] : *simulation.hidden()) EXPECT_EQ(matrix.name(from), "floor") << matrix.name(to);
}

// Three of four parts are no division of a face.
TEST(Simulation3, TreesThatLeaveOutAPartAreRefused) {
  const Scene3 scene = cube();
  std::vector<SurfaceTrees> trees(scene.surfaces.size());
  for (int digit = 0; digit < 3; ++digit) trees[0].front.push_back({0, TreePath().child(digit)});
  const Simulation3 divided =
      Simulation3(scene, {.factors = {.granularity = Granularity::kElement}}).with_trees(std::move(trees));
  EXPECT_THROW(divided.factors(), ContractViolation);
}

TEST(Simulation3, AStageIsMadeOnceAndSharedWithOtherRequests) {
  const Simulation3 simulation(cube());
  EXPECT_EQ(simulation.factors(), simulation.factors());
  const Simulation3 again = simulation.with_request(simulation.request());
  EXPECT_EQ(again.factors(), simulation.factors());
  EXPECT_EQ(again.radiosities(), simulation.radiosities());
  const Simulation3 looser = simulation.with_request({.factors = {.tolerance = 1e-3}});
  EXPECT_EQ(looser.prepared(), simulation.prepared());
  EXPECT_NE(looser.factors(), simulation.factors());
  EXPECT_NE(looser.radiosities(), simulation.radiosities());
  const Simulation3 other = simulation.with_request({.system = {.solver = Solver::kLu}});
  EXPECT_EQ(other.factors(), simulation.factors());
  EXPECT_EQ(other.hidden(), simulation.hidden());
  EXPECT_NE(other.system(), simulation.system());
  EXPECT_EQ(other.radiosities()->used, Solver::kLu);
  EXPECT_EQ(simulation.with_request({.plan = {.everything = true}}).radiosities(), simulation.radiosities());
}

// A closed room in which everything reflects 99 % and emits 1 has the radiosity 100 everywhere, whatever stands in it.
// Without enclosures bounds hold for the factors as they are printed.
TEST(Simulation3, AFurnaceIsWithinItsBoundsWhereFactorsAreEnclosed) {
  for (const char* kind : {"room-touching", "room-turned"}) {
    Scene3 room = generate_3({.kind = kind, .n = 2, .seed = 1});
    room.closed = true;
    for (Material& material : room.materials) {
      Material white;
      white.name = material.name;
      white.reflectivity = Spectrum::scalar(Rational(99, 100));
      white.emission = Spectrum::scalar(1);
      material = white;
    }
    const Simulation3 simulation(std::move(room), {.factors = {.must_be_enclosed = true}});
    const ExchangeMatrix& factors = simulation.factors()->matrix;
    EXPECT_NE(factors.guarantee(), Guarantee::kEstimated);
    const auto solution = simulation.radiosities();
    for (const auto& channel : solution->channels)
      for (std::uint32_t i = 0; i < factors.size(); ++i) {
        if (factors.row(i).empty()) continue;  // backs, and what others stand on
        const ElementRadiosity& element = channel.elements[i];
        EXPECT_LE(element.lower, 100);
        EXPECT_GE(element.upper, 100);
        EXPECT_LE(element.upper - element.lower, 1e-9);
        EXPECT_NEAR(element.radiosity, 100, 1e-9);
      }
  }
}

// What was kept without proofs is not taken for proven.
TEST(Simulation3, AStoreKeepsProvenFactorsByThemselves) {
  const auto store = make_memory_store();
  const Scene3 room = generate_3({.kind = "room-touching", .n = 2, .seed = 1});
  const Simulation3 plain(room, {.factors = {.store = store}});
  EXPECT_EQ(plain.factors()->matrix.guarantee(), Guarantee::kEstimated);
  for (int again = 0; again < 2; ++again) {
    const Simulation3 proven(room, {.factors = {.must_be_enclosed = true, .store = store}});
    EXPECT_NE(proven.factors()->matrix.guarantee(), Guarantee::kEstimated) << again;
  }
  EXPECT_EQ(Simulation3(room, {.factors = {.store = store}}).factors()->matrix.guarantee(), Guarantee::kEstimated);
}

// (4), and (1) of it.
TEST(Simulation3, OtherMaterialsShareTheFactorsAndOtherEmissionsTheSystem) {
  const Simulation3 simulation(cube());
  const auto expect_fresh = [](const Simulation3& edited) {
    const Simulation3 fresh(edited.scene());
    for (std::size_t c = 0; c < fresh.radiosities()->channels.size(); ++c)
      for (std::size_t i = 0; i < fresh.radiosities()->channels[c].elements.size(); ++i)
        EXPECT_EQ(edited.radiosities()->channels[c].elements[i].radiosity,
                  fresh.radiosities()->channels[c].elements[i].radiosity);
  };
  std::vector<Material> materials = simulation.scene().materials;
  ASSERT_GE(materials.size(), 2u);
  materials[0].emission = Spectrum::scalar(Rational(1) / 3);
  const Simulation3 brighter = simulation.with_materials(materials);
  EXPECT_EQ(brighter.factors(), simulation.factors());
  EXPECT_EQ(brighter.system(), simulation.system());
  EXPECT_NE(brighter.radiosities(), simulation.radiosities());
  EXPECT_EQ(brighter.prepared()->scene.materials, materials);
  EXPECT_EQ(brighter.prepared()->ready, simulation.prepared()->ready);
  expect_fresh(brighter);
  materials[0].reflectivity = Spectrum::scalar(Rational(1) / 7);
  const Simulation3 darker = brighter.with_materials(materials);
  EXPECT_EQ(darker.factors(), simulation.factors());
  EXPECT_NE(darker.system(), simulation.system());
  expect_fresh(darker);
  materials[0] = materials[1];
  const Simulation3 alike = darker.with_materials(materials);
  EXPECT_EQ(alike.factors()->matrix.entry_count(), simulation.factors()->matrix.entry_count());
  expect_fresh(alike);
}

// (6).
TEST(Simulation3, RadiositiesAreSharedUnlessWhatTheyComeFromChanged) {
  Scene3 scene = cube();
  scene.grids = {{{0, 0, Rational(1, 2)}, {1, 0, 0}, {0, 1, 0}, 3, 2}};
  const Simulation3 simulation(scene);
  const auto light = simulation.light();
  scene.about = "the same, told otherwise";
  scene.camera.reset();
  const Simulation3 retold = simulation.with_scene(scene);
  EXPECT_EQ(retold.radiosities(), simulation.radiosities());
  EXPECT_EQ(retold.dividing(), simulation.dividing());
  EXPECT_EQ(retold.light(), light);
  EXPECT_EQ(retold.prepared()->scene.about, scene.about);
  scene.sky_emission = Spectrum::scalar(7);
  const Simulation3 under_sky = retold.with_scene(scene);
  EXPECT_EQ(under_sky.system(), simulation.system());
  EXPECT_NE(under_sky.radiosities(), simulation.radiosities());
  scene.closed = !scene.closed;
  EXPECT_NE(under_sky.with_scene(scene).system(), simulation.system());
}

TEST(Simulation3, MaterialsThatNoLongerAgreeOnAnOverlapAreRefused) {
  const Simulation3 simulation(parse_scene_3(R"({"hottel": 1, "dimension": 3,
    "materials": {"m": {"reflectivity": 0.5}, "n": {"reflectivity": 0.5}}, "polygons": [
    {"name": "a", "points": [[0,0,0],[1,0,0],[0,1,0]], "material": "m"},
    {"name": "b", "points": [[0,0,0],[2,0,0],[0,2,0]], "material": "n"}]})",
                                             "overlap.json"));
  EXPECT_NO_THROW(simulation.radiosities());
  std::vector<Material> materials = simulation.scene().materials;
  materials[1].emission = Spectrum::scalar(1);
  const Simulation3 parted = simulation.with_materials(materials);
  EXPECT_THROW(parted.factors(), InputError);
  materials[0].emission = Spectrum::scalar(1);
  EXPECT_NO_THROW(parted.with_materials(materials).radiosities());
}

// Draws nothing but how many cells there are, and counts.
class CountingPainter : public LightPainter3 {
 public:
  LightPicture3 paint(const IlluminationGrid3& light) const override {
    ++count;
    return {std::to_string(light.values.size())};
  }
  mutable std::atomic<int> count{0};
};

// (3), (4): light is a stage like the others.
TEST(Simulation3, LightIsMadeOnceAndDroppedByWhatItIsMadeFrom) {
  Scene3 scene = cube();
  scene.grids = {{{0, 0, Rational(1, 2)}, {1, 0, 0}, {0, 1, 0}, 3, 2}};
  const auto painter = std::make_shared<const CountingPainter>();
  const Simulation3 simulation(scene, {.light = {.painter = painter}});
  const auto light = simulation.light();
  EXPECT_EQ(
      light->values,
      illuminate_points(*simulation.prepared(), Granularity::kFace, *simulation.radiosities(), scene.grids[0]).values);
  EXPECT_EQ(simulation.light(), light);
  EXPECT_EQ(simulation.picture()->bytes, "6");
  EXPECT_EQ(simulation.picture(), simulation.picture());
  EXPECT_EQ(painter->count, 1);

  SimulationRequest3 request = simulation.request();
  request.plan.everything = true;
  EXPECT_EQ(simulation.with_request(request).light(), light);
  EXPECT_EQ(simulation.with_request(request).picture(), simulation.picture());
  request.light.grid = scene.grids[0];  // the same, said once more
  EXPECT_EQ(simulation.with_request(request).light(), light);
  request.light.painter = std::make_shared<const CountingPainter>();
  EXPECT_EQ(simulation.with_request(request).light(), light);
  EXPECT_NE(simulation.with_request(request).picture(), simulation.picture());
  request.light.grid->nu = 4;
  const Simulation3 finer = simulation.with_request(request);
  EXPECT_EQ(finer.radiosities(), simulation.radiosities());
  EXPECT_EQ(finer.light()->values.size(), 8u);
  EXPECT_EQ(finer.picture()->bytes, "8");
  EXPECT_NE(simulation.with_request({.system = {.solver = Solver::kLu}}).light(), light);
  request = simulation.request();
  request.light.is_average = true;
  EXPECT_NE(simulation.with_request(request).light(), light);
  EXPECT_TRUE(simulation.with_request(request).light()->is_average());

  std::vector<Material> materials = scene.materials;
  materials[0].emission = Spectrum::scalar(Rational(1) / 3);
  const Simulation3 brighter = simulation.with_materials(materials);
  scene.materials = materials;
  EXPECT_NE(brighter.light(), light);
  EXPECT_EQ(brighter.light()->values, Simulation3(scene).light()->values);
  EXPECT_EQ(brighter.picture()->bytes, "6");
}

TEST(Simulation3, LightIsToldOfAndCanBeCancelled) {
  Scene3 scene = cube();
  scene.grids = {{{0, 0, Rational(1, 2)}, {1, 0, 0}, {0, 1, 0}, 500, 500}};
  const Simulation3 simulation(scene);
  simulation.radiosities();
  EXPECT_THROW(simulation.light([](std::string_view stage, double) {
    if (stage == "illumination") throw Interrupted();
  }),
               Interrupted);
  const Simulation3 small = simulation.with_request({.light = {.grid = Grid3{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}}});
  EXPECT_EQ(small.light()->values.size(), 1u);
}

TEST(Simulation3, LightNeedsAGridAndAPictureAPainter) {
  const Simulation3 simulation(cube());
  EXPECT_FALSE(simulation.grid());
  EXPECT_THROW(simulation.light(), ContractViolation);
  EXPECT_THROW(simulation.picture(), ContractViolation);
  EXPECT_THROW(simulation.with_request({.light = {.grid = Grid3{{}, {1, 0, 0}, {2, 0, 0}, 1, 1}}}), UsageError);
}

TEST(Simulation3, HasNoAveragesInAVolumeHoweverItComesByOne) {
  Scene3 scene = cube();
  scene.grids = {{{0, 0, Rational(1, 2)}, {1, 0, 0}, {0, 1, 0}, 3, 2}};
  const Simulation3 simulation(scene, {.light = {.is_average = true}});
  scene.grids[0].w = Vector3{0, 0, Rational(1, 4)};
  EXPECT_THROW((Simulation3(scene, {.light = {.is_average = true}})), UsageError);
  EXPECT_THROW(simulation.with_scene(scene), UsageError);
  EXPECT_NO_THROW(simulation.with_request({}).with_scene(scene));
}

TEST(Simulation3, ThePlanIsMadeWithoutFactorsAndShared) {
  const Simulation3 simulation(cube());
  EXPECT_FALSE(simulation.plan()->uses(Plan::kOcclusion));
  EXPECT_EQ(simulation.with_request({.factors = {.tolerance = 1e-3}}).plan(), simulation.plan());
  const Simulation3 all = simulation.with_request({.plan = {.everything = true}});
  EXPECT_TRUE(all.plan()->uses(Plan::kOcclusion));
  EXPECT_EQ(all.prepared(), simulation.prepared());
}

TEST(Simulation3, RefusalsNameTheFile) {
  const std::string file = cube().file;
  const Simulation3 small(cube(), {.factors = {.memory = 100}});
  try {
    small.factors();
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), StartsWith(file + ": about 12 elements"));
  }
  Scene3 twice = cube();
  twice.surfaces[1].name = twice.surfaces[0].name;
  EXPECT_THROW(Simulation3{twice}, InputError);
}

TEST(Simulation3, WhoWaitsMayLeaveAndComeBack) {
  struct Leave {};
  const Simulation3 simulation(cube());
  try {
    simulation.factors([](std::string_view, double) { throw Leave(); });
  } catch (const Leave&) {
  }
  EXPECT_EQ(simulation.factors()->matrix.entry_count(), 30u);
}

}  // namespace
}  // namespace hottel::simulation_test
