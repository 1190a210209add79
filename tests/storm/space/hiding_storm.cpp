#include "tests/storm/space/hiding_storm.h"

#include <fmt/core.h>

#include "geometry/space/arrangement/merged_occluders.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/hiding/hiders.h"
#include "io/scene/scene_json.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/storm/crash_notice.h"
#include "tests/storm/space/matrix_law.h"
#include "tests/storm/space/shrink.h"

namespace hottel::storm {

namespace {

using Sights = std::array<bool, kHidingSights3>;

Sights sights_of(const HidingSubject3& subject) {
  Sights sights{};
  const auto note = [&](HidingSight3 sight, bool is_there) {
    bool& is_noted = sights[static_cast<std::size_t>(sight)];
    is_noted = is_noted || is_there;
  };
  const MergedOccluders3 merged(subject.scene().occluders());
  const Occluders3& occluders = merged.occluders();
  const Hiders3 hiders(occluders);
  const SurfaceBoxes3 boxes(occluders);
  for (const ConvexBody3& body : hiders.bodies().bodies())
    note(body.lid ? HidingSight3::kOpen : HidingSight3::kClosed, true);
  for (std::uint32_t s = 0; s < occluders.size(); ++s)
    note(HidingSight3::kLoose, hiders.bodies().body_of(s) == ConvexBody3::kNone);
  for (const HidingSubject3::Row& row : subject.rows()) {
    Patch3 i = row.patch;
    i.surface = merged.surface_of(0);
    const PlacedPatch3 placed = hiders.placed(i);
    for (const HidingSubject3::Target& target : row.targets) {
      const PairResult3& m = target.measure;
      note(HidingSight3::kSeen, m.measure != 0 && !m.is_whole);
      if (m.measure != 0) continue;
      Patch3 j = target.patch;
      if (!j.is_sky()) j.surface = merged.surface_of(j.surface);
      if (PairOccluders3(occluders, boxes, i, j).sight != PairVisibility3::kMixed) continue;
      note(HidingSight3::kHidden, hiders.hide(placed, hiders.placed(j)));
      note(HidingSight3::kNeverFirst, !j.is_sky() && hiders.is_never_first(placed, j.surface));
    }
  }
  return sights;
}

struct Hiding {
  using Law = HidingLaw3;
  using Subject = HidingSubject3;
  using Scene = Polygons3;
  using Result = HidingStormResult3;
  struct Made {
    Polygons3 scene;
  };

  static int lattice(std::uint64_t, const StormOptions&) { return CrashNotice::kHiding; }
  static Made make(std::uint64_t number, const StormOptions&) { return {hiding_scene_3(number)}; }
  static bool is_asked(const Law& law, const Subject& subject) {
    return !law.needs_matrix || subject.matrix().refusal.empty();
  }
  static void note(const Subject& subject, Result& result) {
    const Sights sights = sights_of(subject);
    for (std::size_t s = 0; s < kHidingSights3; ++s) result.sights[s] += sights[s] ? 1 : 0;
  }
  static void count(const Made& made, Result& result) { result.parts += made.scene.size(); }
  template <class Fails>
  static Scene shrunk(const Scene& scene, const Fails& fails) {
    return shrunk_3(scene, fails);
  }
};

}  // namespace

const char* to_string(HidingSight3 sight) {
  switch (sight) {
    case HidingSight3::kClosed:
      return "closed bodies";
    case HidingSight3::kOpen:
      return "open bodies";
    case HidingSight3::kLoose:
      return "surfaces of no body";
    case HidingSight3::kHidden:
      return "hidden by proof";
    case HidingSight3::kNeverFirst:
      return "never first";
    case HidingSight3::kSeen:
      return "seen in part";
  }
  return "";
}

void HidingStormResult3::add(const HidingStormResult3& other) {
  LawResult::add(other);
  for (std::size_t s = 0; s < kHidingSights3; ++s) sights[s] += other.sights[s];
}

HidingStormResult3 run_hiding_storm_3(const StormOptions& options, const std::vector<HidingLaw3>& which) {
  return run_laws<Hiding>(options, which);
}

std::string report(const HidingStormResult3& result, const std::vector<HidingLaw3>& which) {
  std::string text = result.text(names_of(which), "polygons");
  for (std::size_t s = 0; s < kHidingSights3; ++s)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<HidingSight3>(s)), result.sights[s]);
  for (const Failed<Polygons3>& failure : result.examples) {
    Scene3 scene = scene_of_polygons_3(failure.scene);
    scene.about = fmt::format("Scene {} of the storm of hiding: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_3(scene));
  }
  return text;
}

}  // namespace hottel::storm
