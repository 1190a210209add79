// Scenes of boxes and polygons, put together for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// A scene of materials "white" (0) and "grey" (1). Boxes are groups of six surfaces, "NAME bottom", "NAME top",
// "NAME south", "NAME north", "NAME west", "NAME east"; polygons are groups of their own.
struct BoxScene3 : Scene3 {
  BoxScene3() {
    file = "boxes.json";
    materials.push_back({"white", Spectrum::scalar(Rational(1) / 2), {}});
    materials.push_back({"grey", Spectrum::scalar(Rational(1) / 3), {}});
  }

  // Returns the number of the surface.
  std::uint32_t polygon(const std::string& name, Polygon3 shape, std::uint32_t material = 0,
                        std::optional<std::uint32_t> back = std::nullopt) {
    groups.emplace_back(name);
    return member(name, std::move(shape), material, back);
  }
  std::uint32_t member(const std::string& name, Polygon3 shape, std::uint32_t material = 0,
                       std::optional<std::uint32_t> back = std::nullopt) {
    Surface surface;
    surface.name = name;
    surface.material = material;
    surface.back = back;
    surface.group = static_cast<std::uint32_t>(groups.size() - 1);
    surface.line = static_cast<int>(surfaces.size()) + 1;
    add(std::move(surface), std::move(shape));
    return static_cast<std::uint32_t>(surfaces.size() - 1);
  }

  // Fronts outward, or inward. Returns the number of its bottom.
  std::uint32_t box(const std::string& name, const std::array<Rational, 3>& a, const std::array<Rational, 3>& b,
                    bool is_room = false, std::uint32_t material = 0) {
    groups.emplace_back(name);
    return box_of_group(name, a, b, is_room, material);
  }
  // The same in the group before.
  std::uint32_t box_of_group(const std::string& name, const std::array<Rational, 3>& a,
                             const std::array<Rational, 3>& b, bool is_room = false, std::uint32_t material = 0) {
    const auto at = [&](int x, int y, int z) {
      return Point3{x == 0 ? a[0] : b[0], y == 0 ? a[1] : b[1], z == 0 ? a[2] : b[2]};
    };
    const std::vector<std::pair<const char*, std::vector<Point3>>> sides{
        {"bottom", {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}},
        {"top", {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)}},
        {"south", {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}},
        {"north", {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)}},
        {"west", {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}},
        {"east", {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}}};
    const auto first = static_cast<std::uint32_t>(surfaces.size());
    for (auto [side, points] : sides) {
      if (is_room) std::reverse(points.begin() + 1, points.end());
      member(name + " " + side, {std::move(points)}, material);
    }
    return first;
  }
};

inline constexpr std::uint32_t kBottom = 0, kTop = 1, kSouth = 2, kNorth = 3, kWest = 4, kEast = 5;

// A rectangle of the plane z = height, its front upward.
inline Polygon3 level(const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1,
                      const Rational& height) {
  return {{{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}}};
}

inline Polygon3 turned(Polygon3 polygon) {
  std::reverse(polygon.points.begin() + 1, polygon.points.end());
  return polygon;
}

}  // namespace hottel
