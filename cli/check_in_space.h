// hottel check in space.
#pragma once

#include <string>

#include "cli/command.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Tells what is found in a scene in space, on standard output. `fix`: where a repaired scene is written, empty:
// nowhere; then what was done is told, and what is found in that. Where it is the `file` of the scene and nothing was
// done, nothing is written; that, or that it was overwritten, is told. `distance`: how far points may be moved, 0: not
// at all.
ExitCode check_in_space(const ValidScene3& scene, const std::string& file, const std::string& fix,
                        const Rational& distance, bool as_json, const Streams& streams);

}  // namespace hottel
