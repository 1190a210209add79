// hottel visibility in the plane: what a point sees, and a point of a face, and two faces of each other.
#pragma once

#include <string>

#include "cli/shown_answer.h"
#include "cli/streams.h"

namespace hottel {

class Simulation2;

// --at X,Y, or --on NAME --at T, or --from A --to B, as they were given; what is empty was not.
struct SightRequest2 {
  std::string at, on, from, to;
  bool has_no_irradiance = false;  // at a point, so that the scene needs no solution
  bool is_drawn = false;
};

// Throws UsageError for what makes no sense; UnknownName for unknown faces; RequestError where it is drawn
// and cannot be. REQUIRES a simulation by faces, which outlives the answer.
ShownAnswer visibility_in_plane(const SightRequest2& asked, const Simulation2& simulation, const Streams& streams);

}  // namespace hottel
