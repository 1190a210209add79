// What can be wrong with a matrix of view factors.
#pragma once

namespace hottel {

// What can be wrong with many pairs at once: each is a mistake in a program, or another convention (hypotheses.h and
// scene_hypotheses.h say what each means for a pair). In this order of preference, where two explain equally many.
enum class Fault {
  kTransposed,       // F(j, i) stands for F(i, j); the same as divided by the area of the other face
  kConstantFactor,   // pi, 2, 1/2, ...
  kRowFactor,        // one ratio a row: rows normalised, areas exchanged, A F instead of F
  kReversed,         // the front of a face taken for its back
  kPermuted,         // faces in another order
  kShifted,          // rows, columns or both at the places of the next ones
  kRowsPermuted,     // rows in another order, columns as they should be
  kColumnsPermuted,  // columns in another order
  kNoOcclusion,      // the factor without any obstacle
  kAllOrNothing,     // 0 or the factor without obstacles, where a part is hidden
  kSkyMissing,       // nothing goes to the sky
  kSkyIsRest,        // the sky gets what the (wrong) row lacks of 1
  kMissing,          // 0
  kMethod,           // what an approximate method of hottel gives
  kBehind,           // light between faces that do not face each other
  kSamplingNoise,    // the scatter of rays, which may lean
  kAreas,            // a factor of areas too many or too few, one for each pair
  kEmission          // rays that leave by another law than the cosine
};

}  // namespace hottel
