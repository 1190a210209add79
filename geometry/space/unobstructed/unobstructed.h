// The direct exchange area of two patches with nothing between them.
#pragma once

#include <array>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/unobstructed/pair_result.h"
#include "kernel/enclosure.h"

namespace hottel {

// The unobstructed direct exchange area S0 of two patches, in squares of the doubles of Vertices3 (integer form times
// 2^-shift).
struct UnobstructedMeasure3 {
  double measure = 0;
  double error = 0;           // |measure - S0| <= error: proven
  Enclosure bounds{0, 0};     // of S0: proven, from 0 to the smaller area at most
  bool has_converged = true;  // else error is above what was asked for
};

// Returns the measure of two patches that see each other without anything between them.
//
//   (1) of each patch only what is in front of the other one counts; measure and bounds are 0 exactly iff one of them
//       has no part in front of the other
//   (2) symmetric bit for bit; independent of translation and, but for the unit, of scale by powers of two
//   (3) error <= tolerance * min(A_i, A_j) where has_converged
//   (4) kUsual leaves out the last way to measure, in numbers of 320 bits: then needles a million times as long as wide
//       may not converge
//
// With kAll the error is some 1e-14 of the smaller area for every pair, touching or not, even for needles 2^250 times
// as long as wide. For patches that are small against their distance it is some 1e-14 of S0, or tolerance^2 of S0 where
// that is more, so that loose tolerances cost less. "Proven" assumes that log and atan2 of the library are within 4
// units of the last place.
//
// REQUIRES tolerance > 0; areas within the range of doubles. COST: 3 to 30 microseconds; up to some hundreds where
// edges almost touch, and where more digits are asked for than doubles have; some tens of milliseconds for needles.
// SEE: docs/design/space/unobstructed.md.
UnobstructedMeasure3 unobstructed_measure(const Vertices3& vertices, const Patch3& i, const Patch3& j, double tolerance,
                                          Effort3 effort = Effort3::kAll);
// The same where the areas of both, by patch_area(), are known.
UnobstructedMeasure3 unobstructed_measure(const Vertices3& vertices, const Patch3& i, const Patch3& j,
                                          const std::array<Enclosure, 2>& areas, double tolerance, Effort3 effort);

// Returns A, the area of a patch, with proven bounds, at most 2^-47 of it apart, in the same unit. Bounds are positive.
// COST: a microsecond.
Enclosure patch_area(const Vertices3& vertices, const Patch3& patch);

}  // namespace hottel
