#include "geometry/space/scene/scene.h"

namespace hottel {

std::string camera_problem(const Camera3& camera) {
  const Vector3 view = camera.target - camera.eye;
  if (view.is_zero()) return "eye and target are one point";
  if (cross(view, camera.up).is_zero()) return "up is zero or parallel to the direction of view";
  if (camera.field_of_view <= 0 || camera.field_of_view >= 180)
    return "field_of_view must be greater than 0 and less than 180 degrees";
  const auto is_count = [](std::uint32_t pixels) { return pixels >= 1 && pixels <= kMaxPixels; };
  if (!is_count(camera.width) || !is_count(camera.height))
    return "pixels must be integers from 1 to " + std::to_string(kMaxPixels);
  return "";
}

std::string grid_problem(const Grid3& grid) {
  if (cross(grid.u, grid.v).is_zero()) return "u and v are parallel, or one is zero";
  const auto is_count = [](std::uint32_t cells) { return cells >= 1 && cells <= kMaxGridCells3; };
  if (!is_count(grid.nu) || !is_count(grid.nv))
    return "cells must be integers from 1 to " + std::to_string(kMaxGridCells3);
  return "";
}

}  // namespace hottel
