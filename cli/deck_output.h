// Scenes written as decks for View3D, for hottel convert.
#pragma once

#include <string>

#include "cli/scene_input.h"
#include "cli/streams.h"

namespace hottel {

// Reads the scene of a file, in space, and writes it to a deck, combined per "face" or "group"; empty: a deck per
// group, anything else per face. Remarks tell what the deck does not say. Throws InputError for a scene in the plane.
void write_deck(const std::string& in, const PolygonOptions& polygons, const std::string& out, const std::string& per,
                const Streams& streams);

}  // namespace hottel
