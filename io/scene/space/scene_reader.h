// The part of the scene reader that knows space: polygons, meshes, cameras.
#pragma once

#include <string>

#include "geometry/space/scene/triangulator.h"
#include "io/files/text_file.h"
#include "io/scene/exact_json.h"
#include "io/scene/passed_over.h"

namespace hottel {

// Returns the scene of a document of dimension 3, as read_scene says. Files of meshes are found relative to the folder
// of the document. A triangulator cuts polygons that are not plane;
// what is passed over in meshes is counted. Throws InputError.
ValidScene3 read_document_3(const JsonValue& root, const std::string& name_for_messages, const TextSource& files,
                            Triangulator3* triangulator = nullptr, PassedOver* passed_over = nullptr);

}  // namespace hottel
