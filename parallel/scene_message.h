// Scenes in messages: with what no scene file has.
#pragma once

#include <variant>

#include "geometry/plane/scene/scene.h"
#include "geometry/space/scene/scene.h"
#include "io/scene/scene_json.h"
#include "parallel/message.h"

namespace hottel {

// Writes a scene, with the trees below its elements. read_scene_message() gives the same one, exactly.
void put_scene(const Scene2& scene, MessageWriter& writer);
void put_scene(const Scene3& scene, MessageWriter& writer);
Scene take_scene(MessageReader& reader);

}  // namespace hottel
