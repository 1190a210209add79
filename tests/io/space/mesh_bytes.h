// Binary meshes for tests, and what is read of a mesh as text.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

#include "io/scene/space/mesh_adder.h"

namespace hottel::testing_mesh {

template <class T>
std::string bytes(T value, std::endian order = std::endian::little) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return {raw.begin(), raw.end()};
}

template <class T>
std::string bytes(const std::vector<T>& values, std::endian order = std::endian::little) {
  std::string result;
  for (const T value : values) result += bytes(value, order);
  return result;
}

inline std::string text_of(const Point3& p) { return to_string(p.x) + "," + to_string(p.y) + "," + to_string(p.z); }

// "name: x,y,z x,y,z ..." for each surface.
inline std::vector<std::string> lines(const Scene3& scene) {
  std::vector<std::string> result;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    std::string line = scene.surfaces[s].name + ":";
    for (const Point3& p : scene.polygons[s].points) line += " " + text_of(p);
    result.push_back(line);
  }
  return result;
}

}  // namespace hottel::testing_mesh
