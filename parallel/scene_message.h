// Scenes in messages: with what no scene file has.
#pragma once

#include <memory>
#include <string>
#include <string_view>
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

// The prepared scene of the last job: kept from one job to the next where the scene is the same.
template <class Prepared>
class KeptScene {
 public:
  // Returns prepare(reader) of the bytes of a scene, or what that returned for the same bytes before.
  template <class Prepare>
  std::shared_ptr<const Prepared> prepared(std::string_view bytes, const Prepare& prepare) {
    if (prepared_ == nullptr || bytes_ != bytes) {
      prepared_.reset();  // two do not have to fit into the memory
      MessageReader reader(bytes);
      prepared_ = std::make_shared<const Prepared>(prepare(reader));
      bytes_ = bytes;
    }
    return prepared_;
  }
  // That of the last call; null before.
  const std::shared_ptr<const Prepared>& last() const { return prepared_; }

 private:
  std::string bytes_;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace hottel
