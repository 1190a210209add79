#include "tests/storm/space/storm.h"

#include <fmt/core.h>

#include <utility>

#include "io/scene/scene_json.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/storm/space/shrink.h"

namespace hottel::storm {

namespace {

Settled3 settled(const PairResult3& m) {
  if (m.sight == PairVisibility3::kHidden) return Settled3::kHidden;
  if (m.sight == PairVisibility3::kClear) return Settled3::kClear;
  if (m.measure == 0) return Settled3::kHiddenAlongEdges;
  return m.is_whole ? Settled3::kWholeAlongEdges : Settled3::kMixed;
}

struct Pairs {
  using Law = Law3;
  using Subject = Subject3;
  using Scene = Polygons3;
  using Result = StormResult3;
  struct Made {
    Polygons3 scene;
  };

  static int lattice(std::uint64_t, const StormOptions&) { return 0; }
  static Made make(std::uint64_t number, const StormOptions&) { return {lattice_scene_3(number).polygons}; }
  static bool is_asked(const Law&, const Subject&) { return true; }
  static void note(const Subject& subject, Result& result) {
    PairRequest3 walked;
    walked.tolerance = subject.tolerance(subject.area());
    walked.asks_hiders = false;
    const Settled3 kind = settled(subject.scene().measure(subject.i(), subject.j(), walked));
    ++result.settled[static_cast<std::size_t>(kind)];
  }
  static void count(const Made& made, Result& result) {
    result.parts += made.scene.size();
    count_contacts_3(made.scene, result.contacts);
  }
  template <class Fails>
  static Scene shrunk(const Scene& scene, const Fails& fails) {
    return shrunk_3(scene, fails);
  }
};

// The polygons as a scene that can be run; polygons 0 and 1 are the pair.
Scene3 to_scene_3(const Polygons3& polygons) {
  Scene3 scene;
  scene.materials.emplace_back();
  scene.materials.back().name = "black";
  const std::vector<Polygon3> shapes = oracle::engine_polygons(polygons);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const std::string name = k == 0 ? "i" : k == 1 ? "j" : fmt::format("between {}", k - 1);
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(k);
    scene.groups.emplace_back(name);
    scene.add(std::move(surface), shapes[k]);
  }
  return scene;
}

}  // namespace

const char* to_string(Settled3 settled) {
  switch (settled) {
    case Settled3::kHidden:
      return "hidden at once";
    case Settled3::kClear:
      return "clear at once";
    case Settled3::kHiddenAlongEdges:
      return "hidden along edges";
    case Settled3::kWholeAlongEdges:
      return "whole along edges";
    case Settled3::kMixed:
      return "seen in part";
  }
  return "";
}

void StormResult3::add(const StormResult3& other) {
  LawResult::add(other);
  for (std::size_t c = 0; c < kContactKinds3; ++c) contacts[c] += other.contacts[c];
  for (std::size_t k = 0; k < kSettledKinds3; ++k) settled[k] += other.settled[k];
}

StormResult3 run_storm_3(const StormOptions& options, const std::vector<Law3>& which) {
  return run_laws<Pairs>(options, which);
}

std::string report(const StormResult3& result, const std::vector<Law3>& which) {
  std::string text = result.text(names_of(which), "polygons");
  for (std::size_t c = 0; c < kContactKinds3; ++c)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<Contact3>(c)), result.contacts[c]);
  for (std::size_t k = 0; k < kSettledKinds3; ++k)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<Settled3>(k)), result.settled[k]);
  for (const Failed<Polygons3>& failure : result.examples) {
    Scene3 scene = to_scene_3(failure.scene);
    scene.about = fmt::format("Scene {} of the storm in space: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_3(scene));
  }
  return text;
}

}  // namespace hottel::storm
