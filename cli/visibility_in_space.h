// hottel visibility in space: what a point sees, and a point of a face.
#pragma once

#include <string>

#include "cli/command.h"

namespace hottel {

struct Scene3;

// What is asked of a scene in space: the texts of --at, --on and -o.
struct SpaceSightOptions {
  std::string at, on, out;
  bool json = false;
};

// Answers --at X,Y,Z, or --on NAME --at X,Y,Z, where the point lies on the face, or --on NAME --at S,T in the frame of
// its first point and its two sides there. Throws UsageError for what makes no sense, also a point that is not on the
// face.
ExitCode visibility_in_space(const Scene3& scene, const SpaceSightOptions& options, Streams& streams);

}  // namespace hottel
