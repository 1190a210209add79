// Notes and refusals of scenes whose unit of length is unknown.
#pragma once

#include <string>
#include <vector>

#include "cli/streams.h"
#include "io/scene/scene_json.h"

namespace hottel {

// Where the unit is unknown, writes a note: what areas are in, and that no number is in W (unknown_unit_note_2,
// unknown_unit_note_3).
void note_unknown_unit(const ValidScene& scene, const Streams& streams);
// The notes of a report, with what note_unknown_unit() says before them.
std::vector<std::string> with_unit_note(const Scene2& scene, std::vector<std::string> notes);
std::vector<std::string> with_unit_note(const Scene3& scene, std::vector<std::string> notes);

// Throws RequestError, naming the file, where the scene has lamps whose light cannot be told in W/m²
// (require_told_lamps): before any work.
void require_light_in_watts(const ValidScene& scene);

}  // namespace hottel
