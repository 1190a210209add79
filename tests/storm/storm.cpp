#include "tests/storm/storm.h"

#include <fmt/core.h>

#include "io/scene/scene_json.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/storm/plane/shrink.h"

namespace hottel::storm {

namespace {

struct Plane {
  using Law = storm::Law;
  using Subject = storm::Subject;
  using Scene = Edges;
  using Result = StormResult;
  struct Made {
    LatticeScene lattice;
    const Edges& scene = lattice.edges;
  };

  static int lattice(std::uint64_t number, const StormOptions& options) {
    return options.k > 0 ? options.k : 2 + static_cast<int>(number % 5);
  }
  static Made make(std::uint64_t number, const StormOptions& options) {
    return {lattice_scene(number, lattice(number, options))};
  }
  static bool is_asked(const Law&, const Subject&) { return true; }
  static void note(const Subject&, Result&) {}
  static void count(const Made& made, Result& result) {
    result.parts += made.scene.size();
    count_contacts(made.lattice.lattice, result.contacts);
    count_solids(made.lattice, result.contacts);
  }
  template <class Fails>
  static Scene shrunk(const Scene& scene, const Fails& fails) {
    return storm::shrunk(scene, fails);
  }
};

}  // namespace

void StormResult::add(const StormResult& other) {
  LawResult::add(other);
  for (std::size_t c = 0; c < kContactKinds; ++c) contacts[c] += other.contacts[c];
}

StormResult run_storm(const StormOptions& options, const std::vector<Law>& which) {
  return run_laws<Plane>(options, which);
}

std::string report(const StormResult& result, const std::vector<Law>& which) {
  std::string text = result.text(names_of(which), "edges");
  for (std::size_t c = 0; c < kContactKinds; ++c)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<Contact>(c)), result.contacts[c]);
  for (const Failed<Edges>& failure : result.examples) {
    Scene2 scene = oracle::to_scene(failure.scene);
    scene.about = fmt::format("Scene {} of the storm: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_2(scene));
  }
  return text;
}

}  // namespace hottel::storm
