#include "tests/storm/space/solid_storm.h"

#include <fmt/core.h>

#include "io/scene/scene_json.h"
#include "tests/storm/crash_notice.h"

namespace hottel::storm {

namespace {

std::array<bool, kSolidSights3> sights_of(const SolidSubject3& subject) {
  std::array<bool, kSolidSights3> sights{};
  const auto note = [&](SolidSight3 sight, bool is_seen) {
    sights[static_cast<std::size_t>(sight)] = sights[static_cast<std::size_t>(sight)] || is_seen;
  };
  note(SolidSight3::kRefused, !subject.refusal().empty());
  if (!subject.refusal().empty()) return sights;
  const Arrangement3& arrangement = subject.prepared().arrangement();
  for (const Piece3& piece : arrangement.pieces())
    for (const Piece3::Side& side : piece.sides) {
      note(SolidSight3::kCovered, side.cover != Piece3::Cover::kFree);
      note(SolidSight3::kPartly, side.cover == Piece3::Cover::kPartly);
      note(SolidSight3::kShared, side.owner.surface != piece.surface);
    }
  for (const Element& element : subject.matrix().elements())
    note(SolidSight3::kLost, element.material.has_value() && element.area.value == 0);
  return sights;
}

struct Solids {
  using Law = SolidLaw3;
  using Subject = SolidSubject3;
  using Scene = SolidBodies3;
  using Result = SolidStormResult3;
  struct Made {
    SolidBodies3 scene;
  };

  static int lattice(std::uint64_t, const StormOptions&) { return CrashNotice::kSolids; }
  static Made make(std::uint64_t number, const StormOptions&) { return {solid_bodies_3(number)}; }
  static bool is_asked(const Law& law, const Subject& subject) {
    return subject.refusal().empty() || law.takes_refused;
  }
  static void note(const Subject& subject, Result& result) {
    const auto sights = sights_of(subject);
    for (std::size_t s = 0; s < kSolidSights3; ++s) result.sights[s] += sights[s] ? 1 : 0;
  }
  static void count(const Made& made, Result& result) {
    for (const SolidBody3& body : made.scene) result.parts += body.faces.size();
  }
  template <class Fails>
  static Scene shrunk(const Scene& scene, const Fails& fails) {
    return shrunk_3(scene, fails);
  }
};

}  // namespace

const char* to_string(SolidSight3 sight) {
  switch (sight) {
    case SolidSight3::kRefused:
      return "two materials";
    case SolidSight3::kShared:
      return "sides of several";
    case SolidSight3::kCovered:
      return "covered";
    case SolidSight3::kPartly:
      return "partly covered";
    case SolidSight3::kLost:
      return "faces with nothing left";
  }
  return "";
}

void SolidStormResult3::add(const SolidStormResult3& other) {
  LawResult::add(other);
  for (std::size_t s = 0; s < kSolidSights3; ++s) sights[s] += other.sights[s];
}

SolidStormResult3 run_solid_storm_3(const StormOptions& options, const std::vector<SolidLaw3>& which) {
  return run_laws<Solids>(options, which);
}

std::string report(const SolidStormResult3& result, const std::vector<SolidLaw3>& which) {
  std::string text = result.text(names_of(which), "polygons");
  for (std::size_t s = 0; s < kSolidSights3; ++s)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<SolidSight3>(s)), result.sights[s]);
  for (const Failed<SolidBodies3>& failure : result.examples) {
    Scene3 scene = to_scene_3(failure.scene);
    scene.about = fmt::format("Scene {} of the storm of solids: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_3(scene));
  }
  return text;
}

}  // namespace hottel::storm
