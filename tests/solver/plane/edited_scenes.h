// Scenes that are edited at random, and what is to be the same however they came about.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "geometry/plane/check/finding.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/simulation/simulation.h"
#include "tests/solver/traces.h"

namespace hottel {

// A scene as it is after it was written and read again.
inline Scene2 saved(const Scene2& scene) { return parse_scene_2(write_scene_2(scene), "edited.json"); }

// A room of 8 x 8 with a lamp, a box on its floor and free-standing edges, some of which touch and cross.
inline Scene2 room_to_edit() {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2,
    "materials": {"white": {"reflectivity": 0.7}, "red": {"reflectivity": [0.8, 0.2, 0.1]},
                  "lamp": {"emission": [9, 8, 6], "reflectivity": 0.1}, "black": {}},
    "polylines": [{"name": "room", "points": [[0,0],[0,8],[8,8],[8,0]], "closed": true, "material": "white"},
                  {"name": "box", "points": [[5,0],[6,0],[6,2],[5,2]], "closed": true, "material": "red"}],
    "edges": [{"name": "lamp", "points": [[3,7],[4,7]], "material": "lamp", "back": "white"},
              {"name": "shelf", "points": [[1,3],[3,3]], "material": "white", "back": "red"},
              {"name": "screen", "points": [[2,1],[2,5]], "material": "black", "back": "white", "elements": 2},
              {"name": "post", "points": [[6,4],[7,5]], "material": "red"}],
    "sky": {"emission": 1}})",
                       "edited.json");
}

// Edits at random: geometry, materials, sky, the promise `closed`, elements, grid, kind of light, every effect.
class RandomEdits {
 public:
  explicit RandomEdits(std::uint64_t seed) : random_(seed) {}

  Simulation2 next(const Simulation2& simulation) {
    Scene2 scene = simulation.scene();
    SimulationRequest2 request = simulation.request();
    const auto surface = below(scene.surfaces.size());
    Material& material = scene.materials[below(scene.materials.size())];
    switch (below(13)) {
      case 0:
      case 1:
        move_point(scene, surface);
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
        scene.surfaces[surface].elements = static_cast<std::uint32_t>(1 + below(3));
        break;
      case 7:
        scene.surfaces[surface].material = static_cast<std::uint32_t>(below(scene.materials.size()));
        break;
      case 8:
        request.grid = grid_over(scene, static_cast<std::uint32_t>(2 + below(5)), 4);
        return simulation.with_request(request);
      case 9:
        request.light = static_cast<LightKind2>(below(3));
        return simulation.with_request(request);
      case 10:
        scene.closed = !scene.closed;
        break;
      case 11:
        request.everything = !request.everything;
        return simulation.with_request(request);
      default:
        scene.about = "edited " + std::to_string(random_());
    }
    return simulation.with_scene(saved(scene));
  }
  Rational draw(std::size_t n) { return Rational(static_cast<int>(below(n))); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

 private:
  // Moves an end to a place on a coarse lattice, and all ends that lie where it lay.
  void move_point(Scene2& scene, std::size_t surface) {
    const Point2 place{draw(17) / 2, draw(17) / 2};
    const Point2 before = below(2) == 0 ? scene.edges[surface].from : scene.edges[surface].to;
    Scene2 moved = scene;
    for (Edge2& edge : moved.edges) {
      if (edge.from == before) edge.from = place;
      if (edge.to == before) edge.to = place;
      if (edge.from == edge.to) return;
    }
    scene = std::move(moved);
  }

  std::mt19937_64 random_;
};

inline std::string traces_of(const Simulation2& simulation) {
  Traces traces;
  traces.add([&] { traces.add_matrix(simulation.factors()->matrix); });
  traces.add([&] { traces.add_solution(*simulation.radiosities()); });
  traces.add([&] {
    const auto light = simulation.light();
    for (const double value : light->grid.values) traces.add_number(value);
  });
  traces.add([&] {
    const auto check = simulation.check();
    for (const Finding2& finding : check->findings) traces.add_text(finding.kind + ": " + finding.message);
  });
  return traces.text();
}

}  // namespace hottel
