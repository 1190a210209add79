#include "tests/storm/plane/repair_laws.h"

#include <fmt/core.h>

#include <map>
#include <memory>
#include <random>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/check/chosen_repair.h"
#include "solver/plane/check/scene_repair.h"
#include "tests/comparison/plane/engine_comparison.h"

namespace hottel::storm {

namespace {

std::shared_ptr<const SceneCheck2> check_of(const Scene2& scene) {
  const auto prepared = [&] { return std::make_shared<const PreparedScene2>(prepare(scene)); };
  return std::make_shared<const SceneCheck2>(check_scene(
      scene, {.prepared = prepared,
              .factors = [&] { return std::make_shared<const ExchangeMatrix>(exact_exchange(*prepared())); }}));
}

std::string counts_text(const Findings2& findings) {
  std::map<std::string, int> counts;
  for (const Finding2& finding : findings) ++counts[finding.kind];
  std::string text;
  for (const auto& [kind, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  return text;
}

// A third of the ends off the lattice by up to the distance along both axes, or somewhat more.
Edges nudged(Edges edges, const mpq_class& distance, std::mt19937_64& random) {
  const auto nudge = [&](mpq_class& x) {
    mpq_class step(static_cast<long>(random() % 9) - 4, 4);
    step.canonicalize();
    x += step * distance;
  };
  for (oracle::InputSegment& edge : edges) {
    if (edge.group != oracle::kAlone) continue;  // a polyline stays one
    if (random() % 3 == 0) nudge(edge.ax), nudge(edge.ay);
    if (random() % 3 == 0) nudge(edge.bx), nudge(edge.by);
  }
  return edges;
}

}  // namespace

std::string repair_is_broken(const Subject& subject) {
  std::mt19937_64 random(subject.chance());
  mpq_class distance = random() % 4 == 0 ? mpq_class(1, 2) : mpq_class(1);
  for (std::uint64_t k = random() % 8; k > 0; --k) distance /= 10;
  const Edges edges = random() % 4 == 0 ? subject.edges() : nudged(subject.edges(), distance, random);
  Scene2 scene;
  std::shared_ptr<const SceneCheck2> before;
  try {
    scene = parse_scene_2(write_scene_2(oracle::to_scene(edges)), "storm");
    before = check_of(scene);
  } catch (const InputError&) {
    return "";  // nudged, it says "behind" where nothing is, or an end came to the other one
  }
  std::string text;
  Scene2 once;
  std::shared_ptr<const SceneCheck2> after;
  const auto look = [&](const Scene2& some) {
    text = write_scene_2(some);
    once = parse_scene_2(text, "storm");
    return after = check_of(once);
  };
  repair_scene(scene, distance, *before, {check_of, look});
  std::string wrong;
  const auto told = [&] { return fmt::format("within {}: ", distance.get_str()); };
  if (is_worse(*after, *before))
    wrong += told() + fmt::format("{}; before: {}\n", counts_text(after->findings), counts_text(before->findings));
  const std::string first = text;
  const auto then = after;
  const Repair2 again = repair_scene(Scene2(once), distance, *then, {check_of, look});
  for (const RepairStep& step : again.steps)
    if (step.kind != "not-repaired") wrong += told() + fmt::format("again {}: {}\n", step.kind, step.message);
  if (text != first) wrong += told() + "another scene the second time\n";
  return wrong;
}

}  // namespace hottel::storm
