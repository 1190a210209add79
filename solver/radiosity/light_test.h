// How it is decided which elements the light of a point light or a beam reaches.
#pragma once

#include <optional>
#include <string_view>

namespace hottel {

// kExact: what the light sees, cut at borders of beams and shadows: shares within proven bounds.
// The others look at a few points of each element, as old programs do, and cut nothing: estimates, to compare with.
// With G = I0 cos^n t cos u / r^(d-1) at the centroid, u the angle between its normal and the way to the light, d the
// dimension:
//   kCentroid  Phi = A G where the centroid is in the beam and seen, else 0
//   kVertices  Phi = A G times the vertices that are in the beam and seen over all of them; G whether or not the
//              centroid is in the beam, but 0 where n > 0 and t is beyond 90 degrees
// On the border of the beam is in it; what is in the beam and what is seen is decided exactly. Behind an element, and
// in its plane, Phi = 0.
enum class LightTest : unsigned char { kExact, kCentroid, kVertices };

// The word for it: "exact", "centroid", "vertices".
const char* to_string(LightTest test);
// The test of a word; nothing for other words.
std::optional<LightTest> light_test(std::string_view word);

}  // namespace hottel
