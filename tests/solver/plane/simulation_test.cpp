
#include "solver/plane/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/interrupt.h"
#include "solver/plane/methods/method_catalogue.h"
#include "tests/solver/plane/edited_scenes.h"

namespace hottel::simulation_test {
namespace {

using testing::ElementsAre;
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
  EXPECT_EQ(with_request([](SimulationRequest2& r) { r.solver = Solver::kCg; }), "afowc");
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

// Undo is the older version, with all that it had made.
TEST(Simulation, AnOlderVersionKeepsItsStages) {
  const Simulation2 before = simulated_room();
  const auto light = before.light();
  Scene2 scene = before.scene();
  scene.edges[3].to.x += 1;
  const Simulation2 after = before.with_scene(scene);
  EXPECT_NE(after.light()->grid.values, light->grid.values);
  EXPECT_EQ(before.light(), light);
}

// (2), every stage after every edit, in an order that is drawn
TEST(Simulation, IsAFunctionOfItsSceneAfterAThousandEdits) {
  RandomEdits edits(20261122);
  std::vector<Simulation2> versions{simulated_room()};
  int solved = 0, failed = 0;
  for (int k = 0; k < 1000; ++k) {
    // Some edits follow an older version: undone, then edited anew.
    const std::size_t from = edits.below(4) == 0 ? edits.below(versions.size()) : versions.size() - 1;
    versions.push_back(edits.next(versions[from]));
    const Simulation2& edited = versions.back();
    if (edits.below(3) == 0) continue;  // nobody looks at this one
    const Simulation2 fresh(saved(edited.scene()), edited.request());
    const std::string traces = traces_of(edited);
    ASSERT_EQ(traces, traces_of(fresh)) << "after edit " << k << ":\n" << write_scene_2(edited.scene());
    ++(traces.find("failed: ") == std::string::npos ? solved : failed);
  }
  EXPECT_GT(solved, 200);
  EXPECT_GT(failed, 5);
}

// (3)
TEST(Simulation, ThreadsAskEditAndCancelAtOnce) {
  const Simulation2 first = simulated_room();
  const std::string expected = traces_of(Simulation2(first.scene(), first.request()));
  std::atomic<int> wrong{0}, dropped{0};
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < 6; ++k)
    threads.emplace_back([&, k] {
      RandomEdits edits(k);
      Simulation2 mine = first;
      std::mt19937 random(k);
      for (int round = 0; round < 12; ++round) {
        std::atomic<bool> stop{false};
        try {
          const StopScope scope(&stop);
          stop = random() % 3 == 0;
          traces_of(mine);
          mine.light([&](std::string_view, double) { throw Interrupted(); });
        } catch (const Interrupted&) {
          ++dropped;
        } catch (const std::exception&) {  // the edit leads nowhere: for the next one to mend
        }
        mine = round % 3 == 2 ? first : edits.next(mine);
      }
      if (traces_of(first) != expected) ++wrong;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(dropped, 0);
}

// (3): a stage that nobody waits for any more is absent, and made anew.
TEST(Simulation, ACancelledThreadLeavesNothingHalfMade) {
  const Simulation2 simulation = simulated_room();
  const auto cancel = [](std::string_view, double) { throw Interrupted(); };
  for (int k = 0; k < 20; ++k) {
    try {
      simulation.picture(cancel);
    } catch (const Interrupted&) {
    }
  }
  EXPECT_EQ(traces_of(simulation), traces_of(simulated_room()));
}

TEST(Simulation, AFailureStaysUntilAnEditDropsItsStage) {
  Scene2 scene = room_to_edit();
  scene.closed = true;
  scene.edges[4].to.y = 7;  // a gap in the wall
  const Simulation2 open(scene, coarse(scene));
  for (int k = 0; k < 2; ++k) {
    EXPECT_NO_THROW(open.factors());
    EXPECT_THROW(open.radiosities(), RequestError);
    EXPECT_THROW(open.picture(), RequestError);
  }
  scene.closed = false;
  const Simulation2 mended = open.with_scene(scene);
  EXPECT_EQ(mended.factors(), open.factors());
  EXPECT_NO_THROW(mended.picture());
}

// (4)
TEST(Simulation, KeepsToItsMemory) {
  Simulation2 simulation = simulated_room();
  SimulationRequest2 request = simulation.request();
  request.memory = 1000;
  EXPECT_THROW(simulation.with_request(request).factors(), RequestError);
}

TEST(Simulation, NamesItsFile) {
  const Scene2 mirrors = parse_scene_2(R"({"hottel": 1, "dimension": 2,
    "materials": {"mirror": {"reflectivity": 1, "emission": 1}},
    "polylines": [{"name": "room", "points": [[0,0],[0,1],[1,1],[1,0]], "closed": true, "material": "mirror"}]})",
                                       "edited.json");
  try {
    Simulation2(mirrors).radiosities();
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edited.json: "));
    EXPECT_EQ(std::string(error.what()).find("edited.json", 5), std::string::npos);
  }
}

TEST(Simulation, RefusesAnInvalidScene) {
  Scene2 scene = room_to_edit();
  scene.edges[0].to = scene.edges[0].from;
  EXPECT_THROW(Simulation2{scene}, InputError);
  EXPECT_THROW(simulated_room().with_scene(scene), InputError);
  EXPECT_THROW(simulated_room().with_request({.grid = Grid2{{0, 0}, {0, 1}, 2, 2}}), UsageError);
}

TEST(Simulation, LightsTheFirstOfSeveralGridsAndPlansThemAll) {
  Scene2 scene = room_to_edit();
  scene.grids = {{{0, 0}, {1, 1}, 3, 4, "first"}, {{1, 0}, {2, 1}, 5, 7, "second"}};
  const Simulation2 simulation(scene);
  EXPECT_EQ(simulation.light()->grid.grid, scene.grids[0]);
  const auto cells = [](const Simulation2& of) {
    const auto plan = of.plan();
    return std::ranges::find(plan->effects(), std::string(Plan::kIllumination), &PlannedEffect::effect)->reason;
  };
  EXPECT_EQ(cells(simulation), "47 cells");
  const Simulation2 second = simulation.with_request({.grid = scene.grids[1]});
  EXPECT_EQ(cells(second), "35 cells");
  EXPECT_EQ(second.light()->grid.grid, scene.grids[1]);
  EXPECT_EQ(second.radiosities(), simulation.radiosities());
  EXPECT_EQ(second.light()->grid.values, Simulation2(scene, {.grid = scene.grids[1]}).light()->grid.values);
}

TEST(Simulation, HasAPictureOnlyWithAPainter) {
  EXPECT_THROW(Simulation2(room_to_edit()).picture(), ContractViolation);
  EXPECT_EQ(simulated_room().picture()->bytes, "48");
}

}  // namespace
}  // namespace hottel::simulation_test
