// hottel visibility --events and --graph: lines of a whole scene in the plane, as csv or JSON.
#pragma once

#include <string>

#include "cli/streams.h"

namespace hottel {

struct PreparedScene2;

// What is asked of either: the name of the scene for messages, and where the lines go.
struct SceneLines {
  std::string scene, out;
  bool json = false, exact = false;
};

// Throws UsageError for options that exclude each other, and for files that are no csv. what: "critical lines are".
void require_sense(const SceneLines& lines, const std::string& what);

// Writes the critical lines of a scene.
void write_events(const SceneLines& lines, const PreparedScene2& prepared, const Streams& streams);

// Writes the pairs of vertices that see each other, as they are found, and says how many there are.
void write_graph(const SceneLines& lines, const PreparedScene2& prepared, const Streams& streams);

}  // namespace hottel
