
#include "solver/plane/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/methods/method_catalogue.h"
#include "tests/solver/plane/edited_scenes.h"

namespace hottel::simulation_test {
namespace {

using testing::HasSubstr;

class NoPainter final : public LightPainter2 {
 public:
  LightPicture2 paint(const PreparedScene2&, const IlluminationGrid2& light) const override {
    return {.bytes = std::to_string(light.values.size())};
  }
};

SimulationRequest2 coarse(const Scene2& scene) {
  SimulationRequest2 request;
  request.grid = grid_over(scene, 4, 4);
  request.painter = std::make_shared<const NoPainter>();
  return request;
}

Simulation2 simulated_room() {
  const Scene2 scene = room_to_edit();
  return Simulation2(scene, coarse(scene));
}

// The stages of one version that another shares, by their first letters: arrangement, factors, radiosities, light,
// picture, plan (o), lost light (w), check.
std::string shared_stages(const Simulation2& before, const Simulation2& after) {
  std::string shared;
  const auto look = [&](char letter, const auto& a, const auto& b) {
    if (a == b) shared += letter;
  };
  look('a', before.prepared()->shared, after.prepared()->shared);
  look('f', before.factors(), after.factors());
  look('r', before.radiosities(), after.radiosities());
  look('l', before.light(), after.light());
  look('p', before.picture(), after.picture());
  look('o', before.plan(), after.plan());
  look('w', before.lost_light(), after.lost_light());
  look('c', before.check(), after.check());
  return shared;
}

// (1)
TEST(Simulation, DropsExactlyTheStagesWhoseInputChanged) {
  const Simulation2 simulation = simulated_room();
  const auto with_scene = [&](const auto& edit) {
    Scene2 scene = simulation.scene();
    edit(scene);
    return shared_stages(simulation, simulation.with_scene(std::move(scene)));
  };
  const auto with_request = [&](const auto& edit) {
    SimulationRequest2 request = simulation.request();
    edit(request);
    return shared_stages(simulation, simulation.with_request(std::move(request)));
  };
  EXPECT_EQ(with_scene([](Scene2& s) { s.materials[2].emission = Spectrum::scalar(5); }), "af");
  EXPECT_EQ(with_scene([](Scene2& s) { s.sky_emission = Spectrum::scalar(5); }), "af");
  EXPECT_EQ(with_scene([](Scene2& s) { s.materials[0].reflectivity = Spectrum::scalar(Rational(1, 3)); }), "af");
  EXPECT_EQ(with_scene([](Scene2& s) { s.edges[3].to.x += 1; }), "");
  EXPECT_EQ(with_scene([](Scene2& s) { s.surfaces[10].elements = 3; }), "");
  EXPECT_EQ(with_scene([](Scene2& s) { s.about = "a room"; }), "afrlp");
  // Two materials that act alike from now on: claims on an overlap may be decided otherwise.
  EXPECT_EQ(with_scene([](Scene2& s) { s.materials[3].reflectivity = s.materials[0].reflectivity; }), "");

  EXPECT_EQ(with_request([&](SimulationRequest2& r) { r.grid = grid_over(simulation.scene(), 5, 4); }), "afrwc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.light = LightKind2::kAverage; }), "afrwc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.painter = std::make_shared<const NoPainter>(); }), "afrlowc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.system.solver = Solver::kCg; }), "afowc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.wants_visibility = true; }), "aoc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.method = methods_2().make("center"); }), "aoc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.method = methods_2().make("exact"); }), "afrlpowc");
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.granularity = Granularity::kFace; }), "oc");
  EXPECT_EQ(with_request([](SimulationRequest2&) {}), "afrlpowc");
}

TEST(Simulation, KeepsRowsThroughEditsOfMaterialsAndMakesTheSameLightOfThem) {
  const Simulation2 looking = simulated_room();
  SimulationRequest2 request = looking.request();
  request.keeps_rows = true;
  const Simulation2 keeping(looking.scene(), request);
  EXPECT_EQ(traces_of(keeping), traces_of(looking));
  Scene2 scene = keeping.scene();
  scene.materials[2].emission = Spectrum::scalar(5);
  scene.materials[0].reflectivity = Spectrum::scalar(Rational(1, 3));
  const Simulation2 edited = keeping.with_scene(scene);
  EXPECT_EQ(edited.rows(), keeping.rows());
  EXPECT_EQ(traces_of(edited), traces_of(looking.with_scene(scene)));
  scene.edges[3].to.x += 1;
  EXPECT_NE(keeping.with_scene(scene).rows(), keeping.rows());
  request.memory = 40'000;  // enough for the factors
  request.grid = grid_over(scene, 400, 400);
  EXPECT_NO_THROW(keeping.with_request(request).factors());
  try {  // each failure names the file once, whoever asks
    keeping.with_request(request).light();
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edited.json: "));
    EXPECT_EQ(std::string(error.what()).find("edited.json", 5), std::string::npos);
  }
}

TEST(Simulation, PlansAllGridsOrTheOneThatIsAskedFor) {
  Scene2 scene = room_to_edit();
  scene.grids = {{{0, 0}, {1, 1}, 3, 4, "first"}, {{1, 0}, {2, 1}, 5, 7, "second"}};
  const Simulation2 simulation(scene);
  const auto cells = [](const Simulation2& of) {
    const auto plan = of.plan();
    return std::ranges::find(plan->effects(), std::string(Plan::kIllumination), &PlannedEffect::effect)->reason;
  };
  EXPECT_EQ(cells(simulation), "47 cells");
  EXPECT_EQ(cells(simulation.with_request({.grid = scene.grids[1]})), "35 cells");
}

}  // namespace
}  // namespace hottel::simulation_test
