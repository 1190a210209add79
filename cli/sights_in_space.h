// hottel visibility --face, --graph and --events of scenes in space, and hottel factors --exact-form of them.
#pragma once

#include <string>
#include <vector>

#include "cli/scene_lines.h"
#include "cli/streams.h"
#include "io/files/output_file.h"

namespace hottel {

class Simulation3;

// Writes which faces some point of a face sees to standard output. Throws UnknownName where there is no such face,
// RequestError where nothing of it is free.
void write_face_sight(const std::string& name, bool is_json, const Simulation3& simulation, const Streams& streams);

// Writes the pairs of vertices that see each other, and says how many there are.
void write_graph_3(const SceneLines& lines, const Simulation3& simulation, const Streams& streams);

// A request of --events in space.
struct EventRequest3 {
  std::string scene, from, to, out;
  bool json = false, exact = false;
};

// Throws UsageError unless it names two faces, and a file that is a .csv, a .vtp or a picture, if any.
void require_sense(const EventRequest3& request);

// Writes the event surfaces between both faces by some of their lines, and says how many there are.
void write_events_3(const EventRequest3& request, const Simulation3& simulation, const Streams& streams);

// Writes `from,to,exchange,area`: of the two faces that are named, or of all pairs of faces with a closed form; says
// how many have none. Throws RequestError where the two have none, and says why.
void write_exact_forms_3(const std::vector<std::string>& names, const Simulation3& simulation, const Streams& streams,
                         OutputFile& out);

}  // namespace hottel
