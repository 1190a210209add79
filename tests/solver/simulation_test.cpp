// What simulations promise in both dimensions: what is shared, kept, refused and cancelled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "kernel/support/interrupt.h"
#include "tests/solver/dimensions.h"

namespace hottel::simulation_test {
namespace {

using testing::HasSubstr;

template <class D>
class SimulationTest : public testing::Test {
 protected:
  // With a grid and a picture.
  static typename D::Request coarse() {
    typename D::Request request;
    D::set_grid(request, D::grid(4, 4));
    D::set_painter(request);
    return request;
  }
  static typename D::Simulation room() { return typename D::Simulation(D::room(), coarse()); }

  // An error that names the file of the scene once.
  template <class Work>
  static void expect_file_named(const Work& work) {
    try {
      work();
      FAIL();
    } catch (const RequestError& error) {
      EXPECT_THAT(error.what(), HasSubstr("edited.json: "));
      EXPECT_EQ(std::string(error.what()).find("edited.json", 5), std::string::npos);
    }
  }
};
TYPED_TEST_SUITE(SimulationTest, BothDimensions, DimensionNames);

// The stages that two versions share, by their first letters: arrangement, factors, lights (s), system (y),
// radiosities, light (l), picture, plan (o).
template <class D>
std::string shared_stages(const typename D::Simulation& before, const typename D::Simulation& after) {
  std::string shared;
  const auto look = [&](char letter, const auto& a, const auto& b) {
    if (a == b) shared += letter;
  };
  look('a', D::arrangement(*before.prepared()), D::arrangement(*after.prepared()));
  look('f', before.factors(), after.factors());
  look('s', before.light_shares(), after.light_shares());
  look('y', before.system(), after.system());
  look('r', before.radiosities(), after.radiosities());
  look('l', before.light(), after.light());
  look('p', before.picture(), after.picture());
  look('o', before.plan(), after.plan());
  return shared;
}

// What stays the same is shared; in space plans do not depend on the grid that is asked for, nor arrangements on how
// surfaces are divided.
TYPED_TEST(SimulationTest, SharesTheStagesWhoseInputIsTheSame) {
  using Scene = typename TypeParam::Scene;
  using Request = typename TypeParam::Request;
  const typename TypeParam::Simulation simulation(TypeParam::lit_room(), this->coarse());
  const auto with_scene = [&](const auto& edit) {
    Scene scene = simulation.scene();
    edit(scene);
    return shared_stages<TypeParam>(simulation, simulation.with_scene(std::move(scene)));
  };
  const auto with_request = [&](const auto& edit) {
    Request request = simulation.request();
    edit(request);
    return shared_stages<TypeParam>(simulation, simulation.with_request(std::move(request)));
  };
  constexpr bool kIsPlane = std::is_same_v<TypeParam, PlaneTests>;
  EXPECT_EQ(with_scene([](Scene& s) { s.materials[2].emission = Spectrum::scalar(5); }), "afsy");
  EXPECT_EQ(with_scene([](Scene& s) { s.sky_emission = Spectrum::scalar(5); }), "afsy");
  EXPECT_EQ(with_scene([](Scene& s) { s.lights[0].power = Spectrum::scalar(5); }), "afsy");
  EXPECT_EQ(with_scene([](Scene& s) { s.light_places[0].position.x += 1; }), "afy");
  EXPECT_EQ(with_scene([](Scene& s) { s.materials[0].reflectivity = Spectrum::scalar(Rational(1, 3)); }), "afs");
  EXPECT_EQ(with_scene([](Scene& s) { TypeParam::move_wall(s); }), "");
  EXPECT_EQ(with_scene([](Scene& s) { s.surfaces[7].elements = 3; }), kIsPlane ? "" : "a");
  EXPECT_EQ(with_scene([](Scene& s) { s.about = "a room"; }), "afsyrlp");
  EXPECT_EQ(with_request([](Request& r) { TypeParam::set_grid(r, TypeParam::grid(5, 4)); }),
            kIsPlane ? "afsyr" : "afsyro");
  EXPECT_EQ(with_request([](Request& r) { TypeParam::set_painter(r); }), "afsyrlo");
  EXPECT_EQ(with_request([](Request& r) { r.system.solver = Solver::kLu; }), "afso");
  EXPECT_EQ(with_request([](Request& r) { TypeParam::set_visibility(r); }), "aso");
  EXPECT_EQ(with_request([](Request& r) { TypeParam::set_method(r, kIsPlane ? "center" : "points:2"); }), "aso");
  EXPECT_EQ(with_request([](Request&) {}), "afsyrlpo");
}

// Undo is the older version, with all that it had made.
TYPED_TEST(SimulationTest, AnOlderVersionKeepsItsStages) {
  const auto before = this->room();
  const auto light = before.light();
  auto scene = before.scene();
  TypeParam::move_wall(scene);
  const auto after = before.with_scene(scene);
  EXPECT_NE(TypeParam::values(*after.light()), TypeParam::values(*light));
  EXPECT_EQ(before.light(), light);
}

// Every stage after every edit, in an order that is drawn.
TYPED_TEST(SimulationTest, IsAFunctionOfItsSceneAfterManyEdits) {
  using Simulation = typename TypeParam::Simulation;
  typename TypeParam::Edits edits(TypeParam::kSeed);
  std::vector<Simulation> versions{this->room()};
  int solved = 0, failed = 0;
  for (int k = 0; k < TypeParam::kEdits; ++k) {
    // Some edits follow an older version: undone, then edited anew.
    const std::size_t from = edits.below(4) == 0 ? edits.below(versions.size()) : versions.size() - 1;
    versions.push_back(edits.next(versions[from]));
    const Simulation& edited = versions.back();
    if (edits.below(3) == 0) continue;  // nobody looks at this one
    const Simulation fresh(saved(edited.scene()), edited.request());
    const std::string traces = traces_of(edited);
    ASSERT_EQ(traces, traces_of(fresh)) << "after edit " << k;
    ++(traces.find("failed: ") == std::string::npos ? solved : failed);
  }
  EXPECT_GT(solved, TypeParam::kEdits / 5);
  EXPECT_GT(failed, TypeParam::kEdits / 200);
}

TYPED_TEST(SimulationTest, ThreadsAskEditAndCancelAtOnce) {
  using Simulation = typename TypeParam::Simulation;
  const Simulation first = this->room();
  const std::string expected = traces_of(Simulation(first.scene(), first.request()));
  std::atomic<int> wrong{0}, dropped{0};
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < 6; ++k)
    threads.emplace_back([&, k] {
      typename TypeParam::Edits edits(k);
      Simulation mine = first;
      std::mt19937 random(k);
      for (int round = 0; round < TypeParam::kRounds; ++round) {
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

// A stage that nobody waits for any more is absent, and made anew.
TYPED_TEST(SimulationTest, ACancelledThreadLeavesNothingHalfMade) {
  const auto simulation = this->room();
  const auto cancel = [](std::string_view, double) { throw Interrupted(); };
  for (int k = 0; k < 20; ++k) {
    try {
      simulation.picture(cancel);
    } catch (const Interrupted&) {
    }
  }
  EXPECT_EQ(traces_of(simulation), traces_of(this->room()));
}

TYPED_TEST(SimulationTest, AFailureStaysUntilAnEditDropsItsStage) {
  using Simulation = typename TypeParam::Simulation;
  auto scene = TypeParam::room();
  scene.closed = true;
  TypeParam::open(scene);
  const Simulation open(scene, this->coarse());
  for (int k = 0; k < 2; ++k) {
    EXPECT_NO_THROW(open.factors());
    EXPECT_THROW(open.radiosities(), RequestError);
    EXPECT_THROW(open.picture(), RequestError);
    EXPECT_THROW(open.require_closed(), RequestError);
  }
  scene.closed = false;
  const Simulation mended = open.with_scene(scene);
  EXPECT_EQ(mended.factors(), open.factors());
  EXPECT_NO_THROW(mended.picture());
  EXPECT_NO_THROW(mended.require_closed());
}

TYPED_TEST(SimulationTest, KeepsToItsMemoryAndNamesItsFile) {
  const auto simulation = this->room();
  auto request = simulation.request();
  TypeParam::set_memory(request, 1000);
  this->expect_file_named([&] { simulation.with_request(request).factors(); });
}

TYPED_TEST(SimulationTest, NamesItsFileWhereThereIsNoSolution) {
  using Simulation = typename TypeParam::Simulation;
  auto scene = TypeParam::room();
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(1);
    material.emission = Spectrum::scalar(1);
  }
  for (Surface& surface : scene.surfaces) surface.back = surface.material;
  this->expect_file_named([&] { Simulation(scene).radiosities(); });
}

TYPED_TEST(SimulationTest, RefusesAnInvalidSceneAndAnInvalidGrid) {
  using Simulation = typename TypeParam::Simulation;
  auto scene = TypeParam::room();
  TypeParam::spoil(scene);
  EXPECT_THROW(Simulation{scene}, InputError);
  EXPECT_THROW(this->room().with_scene(scene), InputError);
  auto request = this->coarse();
  TypeParam::set_grid(request, {});
  EXPECT_THROW(this->room().with_request(request), UsageError);
  EXPECT_THROW(Simulation(TypeParam::room(), request), UsageError);
}

TYPED_TEST(SimulationTest, LightsTheFirstOfSeveralGridsAndPlansThemAll) {
  using Simulation = typename TypeParam::Simulation;
  auto scene = TypeParam::room();
  scene.grids = {TypeParam::grid(3, 4), TypeParam::grid(5, 7)};
  scene.grids[0].name = "first";
  scene.grids[1].name = "second";
  const Simulation simulation(scene);
  EXPECT_EQ(TypeParam::grid_of(*simulation.light()), scene.grids[0]);
  EXPECT_EQ(simulation.grid(), scene.grids[0]);
  auto request = simulation.request();
  TypeParam::set_grid(request, scene.grids[1]);
  const Simulation second = simulation.with_request(request);
  EXPECT_EQ(TypeParam::grid_of(*second.light()), scene.grids[1]);
  EXPECT_EQ(second.radiosities(), simulation.radiosities());
  EXPECT_EQ(traces_of(second), traces_of(Simulation(scene, request)));
}

TYPED_TEST(SimulationTest, HasAPictureOnlyWithAPainter) {
  using Simulation = typename TypeParam::Simulation;
  EXPECT_THROW(Simulation(TypeParam::room()).picture(), ContractViolation);
  EXPECT_EQ(this->room().picture()->bytes, "48");
}

}  // namespace
}  // namespace hottel::simulation_test
