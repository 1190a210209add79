// What a frame costs where lights move: two beams that turn, elements divided where they end, three channels,
// radiosities with proven bounds.
//
// `room384` is a room of 6 sides and 2 boxes with 384 elements (faces of 8 x 8 and 4 x 4) and two spots that turn in
// opposite senses; `apartment` the apartment of 388 edges with two. Turns take 24 frames. `first_turn` are its frames,
// factors of new elements among them; `later` those of the next turn, when the lights stand where they stood before:
// elements found, right sides, solutions, bounds. `between` are frames of the next turn half a frame later, where no
// light stood before. No picture is made. `level0` divides nothing: then no factor is computed after the first frame.
#include "solver/animation.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/space_scenes.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/space/scene/moving_lights.h"
#include "io/scene/scene_json.h"
#include "kernel/support/memory.h"
#include "solver/memory_store.h"
#include "solver/plane/light/refinement.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/light/refinement.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::benchmarks {
namespace {

constexpr int kFramesOfATurn = 24;
struct Nothing {
  static std::uint64_t bytes() { return 0; }
};

Light spot(const char* name, int focus, const std::array<int, 3>& power) {
  Light light;
  light.name = name;
  light.type = LightType::kSpot;
  light.focus = focus;
  light.falloff = 1;
  light.power = {{power[0], power[1], power[2]}, false};
  return light;
}

Scene3 room384() {
  SceneMaker3 maker;
  maker.add_room({6, 4, 3}, 7);
  maker.add_box({{2, 2, ratio(1, 2)}, {1, 1, 1}}, 3);
  maker.add_box({{4, 1, ratio(3, 4)}, {1, 1, ratio(3, 2)}, {5, 0, 0, 1}}, 3);
  Scene3 scene = maker.take();
  scene.add_light(spot("left", 25, {12, 11, 9}), {{2, 1, ratio(14, 5)}, {ratio(3, 5), 0, -1}, {0, 0, 15}, {}});
  scene.add_light(spot("right", 20, {6, 7, 11}), {{4, 3, ratio(14, 5)}, {ratio(-1, 2), ratio(1, 3), -1}, {0, 0, -15}});
  return scene;
}

Scene2 apartment() {
  Scene2 scene = read_scene_2("scenes/showcase/apartment.json");
  LightPlace2 first{{ratio(31, 10), ratio(27, 10)}, {1, 0}}, second{{ratio(73, 10), ratio(34, 10)}, {0, 1}};
  first.rotation = 15;
  second.rotation = -15;
  scene.add_light(spot("first", 25, {12, 11, 9}), first);
  scene.add_light(spot("second", 20, {6, 7, 11}), second);
  return scene;
}

// Frames of a first turn, of the next one, or of the next one half a frame later.
enum class Turn { kFirst, kLater, kBetween };

template <class Simulation>
void animate(benchmark::State& state, const Simulation& still, int levels, Turn turn,
             const std::shared_ptr<FactorStore>& store) {
  for (auto _ : state) {
    Animation<Simulation, Nothing> animation(still, {.everywhere = 0, .at_borders = levels}, memory_allowed() / 4,
                                             store);
    std::vector<double> seconds;
    std::uint64_t elements = 0, computed = 0;
    for (int k = 0; k < (turn == Turn::kFirst ? 1 : 2) * kFramesOfATurn; ++k) {
      const bool is_second = k >= kFramesOfATurn;
      const Rational late = turn == Turn::kBetween && is_second ? ratio(1, 2) : Rational(0);
      const FrameCounts counts = animation.at(Rational(k) + late).counts;
      if (turn != Turn::kFirst && !is_second) continue;
      seconds.push_back(counts.seconds);
      elements = std::max(elements, counts.elements);
      computed += counts.computed;
    }
    std::ranges::sort(seconds);
    state.SetIterationTime(seconds[seconds.size() / 2]);
    state.counters["ms_median"] = 1e3 * seconds[seconds.size() / 2];
    state.counters["ms_most"] = 1e3 * seconds.back();
    state.counters["elements"] = static_cast<double>(elements);
    state.counters["pairs_computed"] = static_cast<double>(computed);
  }
}

void space(benchmark::State& state, int levels, Turn turn) {
  const auto store = make_memory_store();
  SimulationRequest3 request;
  request.factors.granularity = Granularity::kElement;
  request.factors.tolerance = 1e-6;
  request.factors.store = store;
  request.system.serves_many = true;
  animate(state, Simulation3(room384(), request), levels, turn, store);
}

void plane(benchmark::State& state, int levels, Turn turn) {
  animate(state, Simulation2(apartment()), levels, turn, nullptr);
}

// One turn says enough: its median is over frames.
void add_once(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const Turn turn : {Turn::kFirst, Turn::kLater, Turn::kBetween}) {
    const std::string end = turn == Turn::kFirst ? "/first_turn" : turn == Turn::kLater ? "/later" : "/between";
    for (const int levels : {0, 4})
      add_once("apartment/level" + std::to_string(levels) + end,
               [=](benchmark::State& state) { plane(state, levels, turn); });
    for (const int levels : {0, 1})
      add_once("room384/level" + std::to_string(levels) + end,
               [=](benchmark::State& state) { space(state, levels, turn); });
  }
  return run(argc, argv);
}
