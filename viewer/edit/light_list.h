// The list of a scene's lights under a hand, in either dimension: a scene goes in, another one comes out, without its
// expectations. Scene: a SceneTable with light_places. All throw ContractViolation for an index out of range.
#pragma once

#include <cstdint>
#include <utility>

#include "geometry/light.h"
#include "kernel/support/failure.h"
#include "viewer/edit/free_names.h"

namespace hottel {

// Where a light of such a scene is.
template <class Scene>
using LightPlaceOf = typename decltype(Scene::light_places)::value_type;

// Returns the scene, to be changed at a light.
template <class Scene>
Scene begin_light_edit(const Scene& scene, std::uint32_t light) {
  HOTTEL_REQUIRE(light < scene.lights.size() && scene.lights.size() == scene.light_places.size());
  Scene edited = scene;
  edited.expect.clear();
  return edited;
}

// Gives a light other values, and its axis another rotation [degrees a second].
template <class Scene>
Scene set_light(const Scene& scene, std::uint32_t light, const Light& values,
                const decltype(LightPlaceOf<Scene>::rotation)& rotation) {
  Scene edited = begin_light_edit(scene, light);
  edited.lights[light] = values;
  edited.light_places[light].rotation = rotation;
  return edited;
}

// Takes the light out.
template <class Scene>
Scene erase_light(const Scene& scene, std::uint32_t light) {
  Scene edited = begin_light_edit(scene, light);
  edited.lights.erase(edited.lights.begin() + light);
  edited.light_places.erase(edited.light_places.begin() + light);
  return edited;
}

// Adds a copy of a light at a place, called "NAME copy"; it is the last light.
template <class Scene>
Scene copy_light(const Scene& scene, std::uint32_t light, LightPlaceOf<Scene> place) {
  Scene edited = begin_light_edit(scene, light);
  Light copy = scene.lights[light];
  copy.name = FreeNames(scene).copy_of(copy.name);
  copy.line = 0;
  edited.add_light(std::move(copy), std::move(place));
  return edited;
}

// Adds a point light of power 1, called "light 1", "light 2", ...; it is the last light.
template <class Scene>
Scene add_light(const Scene& scene, LightPlaceOf<Scene> place) {
  Scene edited = scene;
  edited.expect.clear();
  Light light;
  light.name = FreeNames(scene).numbered("light");
  light.power = Spectrum::scalar(1);
  edited.add_light(std::move(light), std::move(place));
  return edited;
}

}  // namespace hottel
