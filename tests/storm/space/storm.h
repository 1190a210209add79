// A storm of lattice scenes of space, each held against the laws of a pair.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/storm/law_run.h"
#include "tests/storm/space/contacts.h"
#include "tests/storm/space/lattice_scene.h"
#include "tests/storm/space/laws.h"

namespace hottel::storm {

// How the pairs of the scenes are settled where it is not asked first what hides all of them.
enum class Settled3 { kHidden, kClear, kHiddenAlongEdges, kWholeAlongEdges, kMixed };
inline constexpr std::size_t kSettledKinds3 = 5;
const char* to_string(Settled3 settled);

struct StormResult3 : LawResult<Polygons3> {
  ContactCounts3 contacts{};
  std::array<std::uint64_t, kSettledKinds3> settled{};

  void add(const StormResult3& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times.
StormResult3 run_storm_3(const StormOptions& options, const std::vector<Law3>& which = laws_3());

// The result as text: counts, times, contacts, and each failure as a scene file with the pair first.
std::string report(const StormResult3& result, const std::vector<Law3>& which = laws_3());

}  // namespace hottel::storm
