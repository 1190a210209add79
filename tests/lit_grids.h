// Scenes with grids of all kinds, to be lit by one process or by several.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {

struct LitGrid3 {
  std::string scene;  // below scenes/
  Granularity granularity;
  bool is_closed;
  Grid3 grid;
};

// Planar and a volume, through solids and beyond walls, with corners that are no doubles; with and without lights.
inline std::vector<LitGrid3> lit_grids_3() {
  const Rational third(1, 3);
  return {{"space/two_boxes.json", Granularity::kElement, false, {{-third, 0, third}, {5, 0, 0}, {0, 4, third}, 9, 7}},
          {"space/cube.json", Granularity::kFace, true, {{-1, 0, third}, {3, third, 0}, {0, 1, 0}, 8, 3}},
          {"lights/stage.json",
           Granularity::kFace,
           false,
           {{-2, -2, -third}, {6, 0, 0}, {0, 6, 0}, 4, 3, "", Vector3{0, third, 4}, 3}}};
}

inline Simulation3 simulation_of(const LitGrid3& lit, const std::string& scenes) {
  Scene3 scene = read_scene_3(scenes + lit.scene);
  for (Surface& surface : scene.surfaces) surface.elements = lit.granularity == Granularity::kElement ? 2 : 1;
  scene.closed = lit.is_closed;
  return Simulation3(std::move(scene), {.factors = {.granularity = lit.granularity, .tolerance = 1e-4}});
}

struct LitGrid2 {
  std::string scene;  // below scenes/
  Granularity granularity;
  bool is_closed;
  Grid2 grid;
};

// Of one band and of many, through solids and beyond walls, with corners that are no doubles; with and without lights.
inline std::vector<LitGrid2> lit_grids_2() {
  const Rational third(1, 3);
  return {{"showcase/apartment.json", Granularity::kElement, false, {{-third, 0}, {14, 10}, 150, 170}},
          {"showcase/museum.json", Granularity::kFace, true, {{-1, -third}, {30, 20}, 11, 9}},
          {"lights/torch.json", Granularity::kFace, false, {{-2, -2 - third}, {8, 8}, 130, 150}}};
}

inline Simulation2 simulation_of(const LitGrid2& lit, const std::string& scenes) {
  Scene2 scene = read_scene_2(scenes + lit.scene);
  scene.closed = lit.is_closed;
  return Simulation2(std::move(scene), {.granularity = lit.granularity, .grid = lit.grid});
}

inline std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

}  // namespace hottel
