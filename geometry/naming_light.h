// Failures that name the light which they are about.
#pragma once

#include <string>

#include "geometry/light.h"
#include "geometry/name.h"
#include "geometry/scene_table.h"
#include "kernel/support/failure.h"

namespace hottel {

// Calls f, and puts file, line and light before what a RequestError of it says.
template <class F>
auto naming_light(const SceneTable& scene, const Light& light, const F& f) {
  try {
    return f();
  } catch (const RequestError& error) {
    const std::string place = scene.file.empty() ? "" : FileLine{scene.file, light.line}.text() + ": ";
    throw RequestError(place + "light " + quoted_name(light.name) + ": " + error.what());
  }
}

}  // namespace hottel
