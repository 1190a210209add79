// Scenes in messages: with what no scene file has.
#pragma once

#include <variant>

#include "geometry/plane/scene/scene.h"
#include "geometry/space/scene/scene.h"
#include "io/scene/scene_json.h"
#include "parallel/message.h"

namespace hottel {

// Writes what view factors depend on of a scene, with the trees below its elements: a scene whose lights move stays the
// same one. take_scene() gives just that.
void put_scene(Scene2 scene, MessageWriter& writer);
void put_scene(Scene3 scene, MessageWriter& writer);
Scene take_scene(MessageReader& reader);

}  // namespace hottel
