// Scenes in space that are edited at random, and what is to be the same however they came about.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/space/check/scene_check.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/queries.h"
#include "solver/space/simulation/simulation.h"
#include "tests/solver/traces.h"

namespace hottel {

// A scene as it is after it was written and read again.
inline Scene3 saved(const Scene3& scene) { return parse_scene_3(write_scene_3(scene), "edited.json"); }

// A room of 8 x 8 x 8 with a lamp, a box on its floor, free-standing plates, some of which touch and pierce each other,
// a spot and a grid.
inline Scene3 room_to_edit_3() {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3,
    "materials": {"white": {"reflectivity": 0.7}, "red": {"reflectivity": [0.8, 0.2, 0.1]},
                  "lamp": {"emission": [9, 8, 6], "reflectivity": 0.1}, "black": {}},
    "polygons": [
      {"name": "floor", "points": [[0,0,0],[8,0,0],[8,8,0],[0,8,0]], "material": "white"},
      {"name": "ceiling", "points": [[0,0,8],[0,8,8],[8,8,8],[8,0,8]], "material": "white"},
      {"name": "front", "points": [[0,0,0],[0,0,8],[8,0,8],[8,0,0]], "material": "white"},
      {"name": "rear", "points": [[0,8,0],[8,8,0],[8,8,8],[0,8,8]], "material": "white"},
      {"name": "left", "points": [[0,0,0],[0,8,0],[0,8,8],[0,0,8]], "material": "red"},
      {"name": "right", "points": [[8,0,0],[8,0,8],[8,8,8],[8,8,0]], "material": "white"},
      {"name": "lamp", "points": [[3,3,7],[3,4,7],[4,4,7],[4,3,7]], "material": "lamp", "back": "white"},
      {"name": "shelf", "points": [[1,2,3],[3,2,3],[3,5,3],[1,5,3]], "material": "white", "back": "red"},
      {"name": "screen", "points": [[2,1,1],[2,4,1],[2,4,5],[2,1,5]], "material": "black", "back": "white",
       "elements": 2},
      {"name": "top", "group": "box", "points": [[5,5,2],[6,5,2],[6,6,2],[5,6,2]], "material": "red"},
      {"name": "west", "group": "box", "points": [[5,5,0],[5,5,2],[5,6,2],[5,6,0]], "material": "red"},
      {"name": "east", "group": "box", "points": [[6,5,0],[6,6,0],[6,6,2],[6,5,2]], "material": "red"}],
    "lights": [{"type": "spot", "name": "torch", "position": [4, 2, 6], "direction": [0, 1, -1], "focus": 40,
                "power": 2}],
    "sky": {"emission": 1}})",
                       "edited.json");
}

// Edits at random: places, materials, lights, sky, the promise `closed`, elements, grid, kind of light, every effect,
// and scenes without a trace of light.
class RandomEdits3 {
 public:
  explicit RandomEdits3(std::uint64_t seed) : random_(seed) {}

  Simulation3 next(const Simulation3& simulation) {
    Scene3 scene = simulation.scene();
    SimulationRequest3 request = simulation.request();
    const auto surface = below(scene.surfaces.size());
    Material& material = scene.materials[below(scene.materials.size())];
    switch (below(16)) {
      case 0:
      case 1:
        move_side(scene, surface);
        break;
      case 2:
        material.emission = Spectrum::scalar(draw(4));
        break;
      case 3:
        material.reflectivity = Spectrum::scalar(draw(10) / 10);
        break;
      case 4:
        material.reflectivity = {{Rational(1, 2), draw(10) / 10, 0}, false};
        break;
      case 5:
        scene.sky_emission = Spectrum::scalar(draw(3));
        break;
      case 6:
        scene.surfaces[surface].elements = static_cast<std::uint32_t>(1 + below(2));
        break;
      case 7:
        scene.surfaces[surface].material = static_cast<std::uint32_t>(below(scene.materials.size()));
        break;
      case 8:
        request.light.grid =
            Grid3{{1, 1, draw(8) + Rational(1, 3)}, {6, 0, 0}, {0, 6, 0}, static_cast<std::uint32_t>(1 + below(3)), 2};
        return simulation.with_request(request);
      case 9:
        request.light.is_average = !request.light.is_average;
        return simulation.with_request(request);
      case 10:
        scene.closed = !scene.closed;
        break;
      case 11:
        request.plan.everything = !request.plan.everything;
        return simulation.with_request(request);
      case 12:
        request.factors.granularity =
            request.factors.granularity == Granularity::kFace ? Granularity::kElement : Granularity::kFace;
        return simulation.with_request(request);
      case 13:
        scene.lights[0].power = Spectrum::scalar(draw(4));
        break;
      case 14:
        scene.light_places[0].position = {draw(15) / 2 + Rational(1, 4), draw(15) / 2 + Rational(1, 4), 6};
        break;
      default:
        scene.about = "edited " + std::to_string(random_());
    }
    try {
      return simulation.with_scene(saved(scene));
    } catch (const InputError&) {  // there a light cannot be
      return simulation;
    }
  }
  Rational draw(std::size_t n) { return Rational(static_cast<int>(below(n))); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

 private:
  // Moves all corners of one height along an axis to another one, of a coarse lattice: polygons stay plane.
  void move_side(Scene3& scene, std::size_t surface) {
    constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};
    const auto axis = kAxes[below(3)];
    const Rational before = scene.polygons[surface].points[below(3)].*axis, after = draw(17) / 2;
    Scene3 moved = scene;
    for (Polygon3& polygon : moved.polygons) {
      for (Point3& point : polygon.points)
        if (point.*axis == before) point.*axis = after;
      if (doubled_area(polygon).is_zero()) return;
    }
    scene = std::move(moved);
  }

  std::mt19937_64 random_;
};

inline std::string traces_of(const Simulation3& simulation) {
  Traces traces;
  traces.add([&] { traces.add_matrix(simulation.factors()->matrix); });
  traces.add([&] {
    for (const auto& [a, b] : *simulation.hidden()) traces.add_text(std::to_string(a) + " " + std::to_string(b));
  });
  traces.add([&] { traces.add_solution(*simulation.radiosities()); });
  traces.add([&] {
    const auto light = simulation.light();
    for (const double value : light->values) traces.add_number(value);
  });
  traces.add([&] {
    for (const PlannedEffect& effect : simulation.plan()->effects())
      traces.add_text(effect.effect + ": " + effect.reason);
  });
  if (simulation.request().factors.granularity == Granularity::kFace)
    traces.add([&] {
      const SceneCheck3 check = scene_check(simulation);
      for (const auto& finding : check.findings) traces.add_text(finding.kind + ": " + finding.message);
    });
  return traces.text();
}

}  // namespace hottel
