// A furnished flat, all of triangles: rooms in rows, with walls between them that have doorways.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/generate/furniture.h"
#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kWall = 150, kDoorWidth = 900, kDoorHeight = 2000;  // millimetres
constexpr std::uint64_t kShellTriangles = 14, kDoorTriangles = 20;         // of the walls, floor and ceiling of a room

constexpr Dot3 kUp{0, 0, kPlaceHeight}, kDoorUp{0, 0, kDoorHeight};

// Where a doorway meets the floor of a room, from p to q with the room on the left.
struct Sill {
  Dot3 p, q;
};

// A room: its corners on the floor, counterclockwise from the lowest, and the doorway in the wall from each to the
// next.
struct Room {
  std::array<Dot3, 4> corners;
  std::array<std::optional<Sill>, 4> sills;
};
constexpr std::size_t kSouth = 0, kEast = 1, kNorth = 2, kWest = 3;

void add_quad(GeneratorCanvas3& canvas, const Dot3& a, const Dot3& b, const Dot3& c, const Dot3& d, Paint paint) {
  canvas.add({a, b, c}, paint);
  canvas.add({a, c, d}, paint);
}

// The wall from a to b, seen from its left.
void add_wall(GeneratorCanvas3& canvas, const Dot3& a, const Dot3& b, const std::optional<Sill>& sill, Paint paint) {
  if (!sill) return add_quad(canvas, a, a + kUp, b + kUp, b, paint);
  const auto& [p, q] = *sill;
  add_quad(canvas, a, a + kUp, p + kDoorUp, p, paint);
  add_quad(canvas, a + kUp, b + kUp, q + kDoorUp, p + kDoorUp, paint);
  add_quad(canvas, b + kUp, b, q, q + kDoorUp, paint);
}

// The floor is a fan about its middle: corners and ends of sills are along its border.
void add_room(GeneratorCanvas3& canvas, const Room& room, Paint paint) {
  std::vector<Dot3> border;
  for (std::size_t side = 0; side < 4; ++side) {
    border.push_back(room.corners[side]);
    if (const auto& sill = room.sills[side]) border.insert(border.end(), {sill->p, sill->q});
  }
  const Dot3 middle = room.corners[0] + Dot3{kPlaceWidth / 2, kPlaceDepth / 2, 0};
  for (std::size_t k = 0; k < border.size(); ++k)
    canvas.add({middle, border[k], border[(k + 1) % border.size()]}, kWood);
  const auto& [a, b, c, d] = room.corners;
  add_quad(canvas, a + kUp, d + kUp, c + kUp, b + kUp, kWhite);
  for (std::size_t side = 0; side < 4; ++side)
    add_wall(canvas, room.corners[side], room.corners[(side + 1) % 4], room.sills[side],
             side == kNorth ? paint : kWhite);
}

// What is within the wall between two sills: the floor, the sides, and what is above.
void add_doorway(GeneratorCanvas3& canvas, const Sill& one, const Sill& other) {
  add_quad(canvas, one.q, one.p, other.q, other.p, kWood);
  add_quad(canvas, one.p, one.p + kDoorUp, other.q + kDoorUp, other.q, kWhite);
  add_quad(canvas, other.p, other.p + kDoorUp, one.q + kDoorUp, one.q, kWhite);
  add_quad(canvas, one.p + kDoorUp, one.q + kDoorUp, other.p + kDoorUp, other.q + kDoorUp, kWhite);
}

Dot3 corner_of(std::int64_t k, std::int64_t columns) {
  return {k % columns * (kPlaceWidth + kWall), k / columns * (kPlaceDepth + kWall), 0};
}

}  // namespace

Scene3 generate_flat_3(const GeneratorRequest3& request) {
  constexpr std::uint64_t kMoreForARoom = kPlaceTriangles + kShellTriangles + kDoorTriangles;
  const std::uint64_t count = (request.n + kDoorTriangles) / kMoreForARoom;
  const auto rooms = static_cast<std::int64_t>(count);
  const std::int64_t columns = side_of_square(count);
  Chance chance(request.seed);
  std::vector<Room> plan(count);
  for (std::int64_t k = 0; k < rooms; ++k) {
    const Dot3 a = corner_of(k, columns);
    plan[static_cast<std::size_t>(k)].corners = {
        {a, a + Dot3{kPlaceWidth, 0, 0}, a + Dot3{kPlaceWidth, kPlaceDepth, 0}, a + Dot3{0, kPlaceDepth, 0}}};
  }
  // Each room but the first has a doorway to the one before it in its row, or to the one in the row before: one way
  // leads from each room to each other.
  std::vector<std::array<Sill, 2>> doorways;
  for (std::int64_t k = 1; k < rooms; ++k) {
    const bool has_west = k % columns > 0, has_south = k >= columns;
    const bool is_west = has_west && (!has_south || chance.below(2) == 0);
    const Dot3 a = corner_of(k, columns);
    const std::int64_t from = is_west ? chance.between(300, 1500) : chance.between(3050, 3150);
    const Dot3 way = is_west ? Dot3{0, 1, 0} : Dot3{1, 0, 0},
               through = is_west ? Dot3{-kWall, 0, 0} : Dot3{0, -kWall, 0};
    const Dot3 low = a + from * way, high = low + kDoorWidth * way;
    Sill near{low, high}, far{high + through, low + through};
    if (is_west) {
      near = {high, low};
      far = {low + through, high + through};
    }
    plan[static_cast<std::size_t>(k)].sills[is_west ? kWest : kSouth] = near;
    plan[static_cast<std::size_t>(is_west ? k - 1 : k - columns)].sills[is_west ? kEast : kNorth] = far;
    doorways.push_back({near, far});
  }
  GeneratorCanvas3 canvas(request, 3);
  canvas.draw_triangles();
  canvas.begin("room");
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  for (const Room& room : plan) add_room(canvas, room, kPaints[chance.below(4)]);
  for (const auto& [one, other] : doorways) add_doorway(canvas, one, other);
  canvas.look({kPlaceWidth - 200, 200, 2200}, {kPlaceWidth / 2, kPlaceDepth / 2, 600});
  for (std::int64_t k = 0; k < rooms; ++k) furnish(canvas, std::to_string(k), corner_of(k, columns), chance);
  return canvas.finish(true);
}

}  // namespace hottel
