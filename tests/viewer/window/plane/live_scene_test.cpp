// Light of a scene while it is edited, the result for the view mode, and which part of the plane is shown.
#include "viewer/window/plane/live_scene.h"

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/scene_names.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/computed_factors.h"
#include "tests/sanitizers.h"
#include "tests/solver/plane/edited_scenes.h"
#include "tests/temporary_folder.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/window/plane/camera.h"
#include "viewer/window/plane/scene_file.h"
#include "viewer/window/plane/scene_views.h"

namespace hottel::live_scene_test {
namespace {

using testing::HasSubstr;

constexpr double kPatience = 300;  // seconds

std::shared_ptr<const Scene2> shared(Scene2 scene) { return std::make_shared<const Scene2>(std::move(scene)); }

// A grid beyond kCoarseCells, so that there is a coarse state before the full one.
Scene2 room_with_many_cells() {
  Scene2 scene = small_room();
  scene.grids = {grid_over(scene, 100, 75)};
  return scene;
}

Scene2 with_vertex(const Scene2& scene, const Point2& from, const Point2& to) {
  return move_points(scene, std::vector<PointMove2>{{from, to}});
}

Scene2 with_white(const Scene2& scene, const Rational& reflectivity) {
  Material white = scene.materials[0];
  white.reflectivity = Spectrum::scalar(reflectivity);
  return set_material(scene, 0, white);
}

// All states that were published, by who watches.
class Watched {
 public:
  explicit Watched(const SimulationRequest2& request = {})
      : live_(std::make_unique<LiveScene2>(request, [this] {
          while (live_pointer_ == nullptr) std::this_thread::yield();
          const auto state = live_pointer_.load()->state();
          const std::lock_guard lock(mutex_);
          states_.push_back(state);
        })) {
    live_pointer_ = live_.get();
  }
  LiveScene2& live() { return *live_; }
  std::vector<std::shared_ptr<const LiveState2>> states() const {
    const std::lock_guard lock(mutex_);
    return states_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<const LiveState2>> states_;
  std::atomic<LiveScene2*> live_pointer_{nullptr};
  std::unique_ptr<LiveScene2> live_;
};

std::string bits_of(const LiveState2& state) {
  Traces traces;
  const ExchangeMatrix& matrix = state.factors->matrix;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    traces.add_text(matrix.elements()[i].name);
    if (!matrix.has_row(i)) continue;
    for (const FactorEntry& entry : matrix.row(i)) {
      traces.add_number(entry.to);
      traces.add_number(entry.factor.value);
    }
  }
  for (const ChannelSolution& channel : state.radiosities->channels)
    for (const ElementRadiosity& element : channel.elements)
      for (const double value : {element.radiosity, element.lower, element.upper}) traces.add_number(value);
  for (const double value : state.light->grid.values) traces.add_number(value);
  return traces.text();
}

// The state of a new simulation.
LiveState2 fresh_state(const Scene2& scene, const SimulationRequest2& request = {}) {
  const Simulation2 simulation(scene, request);
  LiveState2 state;
  state.prepared = simulation.prepared();
  state.factors = simulation.factors();
  state.radiosities = simulation.radiosities();
  state.light = simulation.light();
  return state;
}

void expect_fresh(const LiveState2& state, const Scene2& scene, const SimulationRequest2& request = {}) {
  ASSERT_NE(state.light, nullptr) << state.problem;
  EXPECT_EQ(state.problem, "");
  EXPECT_TRUE(state.errors.empty());
  EXPECT_EQ(state.depth, LiveDepth2::kFull);
  EXPECT_EQ(difference(*state.scene, scene), "");
  EXPECT_EQ(bits_of(state), bits_of(fresh_state(scene, request)));
}

TEST(CoarseGrid2, HasAtMostSoManyCellsInAboutTheSameProportion) {
  Grid2 grid = grid_over(small_room(), 1, 1);
  for (std::uint32_t nx : {1u, 7u, 64u, 65u, 256u, 4000u})
    for (std::uint32_t ny : {1u, 3u, 48u, 97u, 1000u})
      for (std::uint32_t most : {1u, 2u, 100u, kCoarseCells}) {
        grid.nx = nx;
        grid.ny = ny;
        const Grid2 coarse = coarse_grid_2(grid, most);
        EXPECT_LE(std::uint64_t{coarse.nx} * coarse.ny, most);
        EXPECT_TRUE(coarse.nx >= 1 && coarse.nx <= nx && coarse.ny >= 1 && coarse.ny <= ny);
        EXPECT_EQ(coarse.min, grid.min);
        EXPECT_EQ(coarse.max, grid.max);
        if (nx * ny <= most) {
          EXPECT_EQ(coarse, grid);
        }
        if (coarse.nx > 8 && coarse.ny > 8) {
          EXPECT_NEAR(double(coarse.nx) / coarse.ny * ny / nx, 1, 0.15) << nx << "x" << ny << " " << most;
        }
      }
  EXPECT_THROW(coarse_grid_2(grid, 0), ContractViolation);
}

TEST(LiveScene2, BeginsWithoutAScene) {
  const LiveScene2 live({});
  EXPECT_TRUE(live.is_done());
  EXPECT_TRUE(live.wait(0));
  EXPECT_EQ(live.state()->version, 0u);
  EXPECT_EQ(live.state()->scene, nullptr);
}

TEST(LiveScene2, IsThatOfANewSimulationWhenItIsDone) {
  Watched watched;
  Scene2 scene = room_with_many_cells();
  std::uint64_t version = 0;
  for (int k = 0; k < 5; ++k) {
    scene = k % 2 == 0 ? with_vertex(scene, {2, 1}, {2, 1 + Rational(k) / 10})
                       : with_vertex(scene, {2, 1 + Rational(k - 1) / 10}, {2, 1});
    EXPECT_EQ(watched.live().set(shared(scene), LiveDepth2::kFull), ++version);
    ASSERT_TRUE(watched.live().wait(kPatience));
    EXPECT_TRUE(watched.live().is_done());
    EXPECT_EQ(watched.live().state()->version, version);
    expect_fresh(*watched.live().state(), scene);
  }
}

TEST(LiveScene2, KeepsToTheRequest) {
  const Scene2 scene = small_room();
  SimulationRequest2 request{.system = {.solver = Solver::kJacobi, .iterations = 3}, .light = LightKind2::kAverage};
  LiveScene2 live(request);
  live.set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(live.wait(kPatience));
  expect_fresh(*live.state(), scene, request);
}

TEST(LiveScene2, IsShownCoarseFirst) {
  Watched watched;
  const Scene2 scene = room_with_many_cells();
  watched.live().set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  const auto state = watched.live().state();
  const auto states = watched.states();
  ASSERT_GE(states.size(), 1u);
  EXPECT_EQ(states[0]->depth, LiveDepth2::kCoarse);
  EXPECT_EQ(states[0]->light->grid.grid, coarse_grid_2(scene.grids.front(), kCoarseCells));
  EXPECT_EQ(states[0]->factors, state->factors);  // all but the grid is as in the full one
  EXPECT_EQ(states[0]->radiosities, state->radiosities);
  EXPECT_EQ(state->depth, LiveDepth2::kFull);
  EXPECT_EQ(state->light->grid.grid, scene.grids.front());
  EXPECT_GT(state->seconds, 0);
}

TEST(LiveScene2, IsNotMadeFurtherThanCoarseUntilItIsSetAgain) {
  Watched watched;
  const Scene2 scene = room_with_many_cells();
  watched.live().set(shared(scene), LiveDepth2::kCoarse);
  ASSERT_TRUE(watched.live().wait(kPatience));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(watched.live().state()->depth, LiveDepth2::kCoarse);
  EXPECT_EQ(watched.live().state()->light->grid.grid.nx, coarse_grid_2(scene.grids.front(), kCoarseCells).nx);
  EXPECT_EQ(watched.states().size(), 1u);
  watched.live().set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  EXPECT_EQ(watched.live().state()->version, 2u);
  expect_fresh(*watched.live().state(), scene);
}

TEST(LiveScene2, IsDoneAtOnceWhereTheGridIsCoarseAnyway) {
  Watched watched;
  watched.live().set(shared(small_room()), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  expect_fresh(*watched.live().state(), small_room());
  EXPECT_LE(watched.states().size(), 1u);
}

TEST(LiveScene2, MakesOfWhatWaitsTheLastOnly) {
  Watched watched;
  const Scene2 scene = room_with_many_cells();
  Scene2 last = scene;
  constexpr int kVersions = 200;
  for (int k = 0; k < kVersions; ++k) {
    last = with_vertex(scene, {2, 1}, {2, 1 + Rational(k) / 1000});
    watched.live().set(shared(last), LiveDepth2::kFull);
  }
  ASSERT_TRUE(watched.live().wait(kPatience));
  expect_fresh(*watched.live().state(), last);
  std::uint64_t before = 0;
  std::set<std::uint64_t> versions;
  for (const auto& state : watched.states()) {
    EXPECT_GE(state->version, before);
    before = state->version;
    versions.insert(state->version);
  }
  EXPECT_LT(versions.size(), kVersions / 2u);  // what waited meanwhile was never begun
}

// Versions that are set faster than they are made: each that was begun is shown.
TEST(LiveScene2, ShowsSomethingNewHoweverFastVersionsFollow) {
  for (const bool is_valid : {true, false}) {
    Watched watched;
    const Scene2 scene = room_with_many_cells();
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    int k = 0;
    while (std::chrono::steady_clock::now() < until && watched.states().size() < 5) {
      const Rational y = Rational(++k % 1000) / 1000;
      // A "closed" that is broken at the corner of the room: there is no light.
      watched.live().set(
          shared(is_valid ? with_vertex(scene, {2, 1}, {2, 1 + y / 4}) : move_end(scene, 1, false, {y / 9 + 1, 0})),
          LiveDepth2::kFull);
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    EXPECT_GE(watched.states().size(), 5u) << is_valid << " " << k;
    EXPECT_GT(k, 5);
  }
}

TEST(LiveScene2, MaterialEditsAfterRestGiveTheSameBits) {
  Watched watched;
  Scene2 scene = room_with_many_cells();
  watched.live().set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  for (int k = 1; k <= 6; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(k % 2 == 0 ? 300 : 0));  // with and without kept rows
    scene = with_white(scene, Rational(k) / 8);
    if (k == 5) scene = with_vertex(scene, {1, 2}, {1, Rational(5) / 2});  // what the cells see is void
    watched.live().set(shared(scene), LiveDepth2::kFull);
    ASSERT_TRUE(watched.live().wait(kPatience));
    expect_fresh(*watched.live().state(), scene);
  }
}

// What is seen from the cells is kept: the state that follows an edit of materials is full at once.
TEST(LiveScene2, HasNoCoarseStateAfterAnEditOfMaterialsAtRest) {
  Watched watched;
  Scene2 scene = room_with_many_cells();
  watched.live().set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  std::this_thread::sleep_for(std::chrono::seconds(1));  // the rows
  const std::size_t before = watched.states().size();
  watched.live().set(shared(with_white(scene, Rational(1) / 8)), LiveDepth2::kFull);
  ASSERT_TRUE(watched.live().wait(kPatience));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (watched.states().size() == before && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  const auto states = watched.states();
  ASSERT_EQ(states.size(), before + 1);
  EXPECT_EQ(states.back()->depth, LiveDepth2::kFull);
}

struct BadScene {
  const char* name;
  std::string text;  // of the file
  const char* problem;
  bool has_errors;  // that check can tell
};

std::vector<BadScene> bad_scenes() {
  const std::string head = R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1},
    "n": {"reflectivity": 0.25}}, "edges": [)";
  return {
      {"conflicting claims", head + R"({"name": "one", "points": [[0,0],[2,0]], "material": "m"},
                 {"name": "two", "points": [[1,0],[3,0]], "material": "n"}]})",
       "'one'", true},
      {"a broken promise", head + R"({"name": "one", "points": [[0,0],[2,0]], "material": "m"},
                 {"name": "two", "points": [[0,1],[2,1]], "material": "m"}], "closed": true})",
       "closed", true},
  };
}

Scene2 obstinate_scene() {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
    "polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "m"},
                  {"name": "box", "points": [[1,1],[2,1],[2,2]], "material": "m", "behind": "solid"}]})",
                       "obstinate.json");
}

void expect_as_checked(const LiveState2& state, const Scene2& scene) {
  EXPECT_EQ(state.light, nullptr);
  EXPECT_NE(state.problem, "");
  EXPECT_EQ(state.problem.find('\n'), std::string::npos);
  EXPECT_EQ(difference(*state.scene, scene), "");
  std::string reason;
  try {
    Simulation2(scene).light();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  EXPECT_EQ(state.problem, reason);
  std::vector<std::string> found, expected;
  for (const Finding2& finding : state.errors) found.push_back(finding.message);
  try {
    const auto check = Simulation2(scene).check();
    for (const Finding2& finding : check->findings)
      if (finding.severity == Severity::kError) expected.push_back(finding.message);
  } catch (const InputError&) {  // check has no list of it either
  }
  EXPECT_EQ(found, expected);
}

TEST(LiveScene2, SaysWhyThereIsNoLight) {
  LiveScene2 live({});
  const Scene2 good = small_room();
  for (const BadScene& bad : bad_scenes()) {
    SCOPED_TRACE(bad.name);
    const Scene2 scene = parse_scene_2(bad.text, "bad.json");
    for (const LiveDepth2 depth : {LiveDepth2::kCoarse, LiveDepth2::kFull}) {
      live.set(shared(scene), depth);
      ASSERT_TRUE(live.wait(kPatience));
      EXPECT_EQ(live.state()->depth, depth);
      expect_as_checked(*live.state(), scene);
      EXPECT_THAT(live.state()->problem, HasSubstr(bad.problem));
      EXPECT_EQ(!live.state()->errors.empty(), bad.has_errors);
    }
    live.set(shared(good), LiveDepth2::kFull);  // the next edit mends it
    ASSERT_TRUE(live.wait(kPatience));
    expect_fresh(*live.state(), good);
  }
}

TEST(LiveScene2, SaysWhichBehindCannotBeObeyed) {
  LiveScene2 live({});
  const Scene2 scene = obstinate_scene();
  ASSERT_THROW(Simulation2(scene).prepared(), InputError);
  live.set(shared(scene), LiveDepth2::kFull);
  ASSERT_TRUE(live.wait(kPatience));
  EXPECT_EQ(live.state()->prepared, nullptr);
  expect_as_checked(*live.state(), scene);
}

TEST(LiveScene2, SaysWhatMakesASceneNone) {
  LiveScene2 live({});
  Scene2 scene = small_room();
  for (const bool is_first : {true, false}) {
    const Scene2 bad = move_end(scene, 0, true, scene.edges[0].from);
    live.set(shared(bad), LiveDepth2::kFull);
    ASSERT_TRUE(live.wait(kPatience)) << is_first;
    std::string reason;
    try {
      const Simulation2 none(bad);
    } catch (const InputError& error) {
      reason = error.what();
    }
    EXPECT_NE(reason, "");
    EXPECT_EQ(live.state()->problem, reason);
    EXPECT_FALSE(live.state()->simulation);
    EXPECT_EQ(live.state()->prepared, nullptr);
    EXPECT_EQ(live.state()->depth, LiveDepth2::kFull);
    live.set(shared(scene), LiveDepth2::kFull);
    ASSERT_TRUE(live.wait(kPatience));
    expect_fresh(*live.state(), scene);
  }
}

TEST(LiveScene2, HasNoLightWhereMemoryDoesNotSuffice) {
  LiveScene2 live({.memory = 100});
  live.set(shared(small_room()), LiveDepth2::kFull);
  ASSERT_TRUE(live.wait(kPatience));
  EXPECT_EQ(live.state()->factors, nullptr);
  EXPECT_NE(live.state()->prepared, nullptr);
  EXPECT_THAT(live.state()->problem, HasSubstr("the limit is 100 bytes"));
}

constexpr int kHammer = kHasAddressSanitizer || kHasThreadSanitizer ? 25 : 300;

TEST(LiveSceneThread, EndsAtAnyMoment) {
  std::mt19937_64 random(7);
  const Scene2 scene = room_with_many_cells();
  const auto bad = shared(parse_scene_2(bad_scenes()[0].text, "bad.json"));
  for (int k = 0; k < kHammer; ++k) {
    LiveScene2 live({});
    const auto sets = random() % 4;
    for (std::uint64_t n = 0; n < sets; ++n) {
      const auto next =
          random() % 5 == 0 ? bad
          : random() % 2 == 0
              ? shared(with_white(scene, Rational(static_cast<long>(random() % 9)) / 10))
              : shared(with_vertex(scene, {2, 1}, {2, 1 + Rational(static_cast<long>(random() % 99)) / 200}));
      live.set(next, random() % 2 == 0 ? LiveDepth2::kCoarse : LiveDepth2::kFull);
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
    }
  }
}

TEST(LiveSceneThread, IsAskedByManyWhileItIsSet) {
  const Scene2 scene = room_with_many_cells();
  LiveScene2 live({});
  std::atomic<bool> is_over = false;
  std::vector<std::thread> threads;
  std::atomic<int> mixed = 0;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&] {
      std::uint64_t before = 0;
      while (!is_over) {
        const auto state = live.state();
        if (state->version < before) ++mixed;
        before = state->version;
        // The light of a state is of its scene.
        if (state->light && state->prepared->scene.edges != state->scene->edges) ++mixed;
        live.is_done();
        live.wait(1e-4);
      }
    });
  Scene2 last = scene;
  for (int k = 1; k <= 40; ++k) {
    last = with_vertex(scene, {2, 1}, {2, 1 + Rational(k) / 100});
    EXPECT_EQ(live.set(shared(last), k % 3 == 0 ? LiveDepth2::kCoarse : LiveDepth2::kFull),
              static_cast<std::uint64_t>(k));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(live.wait(kPatience));
  is_over = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(mixed, 0);
  expect_fresh(*live.state(), last);
}

// What is shown beside the light.

TEST(SceneViewsThread, AreOfTheLastSceneAndTheLastRequestAtRest) {
  std::atomic<int> changes = 0;
  SceneViews2 views({}, [&] { ++changes; });
  EXPECT_TRUE(views.is_at_rest());
  EXPECT_FALSE(views.collect());
  std::mt19937_64 random(3);
  const Scene2 scene = room_with_many_cells();
  for (int k = 0; k < 6; ++k) {
    Scene2 last = scene;
    ViewRequest2 request;
    for (std::uint64_t n = 0; n <= random() % 5; ++n) {
      last = with_vertex(scene, {2, 1}, {2, 1 + Rational(static_cast<long>(random() % 99)) / 200});
      views.set_scene(shared(last), n % 2 == 0 ? LiveDepth2::kFull : LiveDepth2::kCoarse);
      request = {.mode = k % 2 == 0 ? ViewMode2::kVisibility : ViewMode2::kCheck,
                 .mouse = Point2{Rational(static_cast<long>(random() % 9)) / 10 + Rational(1, 100), 2}};
      views.set_request(request);
      views.collect();
    }
    views.set_scene(shared(last), LiveDepth2::kFull);
    ASSERT_TRUE(views.wait(kPatience));
    EXPECT_TRUE(views.is_at_rest());
    EXPECT_TRUE(views.collect());  // wait() has kept that there was something
    EXPECT_FALSE(views.collect());
    expect_fresh(views.state(), last);
    EXPECT_EQ(views.lit().get(), &views.state());
    ASSERT_NE(views.result(), nullptr);
    EXPECT_EQ(views.result()->request, request);
    EXPECT_EQ(views.result()->version, views.state().version);
    EXPECT_EQ(views.result()->lines, compute_view(views.state(), request, [](auto, double) {}).lines);
  }
  EXPECT_GT(changes, 0);
}

TEST(SceneViewsThread, HaveTheTextureOfTheLightAndTheTone) {
  SceneViews2 views({}, [] {});
  views.set_scene(shared(small_room()), LiveDepth2::kFull);
  for (const std::uint32_t pixels : {1u, 3u, 2u})
    for (const Tone tone : {Tone::kLog, Tone::kLinear}) {
      views.set_tone({tone, 1.5}, pixels);
      ASSERT_TRUE(views.wait(kPatience));
      ASSERT_NE(views.texture(), nullptr);
      EXPECT_EQ(views.texture()->raster, light_texture_2(*views.lit(), {tone, 1.5}, pixels)) << pixels;
      EXPECT_EQ(views.texture()->raster.width, views.lit()->light->grid.grid.nx * pixels);
    }
}

TEST(SceneViewsThread, KeepTheLastLightOfAnInvalidScene) {
  SceneViews2 views({}, [] {});
  views.set_scene(shared(small_room()), LiveDepth2::kFull);
  ASSERT_TRUE(views.wait(kPatience));
  const auto lit = views.lit();
  const Raster texture = views.texture()->raster;
  views.set_scene(shared(parse_scene_2(bad_scenes()[0].text, "bad.json")), LiveDepth2::kFull);
  ASSERT_TRUE(views.wait(kPatience));
  EXPECT_NE(views.state().problem, "");
  EXPECT_EQ(views.lit(), lit);
  EXPECT_EQ(views.texture()->raster, texture);
}

TEST(SceneViewsThread, ForgetTheNumberOfAMouseThatHasGone) {
  SceneViews2 views({}, [] {});
  views.set_scene(shared(small_room()), LiveDepth2::kFull);
  views.set_request({.mouse = Point2{2, Rational(1, 2)}});
  ASSERT_TRUE(views.wait(kPatience));
  ASSERT_NE(views.result(), nullptr);
  EXPECT_NE(views.result()->number, "");
  views.set_request({});
  ASSERT_TRUE(views.wait(kPatience));
  EXPECT_EQ(views.result(), nullptr);
}

TEST(SceneViewsThread, EndAtAnyMoment) {
  std::mt19937_64 random(11);
  const Scene2 scene = room_with_many_cells();
  for (int k = 0; k < kHammer / 3; ++k) {
    SceneViews2 views({}, [] {});
    for (std::uint64_t n = 0; n <= random() % 4; ++n) {
      views.set_scene(shared(with_white(scene, Rational(static_cast<long>(random() % 9)) / 10)), LiveDepth2::kFull);
      views.set_request({.mode = static_cast<ViewMode2>(random() % kViewModes2),
                         .mouse = Point2{1, Rational(static_cast<long>(random() % 29)) / 10},
                         .face = face_name(scene, {0, false}),
                         .other = face_name(scene, {2, false})});
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 30000));
      views.collect();
      views.set_tone({Tone::kLog, 1 + static_cast<double>(n)}, 2);
    }
  }
}

// The part of the plane that is shown.

constexpr FrameSize kSize{900, 700};

TEST(Camera2, PlacesPixelsAsItsFrameDoes) {
  Camera2 camera;
  camera.fit(small_room(), kSize, 40, 60, 90);
  std::mt19937_64 random(5);
  for (int k = 0; k < 200; ++k) {
    camera.pan(static_cast<double>(random() % 100) - 50, static_cast<double>(random() % 100) - 50);
    camera.zoom({static_cast<double>(random() % 900), static_cast<double>(random() % 700)}, kSize,
                random() % 2 == 0 ? 1.3 : 0.7);
    const Pixel pixel{static_cast<double>(random() % 900), static_cast<double>(random() % 700)};
    const auto place = camera.place_of(pixel, kSize);
    const Pixel back = camera.at(place, kSize), framed = camera.frame(kSize).at(place);
    EXPECT_NEAR(back.x, pixel.x, 1e-6);
    EXPECT_NEAR(back.y, pixel.y, 1e-6);
    EXPECT_NEAR(framed.x, pixel.x, 1e-6);
    EXPECT_NEAR(framed.y, pixel.y, 1e-6);
    EXPECT_NEAR(camera.frame(kSize).pixels_per_length(), camera.pixels_per_length(), 1e-9 * camera.pixels_per_length());
  }
}

TEST(Camera2, ZoomLeavesThePlaceUnderThePixel) {
  Camera2 camera;
  camera.fit(small_room(), kSize, 40, 60, 90);
  for (const double factor : {1.2, 3.0, 0.1, 1e3}) {
    const Pixel fixed{123, 456};
    const auto before = camera.place_of(fixed, kSize);
    camera.zoom(fixed, kSize, factor);
    EXPECT_NEAR(camera.place_of(fixed, kSize)[0], before[0], 1e-9);
    EXPECT_NEAR(camera.place_of(fixed, kSize)[1], before[1], 1e-9);
  }
}

TEST(Camera2, StaysWithinTenThousandOfTheScaleThatFits) {
  Camera2 camera;
  camera.fit(small_room(), kSize, 40, 60, 90);
  const double fitted = camera.pixels_per_length();
  for (const double factor : {1e9, 0.0, std::numeric_limits<double>::infinity()}) {
    camera.zoom({1, 2}, kSize, factor);
    EXPECT_LE(camera.pixels_per_length(), 1.0001e4 * fitted);
    EXPECT_GE(camera.pixels_per_length(), 0.9999e-4 * fitted);
    const Frame2 frame = camera.frame(kSize);
    EXPECT_GT(frame.pixels_per_length(), 0);
  }
}

TEST(Camera2, PanMovesByThatManyPixels) {
  Camera2 camera;
  camera.fit(small_room(), kSize, 40, 60, 90);
  const Pixel before = camera.at({1, 2}, kSize);
  camera.pan(30, -7);
  EXPECT_NEAR(camera.at({1, 2}, kSize).x, before.x + 30, 1e-9);
  EXPECT_NEAR(camera.at({1, 2}, kSize).y, before.y - 7, 1e-9);
}

TEST(Camera2, FitShowsTheWholeSceneWithItsGrid) {
  Scene2 scene = small_room();
  scene.grids.front().max = {9, 4};
  for (const FrameSize size : {kSize, FrameSize{300, 900}, FrameSize{2000, 260}}) {
    Camera2 camera;
    camera.fit(scene, size, 40, 60, 90);
    const Pixel low = camera.at({0, 0}, size), high = camera.at({9, 4}, size);
    EXPECT_GE(low.x, 40 - 1e-9);
    EXPECT_LE(high.x, size.width - 40 + 1e-9);
    EXPECT_GE(high.y, 60 - 1e-9);
    EXPECT_LE(low.y, size.height - 90 + 1e-9);
    // As large as it can be: one of the two directions is full.
    EXPECT_TRUE(std::abs(high.x - low.x - (size.width - 80)) < 1e-6 ||
                std::abs(low.y - high.y - (size.height - 150)) < 1e-6);
  }
}

TEST(Camera2, FitsWhatHasNoExtent) {
  Camera2 camera;
  camera.fit({}, kSize, 40, 60, 90);
  EXPECT_EQ(camera.pixels_per_length(), 550);
  Scene2 point;
  point.materials = {{"m", {}, {}}};
  point.groups = {{"p"}};
  Surface surface;
  surface.name = "p";
  point.add(surface, {{3, 4}, {3, 4}});
  camera.fit(point, kSize, 40, 60, 90);
  EXPECT_EQ(camera.pixels_per_length(), 550);
  EXPECT_NEAR(camera.at({3, 4}, kSize).x, 450, 1e-9);
  EXPECT_NEAR(camera.at({3, 4}, kSize).y, 60 + 275, 1e-9);
  camera.fit(small_room(), {3, 2}, 40, 60, 90);  // no room at all
  EXPECT_GT(camera.frame({3, 2}).pixels_per_length(), 0);
}

// The file.

class SceneFileTest : public testing::Test {
 protected:
  std::filesystem::path path(const char* name) const { return folder_ / name; }
  void write(const char* name, const std::string& text) const { std::ofstream(path(name)) << text; }

 private:
  TemporaryFolder folder_;
};

TEST_F(SceneFileTest, GivesBackWhatIsWritten) {
  SceneFile2 file(path("room.json"));
  file.write(small_room());
  EXPECT_EQ(difference(file.read(), small_room()), "");
  EXPECT_EQ(file.news(), FileNews::kNone);
  file.write_as(path("other.json"), with_white(small_room(), Rational(1) / 3));
  EXPECT_EQ(file.path(), path("other.json"));
  EXPECT_EQ(file.read().materials[0].reflectivity.value[0], Rational(1) / 3);
  EXPECT_EQ(difference(read_scene_2(path("room.json")), small_room()), "");
}

TEST_F(SceneFileTest, TellsOnceThatSomeoneElseHasWrittenIt) {
  SceneFile2 file(path("room.json"));
  file.write(small_room());
  EXPECT_EQ(file.news(), FileNews::kNone);
  write("room.json", "something else");
  EXPECT_EQ(file.news(), FileNews::kChanged);
  EXPECT_EQ(file.news(), FileNews::kNone);
  EXPECT_THROW(file.read(), InputError);
}

TEST_F(SceneFileTest, RefusesASceneThatIsNoneAndLeavesTheFile) {
  SceneFile2 file(path("room.json"));
  file.write(small_room());
  const Scene2 bad = move_end(small_room(), 0, true, small_room().edges[0].from);
  EXPECT_THROW(file.write(bad), InputError);
  EXPECT_THROW(file.write_as(path("other.json"), bad), InputError);
  EXPECT_EQ(file.path(), path("room.json"));
  EXPECT_EQ(difference(file.read(), small_room()), "");
  EXPECT_FALSE(std::filesystem::exists(path("other.json")));
  EXPECT_THROW(file.write_as(path("no/such/folder.json"), small_room()), std::runtime_error);
  EXPECT_EQ(file.path(), path("room.json"));
}

}  // namespace
}  // namespace hottel::live_scene_test
