// visibility --points of points with normals: the light on a small area at each, in the plane and in space.
#pragma once

#include <string>
#include <string_view>

#include "cli/scene_input.h"
#include "cli/streams.h"
#include "io/scene/scene_json.h"

namespace hottel {

// The points: the text of a csv that names normals (names_normals), and what messages call it; and where the answer
// goes.
struct OrientedPointsInput {
  std::string text, name;
  std::string scene;  // its file, for messages
  std::string out;    // empty or "-": standard output
};

// Solves the scene, with its elements, and writes a csv with a line for each point (OrientedLightCsv). Tells how many
// points have no light. Throws UsageError where the file is no csv, and what reading points and solving throw.
void write_oriented_light(const OrientedPointsInput& input, ValidScene scene, Streams& streams);

}  // namespace hottel
