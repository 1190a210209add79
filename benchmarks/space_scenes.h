// Scenes in space for benchmarks: rooms with a few boxes, rooms full of boxes, and a town.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/generate/generators.h"
#include "geometry/space/scene/scene.h"

namespace hottel::benchmarks {

// p / q in lowest terms.
inline Rational ratio(int p, int q) { return Rational(p) / q; }

// A box with the sides `size` about its centre, turned by the rotation of a quaternion of whole numbers: its corners
// are exact. (1, 0, 0, 0) does not turn it.
struct TurnedBox3 {
  Point3 centre;
  Vector3 size;
  std::array<int, 4> quaternion{1, 0, 0, 0};
  bool has_bottom = true;
};

// A scene that begins with one white material. Polygons are called after their place.
class SceneMaker3 {
 public:
  SceneMaker3() { scene_.materials.push_back({"white", Spectrum::scalar(ratio(1, 2)), {}}); }

  void add(Polygon3 polygon, std::uint32_t elements) {
    Surface surface;
    surface.name = "polygon" + std::to_string(scene_.surfaces.size());
    surface.group = static_cast<std::uint32_t>(scene_.groups.size());
    surface.elements = elements;
    scene_.groups.emplace_back(surface.name);
    scene_.add(std::move(surface), std::move(polygon));
  }

  // The six walls of a room from the origin to a corner, seen from inside.
  void add_room(const Vector3& size, std::uint32_t elements) {
    constexpr int kWalls[6][4][3] = {
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}},
        {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}},
        {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}};
    for (const auto& wall : kWalls) {
      Polygon3 polygon;
      for (const auto& at : wall) polygon.points.push_back({at[0] * size.x, at[1] * size.y, at[2] * size.z});
      add(std::move(polygon), elements);
    }
  }

  // The faces of a box, seen from outside.
  void add_box(const TurnedBox3& box, std::uint32_t elements) {
    constexpr int kTop = 0, kBottom = 1;
    constexpr int kFaces[6][4][3] = {
        {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},     {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}},
        {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}, {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}},
        {{1, 1, -1}, {-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}},     {{-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}}};
    for (int face = kTop; face < 6; ++face) {
      if (face == kBottom && !box.has_bottom) continue;
      Polygon3 polygon;
      for (const auto& corner : kFaces[face]) polygon.points.push_back(corner_of(box, corner));
      add(std::move(polygon), elements);
    }
  }

  Scene3 take() { return std::move(scene_); }

 private:
  static Point3 corner_of(const TurnedBox3& box, const int (&corner)[3]) {
    const auto [a, b, c, d] = box.quaternion;
    const int rows[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                            {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                            {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
    const int twice_norm = 2 * (a * a + b * b + c * c + d * d);
    const Vector3 way{corner[0] * box.size.x, corner[1] * box.size.y, corner[2] * box.size.z};
    const auto along = [&](const int(&row)[3]) -> Rational {
      return (row[0] * way.x + row[1] * way.y + row[2] * way.z) / twice_norm;
    };
    return {box.centre.x + along(rows[0]), box.centre.y + along(rows[1]), box.centre.z + along(rows[2])};
  }

  Scene3 scene_;
};

// Unit cubes with boxes: those of room_axis.json and room_turned.json in scenes/space; and with one box that floats in
// the middle, with sides of 1/2, which published figures exist for.
enum class Room3 : unsigned char { kAxis, kTurned, kCentred };
constexpr const char* kRoomNames[] = {"axis", "turned", "centred"};
inline const char* to_string(Room3 room) { return kRoomNames[static_cast<int>(room)]; }

// Returns one of these rooms with every wall divided into walls x walls elements and every face of a box into boxes x
// boxes; in the files they are 8 and 2, of the turned boxes 1.
inline Scene3 room_3(Room3 room, std::uint32_t walls, std::uint32_t boxes) {
  SceneMaker3 maker;
  maker.add_room({1, 1, 1}, walls);
  if (room == Room3::kAxis) {
    const auto add = [&](int x, int y, int z, int width, int depth, int height, bool has_bottom) {
      maker.add_box({{ratio(x, 16), ratio(y, 16), ratio(z, 16)},
                     {ratio(width, 8), ratio(depth, 8), ratio(height, 8)},
                     {1, 0, 0, 0},
                     has_bottom},
                    boxes);
    };
    add(4, 4, 2, 2, 2, 2, false);
    add(12, 10, 3, 2, 2, 3, false);
    add(11, 9, 7, 1, 1, 1, false);
    add(7, 12, 10, 1, 2, 2, true);
  } else if (room == Room3::kTurned) {
    const auto add = [&](int x, int y, int z, int width, int depth, int height, const std::array<int, 4>& quaternion) {
      maker.add_box({{ratio(x, 10), ratio(y, 10), ratio(z, 20)},
                     {ratio(1, width), ratio(1, depth), ratio(1, height)},
                     quaternion},
                    boxes);
    };
    add(3, 3, 5, 4, 5, 6, {3, 1, 0, 1});
    add(7, 3, 8, 5, 5, 4, {2, 0, 1, 1});
    add(7, 7, 14, 6, 4, 8, {4, 1, 2, 1});
    add(3, 7, 12, 4, 8, 5, {3, 2, 1, -1});
  } else {
    const Rational half = ratio(1, 2);
    maker.add_box({{half, half, half}, {half, half, half}}, boxes);
  }
  return maker.take();
}

// Whole numbers from low to high, by a seed: the same on every machine.
class Dice3 {
 public:
  explicit Dice3(std::uint64_t seed) : engine_(seed) {}
  int roll(int low, int high) { return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

// The cells along one side of a cubic room that has a place for so many boxes.
inline int cells_for(std::size_t boxes) {
  int cells = 2;
  while (static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells) < boxes)
    ++cells;
  return cells;
}

// Returns a cubic room of cells of side 1, in so many of which there is a box with sides from 3/16 to 9/16: all along
// the axes on a lattice of 1/32, or all turned. It has 6 + 6 * boxes polygons. No box comes near to a corner of a cell.
inline Scene3 full_room_3(std::size_t boxes, bool are_turned) {
  const int cells = cells_for(boxes);
  std::vector<int> places(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells) *
                          static_cast<std::size_t>(cells));
  std::iota(places.begin(), places.end(), 0);
  Dice3 dice(1);
  SceneMaker3 maker;
  maker.add_room({cells, cells, cells}, 1);
  for (std::size_t box = 0; box < boxes; ++box) {
    std::swap(places[box],
              places[static_cast<std::size_t>(dice.roll(static_cast<int>(box), static_cast<int>(places.size()) - 1))]);
    const int place = places[box];
    const auto middle = [](int cell) { return ratio(2 * cell + 1, 2); };
    TurnedBox3 next{{middle(place % cells), middle(place / cells % cells), middle(place / cells / cells)},
                    {ratio(dice.roll(3, 9), 16), ratio(dice.roll(3, 9), 16), ratio(dice.roll(3, 9), 16)}};
    if (are_turned) next.quaternion = {dice.roll(1, 3), dice.roll(-2, 2), dice.roll(-2, 2), dice.roll(1, 2)};
    maker.add_box(next, 1);
  }
  return maker.take();
}

// Returns the town that `hottel generate town --no-bottoms --seed 1` makes.
inline Scene3 town_3(std::uint64_t buildings) { return generate_3({"town", buildings, 1, false}); }

// The value below which a part of them lies: 0.5 is the median, 1 the largest; 0 of none.
inline double quantile(const std::vector<double>& values, double part) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values);
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

}  // namespace hottel::benchmarks
