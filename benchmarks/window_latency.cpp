// What a hand waits for: from an event in the window of `hottel view` to the frame that shows its light.
//
// A viewer without a screen gets the events of a mouse and a keyboard, one at a time. Scenes: furnished
// rooms of 50 to 5,000 edges and clutter with long views, on a grid of 256 x 192 cells (coarse: 64 x 48), and the
// apartment on its own of 516 x 388. Edits:
//
//   emission, reflectivity   a key, over a face: its material gets a little more or less. What the cells see is kept
//   vertex, group            it is taken, dragged to a new place, to another one, and let go
//   press-in-light           a group is taken and dragged while light on the whole grid is made
//   press-in-rows            the same while what the cells see is put aside (LiveScene2 (5))
//
// The time of a case is the median from the event to the frame that shows light of the scene as it is then, on whatever
// grid: of a drag, from its second step. Counters, in ms, medians, `_p5` and `_p95` for what 5 and 95 of 100 stay under
// (on a busy machine `_p5` is what it would take on a quiet one):
//
//   edit      taking the event          state     from the event until light is there, but for the hand-over
//   texture   its colours               first     as the time, of the first step of a drag
//   full      from the event, or the release, to the frame with light on the whole grid
//   prepare, factors, radiosity, light    stages of `state`; the rest of it is checks, copies and threads
//   unlit     edits after which the scene had no light: they are not counted
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <thread>

#include "benchmarks/window_hands.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/methods/computed_factors.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/window/commands.h"

namespace hottel::benchmarks {
namespace {

constexpr double kHeldPixels = 200;  // at least, of what is dragged
constexpr double kRest = 0.15;       // seconds after which nothing runs any more, at least

enum class Edit { kEmission, kReflectivity, kVertex, kGroup, kPressInLight, kPressInRows };
constexpr std::array kEdits{"emission", "reflectivity", "vertex", "group", "press-in-light", "press-in-rows"};

// How much is done with a scene. One whose light takes seconds rests twice as long after each edit.
struct Amount {
  std::size_t edits;  // the first ones
  int samples;
};
constexpr Amount kAll{kEdits.size(), 40}, kOfLargeScenes{4, 12};

// Times of several kinds, in ms.
class Times {
 public:
  void add(const std::string& name, double seconds) { times_[name].push_back(1e3 * seconds); }
  // The least time that this share of all stay under, or reach; 0 where there are none.
  double share(const std::string& name, double fraction) {
    std::vector<double>& sorted = times_[name];
    std::sort(sorted.begin(), sorted.end());
    const double place = std::ceil(fraction * static_cast<double>(sorted.size())) - 1;
    return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(std::max(place, 0.0))];
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

double seconds_in(const std::map<std::string, double>& stages) {
  return std::accumulate(stages.begin(), stages.end(), 0.0, [](double sum, const auto& s) { return sum + s.second; });
}

Place2 middle(const Edge2& edge) {
  return {to_double(edge.from.x + edge.to.x) / 2, to_double(edge.from.y + edge.to.y) / 2};
}

Place2 start(const Edge2& edge) { return {to_double(edge.from.x), to_double(edge.from.y)}; }

std::vector<std::uint32_t> surfaces_of(const Scene2& scene, std::uint32_t group) {
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (scene.surfaces[s].group == group) surfaces.push_back(s);
  return surfaces;
}

// The longer and the shorter side of the box around a group.
std::pair<double, double> sides(const Scene2& scene, std::uint32_t group) {
  std::vector<double> x, y;
  for (const std::uint32_t s : surfaces_of(scene, group))
    for (const Point2* p : {&scene.edges[s].from, &scene.edges[s].to}) {
      x.push_back(to_double(p->x));
      y.push_back(to_double(p->y));
    }
  const auto extent = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
  };
  return {std::max(extent(x), extent(y)), std::min(extent(x), extent(y))};
}

// Whether a surface is of a piece of furniture that is not thin, or of a wall that stands alone: it can go anywhere.
bool is_movable(const Scene2& scene, std::uint32_t surface, double longest) {
  const std::uint32_t group = scene.surfaces[surface].group;
  const std::vector<std::uint32_t> all = surfaces_of(scene, group);
  const Edge2 &first = scene.edges[all.front()], &last = scene.edges[all.back()];
  const bool is_outline = all.size() > 2 && first.from == last.to;
  const bool is_alone = all.size() == 1 && std::ranges::none_of(scene.edges, [&](const Edge2& other) {
                          return other.to == first.from || other.from == first.to;
                        });
  const auto [longer, shorter] = sides(scene, group);
  return ((is_outline && shorter > longer / 2) || is_alone) && longer < longest;
}

// The surface nearest to the middle of the grid of which that is true.
template <class Wanted>
std::uint32_t nearest_to_middle(const Scene2& scene, const Grid2& grid, const Wanted& is_wanted) {
  const Edge2 diagonal{grid.min, grid.max};
  const Place2 centre = middle(diagonal);
  std::uint32_t nearest = 0;
  double least = HUGE_VAL;
  for (std::uint32_t s = 0; s < scene.edges.size(); ++s) {
    const Place2 at = middle(scene.edges[s]);
    const double distance = std::hypot(at[0] - centre[0], at[1] - centre[1]);
    if (distance < least && is_wanted(s)) {
      least = distance;
      nearest = s;
    }
  }
  return nearest;
}

// One case: an edit, again and again.
class Case {
 public:
  Case(const Room& room, Edit edit, int samples) : hands_(room), edit_(edit), samples_(samples) {
    choose();
    rest();
  }

  void run() {
    for (int k = 0; k < samples_; ++k) {
      if (edit_ == Edit::kEmission || edit_ == Edit::kReflectivity)
        change_material(k);
      else
        drag(k);
    }
  }
  Times& times() { return times_; }
  int unlit() const { return unlit_; }

 private:
  using Kind = WindowEvent::Kind;

  // What is edited: its edge, and the place at which it is taken. Zooms until that can be hit.
  void choose() {
    const Scene2& scene = hands_.scene();
    const Grid2& grid = hands_.state().simulation->grid();
    const bool wants_light = edit_ == Edit::kEmission;
    if (wants_light || edit_ == Edit::kReflectivity) {
      surface_ = nearest_to_middle(scene, grid, [&](std::uint32_t s) {
        return scene.materials[scene.surfaces[s].material].emission.is_zero() != wants_light;
      });
    } else {
      const double wide = to_double(grid.max.x - grid.min.x);
      surface_ = nearest_to_middle(scene, grid, [&](std::uint32_t s) { return is_movable(scene, s, wide / 4); });
    }
    const double length = sides(scene, scene.surfaces[surface_].group).first;
    const Pixel a = hands_.viewer().pixel_of({0, 0}), b = hands_.viewer().pixel_of({length, 0});
    home_ = held();
    if (b.x - a.x >= kHeldPixels) return;
    const Pixel at = hands_.viewer().pixel_of(home_);
    hands_.push(
        {.kind = Kind::kWheel, .x = at.x, .y = at.y, .wheel = std::log(kHeldPixels / (b.x - a.x)) / std::log(1.2)});
    hands_.take_events();
  }

  Place2 held() const {
    const Edge2& edge = hands_.scene().edges[surface_];
    return edit_ == Edit::kVertex ? start(edge) : middle(edge);
  }

  // Until nothing runs any more.
  void rest() {
    hands_.viewer().settle(kPatience);
    std::this_thread::sleep_for(std::chrono::duration<double>(std::max(kRest, 2 * hands_.state().seconds)));
    hands_.take_events();
  }

  // The pixel of the k-th of 24 places around home.
  Pixel around_home(int k) {
    const int place = k % 24 + (k % 24 >= 12 ? 1 : 0);
    const double step = std::pow(10, -decimals_at(pixels_per_length()));
    return hands_.viewer().pixel_of({home_[0] + (place % 5 - 2) * step, home_[1] + (place / 5 - 2) * step});
  }
  double pixels_per_length() { return hands_.viewer().pixel_of({1, 0}).x - hands_.viewer().pixel_of({0, 0}).x; }

  void change_material(int k) {
    const Edge2& edge = hands_.scene().edges[surface_];
    const Pixel a = hands_.viewer().pixel_of(start(edge)), b = hands_.viewer().pixel_of(middle(edge));
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    hands_.mouse(Kind::kMove, {b.x - 2 * (b.y - a.y) / length, b.y + 2 * (b.x - a.x) / length});  // at its front
    hands_.take_events();
    rest();
    const bool is_more = k % 2 == 0;
    hands_.push(key_event(edit_ == Edit::kEmission ? is_more ? "'" : ";" : is_more ? "]" : "["));
    if (!wait_for_light("frame")) return;
    if (const auto full = hands_.until_lit(LiveDepth2::kFull)) times_.add("full", *full);
  }

  void drag(int k) {
    const HeldKeys held{.ctrl = edit_ != Edit::kVertex};
    const bool is_press = edit_ == Edit::kPressInLight || edit_ == Edit::kPressInRows;
    if (is_press) {
      disturb(k);
    } else {
      rest();
    }
    press(held);
    hands_.mouse(Kind::kMove, around_home(2 * k + 1), held);
    if (!wait_for_light(is_press ? "frame" : "first") || is_press) return release();
    hands_.mouse(Kind::kMove, around_home(2 * k + 2), held);
    if (!wait_for_light("frame")) return release();
    release();
    if (const auto full = hands_.until_lit(LiveDepth2::kFull)) times_.add("full", *full);
  }

  void press(HeldKeys held_keys) {
    const Pixel at = hands_.viewer().pixel_of(held());
    hands_.mouse(Kind::kMove, at, held_keys);
    hands_.mouse(Kind::kPress, at, held_keys);
    hands_.take_events();
  }
  void release() {
    hands_.mouse(Kind::kRelease, hands_.viewer().pixel_of(held()), {});
    hands_.take_events();
  }

  // An edit, so that light on the whole grid is being made, or is there and its rows are.
  void disturb(int k) {
    rest();
    const HeldKeys ctrl{.ctrl = true};
    press(ctrl);
    hands_.mouse(Kind::kMove, around_home(2 * k), ctrl);
    hands_.until_lit(LiveDepth2::kCoarse);
    const double before = hands_.state().seconds;
    release();
    if (edit_ == Edit::kPressInRows) hands_.until_lit(LiveDepth2::kFull);
    std::this_thread::sleep_for(std::chrono::duration<double>(before));
  }

  // Waits for light of the last event, and notes its times; the time to the frame under a name of its own.
  bool wait_for_light(const std::string& name) {
    const auto frame = hands_.until_lit(LiveDepth2::kCoarse);
    if (!frame) {
      ++unlit_;
      return false;
    }
    const double edit = hands_.seconds_of_event();
    times_.add(name, *frame);
    if (name != "frame") return true;
    const LiveState2& state = hands_.state();
    times_.add("edit", edit);
    times_.add("state", edit + state.seconds);
    times_.add("prepare", state.prepared->seconds);
    times_.add("factors", seconds_in(state.factors->report.counts.seconds));
    times_.add("radiosity", seconds_in(state.radiosities->seconds));
    times_.add("light", state.light->seconds);
    Stopwatch watch;
    first_texture_2(state, hands_.viewer().views().tone());
    times_.add("texture", watch.lap());
    return true;
  }

  Hands hands_;
  Edit edit_;
  int samples_, unlit_ = 0;
  std::uint32_t surface_ = 0;
  Place2 home_{};
  Times times_;
};

void measure(benchmark::State& state, const Room& room, Edit edit, int samples) {
  for (auto _ : state) {
    Case edits(room, edit, samples);
    edits.run();
    Times& times = edits.times();
    state.SetIterationTime(1e-3 * times.share("frame", 0.5));
    for (const std::string name : {"frame", "full"}) {
      state.counters[name + "_p5"] = times.share(name, 0.05);
      state.counters[name + "_p95"] = times.share(name, 0.95);
    }
    for (const char* name : {"full", "state", "edit", "texture", "first", "prepare", "factors", "radiosity", "light"})
      state.counters[name] = times.share(name, 0.5);
    state.counters["unlit"] = edits.unlit();
  }
}

void add_room(const Room& room, const Amount& amount) {
  for (std::size_t edit = 0; edit < amount.edits; ++edit)
    benchmark::RegisterBenchmark(
        (room.name + "/" + kEdits[edit]).c_str(),
        [=](benchmark::State& state) { measure(state, room, static_cast<Edit>(edit), amount.samples); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  const Folder folder("window-latency");
  add_room(apartment(), kAll);
  for (const std::uint64_t edges : {50, 200, 1000, 2000}) add_room(room_of("room", furnished(edges), folder), kAll);
  add_room(room_of("room", furnished(5000), folder), kOfLargeScenes);
  add_room(room_of("clutter-long", clutter(View::kLong, 200), folder), kAll);
  add_room(room_of("clutter-long", clutter(View::kLong, 2000), folder), kOfLargeScenes);
  return run(argc, argv);
}
