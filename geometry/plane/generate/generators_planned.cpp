// Scenes with a plan: rooms, maze, comb, star, pillars, plates. Units are chosen so that what does not touch stays at
// least 3 units apart (see Canvas).
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "geometry/plane/generate/generate_kinds.h"
#include "geometry/plane/generate/generator_canvas.h"

namespace hottel {
namespace {

std::vector<Dot2> placed(const GeneratorCanvas2& canvas, const std::vector<Dot2>& units) {
  std::vector<Dot2> dots;
  dots.reserve(units.size());
  for (const Dot2& unit : units) dots.push_back(canvas.place(unit));
  return dots;
}

constexpr std::int64_t kRoom = 6000;  // millimetres
constexpr std::int64_t kDoor = 900;
constexpr std::int64_t kSkirting = 300;

// A rectangle within radius of the centre, counter-clockwise: its front is its outside.
std::vector<Dot2> rectangle(const Dot2& centre, std::int64_t radius, Chance& chance) {
  constexpr std::int64_t kEighths = 8;
  const std::int64_t t = chance.between(2, 7);  // width to length, in eighths
  const bool upright = chance.below(2) == 0;
  while (true) {
    std::int64_t p = chance.between(-radius / kEighths, radius / kEighths) * kEighths;
    std::int64_t q = chance.between(-radius / kEighths, radius / kEighths) * kEighths;
    if (upright) (chance.below(2) == 0 ? p : q) = 0;
    const std::int64_t squared = p * p + q * q;
    if (9 * squared < radius * radius || squared * (64 + t * t) > 64 * radius * radius) continue;
    const Dot2 u{p, q}, v{-q / kEighths * t, p / kEighths * t};
    return {{centre.x - u.x - v.x, centre.y - u.y - v.y},
            {centre.x + u.x - v.x, centre.y + u.y - v.y},
            {centre.x + u.x + v.x, centre.y + u.y + v.y},
            {centre.x - u.x + v.x, centre.y - u.y + v.y}};
  }
}

// The walls of rooms x rooms rooms: an outer ring with a window in every fourth piece, and inner walls with doorways.
void add_walls(GeneratorCanvas2& canvas, std::int64_t rooms, Chance& chance) {
  int count = 0;
  const auto outer = [&](const Dot2& a, const Dot2& b) {
    const bool window = count % 4 == 1;
    canvas.add_edge(numbered(window ? "window" : "wall", count), canvas.place(a), canvas.place(b),
                    window ? kLamp : kWhite);
    ++count;
  };
  const std::int64_t side = rooms * kRoom;
  for (std::int64_t i = 0; i < rooms; ++i) outer({0, i * kRoom}, {0, (i + 1) * kRoom});
  for (std::int64_t i = 0; i < rooms; ++i) outer({i * kRoom, side}, {(i + 1) * kRoom, side});
  for (std::int64_t i = rooms; i > 0; --i) outer({side, i * kRoom}, {side, (i - 1) * kRoom});
  for (std::int64_t i = rooms; i > 0; --i) outer({i * kRoom, 0}, {(i - 1) * kRoom, 0});

  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  const auto inner = [&](const Dot2& a, const Dot2& step) {  // step: a unit vector
    const std::int64_t door = chance.between(1000, kRoom - kDoor - 1000);
    const Paint front = kPaints[chance.below(4)], back = kPaints[chance.below(4)];
    const auto along = [&](std::int64_t t) { return canvas.place({a.x + step.x * t, a.y + step.y * t}); };
    canvas.add_edge(numbered("wall", count++), along(0), along(door), front, back);
    canvas.add_edge(numbered("wall", count++), along(door + kDoor), along(kRoom), front, back);
  };
  for (std::int64_t row = 0; row < rooms; ++row)
    for (std::int64_t column = 0; column < rooms; ++column) {
      if (column > 0) inner({column * kRoom, row * kRoom}, {0, 1});
      if (row > 0) inner({column * kRoom, row * kRoom}, {1, 0});
    }
}

}  // namespace

Scene2 generate_room_2(const GeneratorRequest2& request) {
  constexpr std::uint64_t kEdgesPerRoom = 32;
  const auto n = static_cast<std::int64_t>(request.n);
  const auto rooms = static_cast<std::int64_t>(std::max<std::uint64_t>(1, integer_root(request.n / kEdgesPerRoom)));
  const std::int64_t pieces = n / 4 - rooms * rooms;  // the walls are 4 edges a room
  const std::int64_t most_in_a_room = (pieces + rooms * rooms - 1) / (rooms * rooms);
  std::int64_t slots = 1;  // slots x slots places for furniture in a room
  while (slots * slots < most_in_a_room) ++slots;
  const std::int64_t slot = (kRoom - 2 * kSkirting) / slots;

  Chance chance(request.seed);
  GeneratorCanvas2 canvas(request, 3, rooms * kRoom);
  add_walls(canvas, rooms, chance);
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  std::int64_t made = 0;
  for (std::int64_t room = 0; room < rooms * rooms; ++room) {
    const std::int64_t upto = pieces * (room + 1) / (rooms * rooms);
    const Dot2 corner{room % rooms * kRoom + kSkirting, room / rooms * kRoom + kSkirting};
    bool first = true;
    for (const std::int64_t place : drawn(upto - made, slots * slots, chance)) {
      const Dot2 centre{corner.x + place % slots * slot + slot / 2, corner.y + place / slots * slot + slot / 2};
      const std::int64_t radius = std::min<std::int64_t>(slot / 2 - 20, 1200);
      const Paint paint = first ? kLamp : kPaints[chance.below(4)];
      canvas.add_polygon(numbered(first ? "lamp" : "piece", made++), placed(canvas, rectangle(centre, radius, chance)),
                         paint);
      first = false;
    }
  }
  return canvas.finish(true);
}

namespace {

// Which walls between the cells of a maze stand, after a depth-first walk has torn down those it passed.
struct MazeWalls {
  std::int64_t columns, rows;
  std::vector<char> right, above;  // of cell (x, y) at y * columns + x

  std::size_t index(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(y * columns + x); }
};

MazeWalls walk_maze(std::int64_t columns, std::int64_t rows, Chance& chance) {
  const auto cells = static_cast<std::size_t>(columns * rows);
  MazeWalls walls{columns, rows, std::vector<char>(cells, 1), std::vector<char>(cells, 1)};
  std::vector<char> visited(cells, 0);
  std::vector<Dot2> path = {{0, 0}};
  visited[0] = 1;
  constexpr std::array<Dot2, 4> kSteps = {Dot2{1, 0}, Dot2{0, 1}, Dot2{-1, 0}, Dot2{0, -1}};
  while (!path.empty()) {
    const Dot2 at = path.back();
    std::array<Dot2, 4> ways;
    std::uint64_t count = 0;
    for (const Dot2& step : kSteps) {
      const Dot2 to{at.x + step.x, at.y + step.y};
      if (to.x < 0 || to.y < 0 || to.x >= columns || to.y >= rows || visited[walls.index(to.x, to.y)]) continue;
      ways[count++] = to;
    }
    if (count == 0) {
      path.pop_back();
      continue;
    }
    const Dot2 to = ways[chance.below(count)];
    const std::size_t lower = walls.index(std::min(at.x, to.x), std::min(at.y, to.y));
    (at.y == to.y ? walls.right : walls.above)[lower] = 0;
    visited[walls.index(to.x, to.y)] = 1;
    path.push_back(to);
  }
  return walls;
}

}  // namespace

Scene2 generate_maze_2(const GeneratorRequest2& request) {
  // A perfect maze of c x r cells has (c - 1)(r - 1) inner and 2 (c + r) outer walls: (c + 1)(r + 1) in all.
  const auto n = static_cast<std::int64_t>(request.n);
  const std::int64_t columns = static_cast<std::int64_t>(integer_root(request.n)) - 1;
  const std::int64_t rows = n / (columns + 1) - 1;
  constexpr std::int64_t kCell = 1000;

  Chance chance(request.seed);
  const MazeWalls walls = walk_maze(columns, rows, chance);
  GeneratorCanvas2 canvas(request, 3, std::max(columns, rows) * kCell);
  std::int64_t count = 0;
  const auto add = [&](const Dot2& a, const Dot2& b, bool inner) {
    const bool lamp = count % 50 == 0;
    const Paint paint = lamp ? kLamp : (a.x == b.x ? kWhite : kRed);
    canvas.add_edge(numbered(lamp ? "lamp" : "wall", count), canvas.place({a.x * kCell, a.y * kCell}),
                    canvas.place({b.x * kCell, b.y * kCell}), paint,
                    inner ? std::optional<Paint>(lamp ? kWhite : paint) : std::nullopt);
    ++count;
  };
  for (std::int64_t y = 0; y < rows; ++y) add({0, y}, {0, y + 1}, false);
  for (std::int64_t x = 0; x < columns; ++x) add({x, rows}, {x + 1, rows}, false);
  for (std::int64_t y = rows; y > 0; --y) add({columns, y}, {columns, y - 1}, false);
  for (std::int64_t x = columns; x > 0; --x) add({x, 0}, {x - 1, 0}, false);
  for (std::int64_t y = 0; y < rows; ++y)
    for (std::int64_t x = 0; x < columns; ++x) {
      if (x + 1 < columns && walls.right[walls.index(x, y)]) add({x + 1, y}, {x + 1, y + 1}, true);
      if (y + 1 < rows && walls.above[walls.index(x, y)]) add({x, y + 1}, {x + 1, y + 1}, true);
    }
  return canvas.finish(true);
}

Scene2 generate_comb_2(const GeneratorRequest2& request) {
  constexpr std::int64_t kSlot = 100, kPitch = 150, kCorridor = 200;
  const auto slots = static_cast<std::int64_t>(request.n / 4);
  Chance chance(request.seed);
  std::vector<Dot2> corners = {{0, 0}};  // clockwise: the inside is to the right
  for (std::int64_t i = 0; i < slots; ++i) {
    const std::int64_t x = i * kPitch, top = kCorridor + chance.between(100, 600);
    if (i > 0) corners.push_back({x, kCorridor});
    corners.push_back({x, top});
    corners.push_back({x + kSlot, top});
    corners.push_back({x + kSlot, i + 1 < slots ? kCorridor : 0});
  }
  GeneratorCanvas2 canvas(request, 2, std::max<std::int64_t>(slots * kPitch, kCorridor + 600));
  corners = placed(canvas, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool lamp = i % 16 == 1;  // the end of every fourth slot
    canvas.add_edge(numbered(lamp ? "lamp" : "wall", i), corners[i], corners[(i + 1) % corners.size()],
                    lamp ? kLamp : (i % 4 == 0 ? kRed : kWhite));
  }
  return canvas.finish(true);
}

Scene2 generate_star_2(const GeneratorRequest2& request) {
  // Rays through points at equal steps of 64 units along a square, walked clockwise; vertices at a random part of each
  // ray, near and far in turn. At the nearest, neighbouring rays are 10 units apart, which neither rounding nor added
  // digits turn round: the polygon stays star-shaped about the centre.
  const auto n = static_cast<std::int64_t>(request.n);
  const std::int64_t radius = 8 * n;
  Chance chance(request.seed);
  GeneratorCanvas2 canvas(request, 2, 2 * radius);
  std::vector<Dot2> corners;
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t walked = 64 * i, along = walked % (2 * radius) - radius;
    const std::array<Dot2, 4> sides = {Dot2{-radius, along}, Dot2{along, radius}, Dot2{radius, -along},
                                       Dot2{-along, -radius}};
    const Dot2 ray = sides[static_cast<std::size_t>(walked / (2 * radius))];
    const std::int64_t part = i % 2 == 0 ? chance.between(52, 64) : chance.between(16, 40);
    corners.push_back(canvas.place({radius + ray.x * part / 64, radius + ray.y * part / 64}));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool lamp = i % 16 == 0;
    canvas.add_edge(numbered(lamp ? "lamp" : "wall", i), corners[i], corners[(i + 1) % corners.size()],
                    lamp ? kLamp : (i % 2 == 0 ? kBlue : kWhite));
  }
  return canvas.finish(true);
}

Scene2 generate_pillars_2(const GeneratorRequest2& request) {
  constexpr std::int64_t kSlot = 1000;
  // Integer points on the circle of radius 5, counter-clockwise.
  constexpr std::array<Dot2, 12> kRound = {Dot2{5, 0},   Dot2{4, 3},  Dot2{3, 4},  Dot2{0, 5},
                                           Dot2{-3, 4},  Dot2{-4, 3}, Dot2{-5, 0}, Dot2{-4, -3},
                                           Dot2{-3, -4}, Dot2{0, -5}, Dot2{3, -4}, Dot2{4, -3}};
  const auto pillars = static_cast<std::int64_t>((request.n - 4) / 12);
  const auto columns = static_cast<std::int64_t>(integer_root(static_cast<std::uint64_t>(pillars - 1)) + 1);
  const std::int64_t side = columns * kSlot;
  Chance chance(request.seed);
  GeneratorCanvas2 canvas(request, 3, side);
  const std::vector<Dot2> corners = placed(canvas, {{0, 0}, {0, side}, {side, side}, {side, 0}});
  for (std::size_t i = 0; i < 4; ++i)
    canvas.add_edge(numbered(i == 1 ? "window" : "wall", i), corners[i], corners[(i + 1) % 4], i == 1 ? kLamp : kWhite);
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  for (const std::int64_t place : drawn(pillars, columns * columns, chance)) {
    const std::int64_t scale = chance.between(20, 60), room = kSlot / 2 - 20 - 5 * scale;
    const Dot2 centre{place % columns * kSlot + kSlot / 2 + chance.between(-room, room),
                      place / columns * kSlot + kSlot / 2 + chance.between(-room, room)};
    std::vector<Dot2> round;
    for (const Dot2& p : kRound) round.push_back(canvas.place({centre.x + scale * p.x, centre.y + scale * p.y}));
    canvas.add_polygon(numbered("pillar", place), round, kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

Scene2 generate_plates_2(const GeneratorRequest2& request) {
  Chance chance(request.seed);
  std::vector<std::array<Dot2, 2>> plates;
  std::int64_t y = 0;
  for (std::uint64_t i = 0; i < request.n; ++i) {
    const std::int64_t x = chance.between(0, 300), width = chance.between(500, 1000);
    plates.push_back({Dot2{x, y}, Dot2{x + width, y}});
    y += chance.between(20, 200);
  }
  GeneratorCanvas2 canvas(request, 2, std::max<std::int64_t>(y, 1300));
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const bool lamp = i % 16 == 0;
    canvas.add_edge(numbered(lamp ? "lamp" : "plate", i), canvas.place(plates[i][0]), canvas.place(plates[i][1]),
                    lamp ? kLamp : kWhite, i % 2 == 0 ? kRed : kBlue);
  }
  return canvas.finish(false);
}

}  // namespace hottel
