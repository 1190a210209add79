#include "geometry/space/scene/scene.h"

#include <string_view>

#include "geometry/name.h"

namespace hottel {

std::string camera_problem(const Camera3& camera) {
  const Vector3 view = camera.target - camera.eye;
  if (view.is_zero()) return "eye and target are one point";
  if (cross(view, camera.up).is_zero())
    return "it looks along \"up\", which is [0, 0, 1] where none is given, or \"up\" is zero: give another, such as "
           "[0, 1, 0]";
  if (camera.field_of_view <= 0 || camera.field_of_view >= 180)
    return "field_of_view must be greater than 0 and less than 180 degrees";
  const auto is_count = [](std::uint32_t pixels) { return pixels >= 1 && pixels <= kMaxPixels; };
  if (!is_count(camera.width) || !is_count(camera.height))
    return "pixels must be integers from 1 to " + std::to_string(kMaxPixels);
  return "";
}

std::string grid_problem(const Grid3& grid) {
  if (cross(grid.u, grid.v).is_zero()) return "u and v are parallel, or one is zero";
  if (grid.w && dot(cross(grid.u, grid.v), *grid.w) == 0) return "w lies in the plane of u and v";
  const auto is_count = [](std::uint32_t cells) { return cells >= 1 && cells <= kMaxGridCells3; };
  if (!is_count(grid.nu) || !is_count(grid.nv) || !is_count(grid.nw))
    return "cells must be integers from 1 to " + std::to_string(kMaxGridCells3);
  return "";
}

Point3 place_in(const Grid3& grid, const Rational& s, const Rational& t, const Rational& r) {
  const Vector3 &u = grid.u, &v = grid.v;
  Point3 place{grid.origin.x + s * u.x + t * v.x, grid.origin.y + s * u.y + t * v.y, grid.origin.z + s * u.z + t * v.z};
  if (!grid.w) return place;
  return {place.x + r * grid.w->x, place.y + r * grid.w->y, place.z + r * grid.w->z};
}

Point3 cell_centre(const Grid3& grid, std::size_t cell) {
  const auto middle = [](std::size_t k, std::size_t count) -> Rational {
    return Rational(2 * k + 1) / Rational(2 * count);
  };
  const std::size_t layer = std::size_t{grid.nu} * grid.nv, in_layer = cell % layer;
  return place_in(grid, middle(in_layer % grid.nu, grid.nu), middle(in_layer / grid.nu, grid.nv),
                  middle(cell / layer, grid.nw));
}

}  // namespace hottel
