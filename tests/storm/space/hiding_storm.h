// A storm of convex bodies and sheets on a lattice of space, each scene held against the laws.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/storm/law_run.h"
#include "tests/storm/space/hiding_laws.h"

namespace hottel::storm {

// What there was in a scene: each counts it at most once.
//   kClosed: a body without a lid; kOpen: with one; kLoose: a surface of none; kHidden: two patches that face each
//   other are hidden by what is proven of bodies, and by no surface alone; kNeverFirst: a surface before polygon 0 is
//   never first from it; kSeen: patches see each other in part
enum class HidingSight3 { kClosed, kOpen, kLoose, kHidden, kNeverFirst, kSeen };
inline constexpr std::size_t kHidingSights3 = 6;
const char* to_string(HidingSight3 sight);

struct HidingStormResult3 : LawResult<Polygons3> {
  std::array<std::uint64_t, kHidingSights3> sights{};

  void add(const HidingStormResult3& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times.
HidingStormResult3 run_hiding_storm_3(const StormOptions& options,
                                      const std::vector<HidingLaw3>& which = hiding_laws_3());

// The result as text: counts, times, and each failure as a scene file.
std::string report(const HidingStormResult3& result, const std::vector<HidingLaw3>& which = hiding_laws_3());

}  // namespace hottel::storm
