// The part of the scene reader that knows the plane: edges, polylines, grids.
#pragma once

#include <string>

#include "geometry/plane/scene/scene.h"
#include "io/scene/exact_json.h"

namespace hottel {

// Returns the scene of a document of dimension 2, as read_scene says. Throws InputError.
ValidScene2 read_document_2(const JsonValue& root, const std::string& name_for_messages);

}  // namespace hottel
