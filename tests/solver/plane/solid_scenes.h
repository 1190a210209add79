// Rooms with boxes: scenes with solids, and what is in them, known without looking at an arrangement.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/solver/plane/lit_scenes.h"

namespace hottel {

inline void add_run(Scene2& scene, const std::vector<Point2>& points, bool is_closed, Behind behind) {
  const auto group = static_cast<std::uint32_t>(scene.groups.size());
  for (std::size_t k = 0; k + (is_closed ? 0 : 1) < points.size(); ++k) {
    add_edge(scene, points[k], points[(k + 1) % points.size()]);
    scene.groups.pop_back();
    scene.surfaces.back().group = group;
  }
  scene.groups.push_back({"run" + std::to_string(group), behind});
}
inline void add_outline(Scene2& scene, const std::vector<Point2>& points) {
  add_run(scene, points, true, Behind::kByOutline);
}

// An axis-parallel rectangle.
struct Box2 {
  Rational x0, y0, x1, y1;
  bool contains(const Point2& p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
};
inline void add_box(Scene2& scene, const Box2& box) {
  add_outline(scene, {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}});
}

// A closed room from (0, 0) to (4, 3), and boxes in it that are solid.
struct BoxRoom {
  std::string name;
  Scene2 scene;
  std::vector<Box2> boxes;

  explicit BoxRoom(std::string n) : name(std::move(n)) {
    add_outline(scene, {{0, 0}, {0, 3}, {4, 3}, {4, 0}});
    scene.closed = true;
  }
  BoxRoom& box(const Box2& box) {
    boxes.push_back(box);
    add_box(scene, box);
    return *this;
  }

  // Is the point in the interior of the union of all boxes? Then the points next to it in all four quadrants are in a
  // box.
  bool is_in_solid(const Point2& p) const {
    const Rational step = Rational(1, 1ul << 62) / 1024;
    for (const int dx : {-1, 1})
      for (const int dy : {-1, 1}) {
        const Point2 near{p.x + step * dx, p.y + step * dy};
        if (std::none_of(boxes.begin(), boxes.end(), [&](const Box2& box) { return box.contains(near); })) return false;
      }
    return true;
  }
  static bool is_within_walls(const Point2& p) { return p.x > 0 && p.x < 4 && p.y > 0 && p.y < 3; }
};

inline std::vector<BoxRoom> box_rooms() {
  const Rational h(1, 2), q(1, 4);
  std::vector<BoxRoom> rooms;
  const auto room = [&](const char* name) -> BoxRoom& { return rooms.emplace_back(name); };
  room("on the floor").box({1, 0, 2, 1});
  room("in a corner").box({3, 0, 4, 1 + h});
  room("from floor to ceiling").box({1, 0, 1 + h, 3});
  room("in the open").box({1, 1, 2, 2});
  room("stacked").box({1, 0, 2, 1}).box({1 + q, 1, 2 - q, 2});
  room("side by side").box({1, 0, 2, 1}).box({2, 0, 3, 1});
  room("of three, in a corner, one upon two").box({0, 0, 1, 1}).box({1, 0, 2, 1}).box({h, 1, 1 + h, 2});
  room("touching in a point").box({1, 1, 2, 2}).box({2, 2, 3, 2 + h});
  room("crossing").box({1, 1, 2 + h, 2}).box({1 + h, h, 2, 2 + h});
  room("around a yard").box({1, 1, 3, 1 + q}).box({1, 2, 3, 2 + q}).box({1, 1, 1 + q, 2 + q}).box({3 - q, 1, 3, 2 + q});

  BoxRoom& drawn_in = room("with pieces drawn inside").box({1, h, 3, 2});
  add_edge(drawn_in.scene, {1 + q, 1}, {2 + q, 1}, true);
  add_edge(drawn_in.scene, {2, 1}, {2, 1 + h});
  add_edge(drawn_in.scene, {h, 1 + h}, {2, 1 + h}, true);  // comes in from outside

  BoxRoom& three_sides = room("drawn as three sides on the floor");
  three_sides.boxes = {{1, 0, 2, 1}};
  add_run(three_sides.scene, {{2, 0}, {2, 1}, {1, 1}, {1, 0}}, false, Behind::kSolid);

  BoxRoom& two_sides = room("drawn as two sides in the corner");
  two_sides.boxes = {{3, 2, 4, 3}};
  add_run(two_sides.scene, {{3, 3}, {3, 2}, {4, 2}}, false, Behind::kSolid);
  return rooms;
}

// The share of a cell that is in no box: of a grid of points on which the boxes' borders lie between.
inline double free_share(const BoxRoom& room, const Rational& x0, const Rational& y0, const Rational& x1,
                         const Rational& y1) {
  constexpr int kParts = 8;  // of cells a multiple of 1/3 wide, when borders are multiples of 1/4
  int free = 0;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts; ++j) {
      const Rational s(2 * i + 1, 2 * kParts), t(2 * j + 1, 2 * kParts);
      free += room.is_in_solid({x0 + s * (x1 - x0), y0 + t * (y1 - y0)}) ? 0 : 1;
    }
  return static_cast<double>(free) / (kParts * kParts);
}

}  // namespace hottel
