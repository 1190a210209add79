// A storm of closed bodies, rooms and sheets on a lattice of space, each scene held against the laws.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/storm/law_run.h"
#include "tests/storm/space/solid_laws.h"

namespace hottel::storm {

// What there was in a scene: each counts it at most once.
//   kRefused: two materials claim one side; kShared: two polygons overlap; kCovered: a side, or a part of one, is
//   covered; kPartly: a part of a side, the rest not; kLost: a face with a material has no area left
enum class SolidSight3 { kRefused, kShared, kCovered, kPartly, kLost };
inline constexpr std::size_t kSolidSights3 = 5;
const char* to_string(SolidSight3 sight);

struct SolidStormResult3 : LawResult<SolidBodies3> {
  std::array<std::uint64_t, kSolidSights3> sights{};

  void add(const SolidStormResult3& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times.
SolidStormResult3 run_solid_storm_3(const StormOptions& options, const std::vector<SolidLaw3>& which = solid_laws_3());

// The result as text: counts, times, and each failure as a scene file.
std::string report(const SolidStormResult3& result, const std::vector<SolidLaw3>& which = solid_laws_3());

}  // namespace hottel::storm
