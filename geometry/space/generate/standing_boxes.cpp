// Rooms with boxes along the axes that stand on the floor, on each other, and side by side.
#include <algorithm>
#include <array>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kSquare = 1000;  // millimetres: each box or tower has a square of the floor to itself
constexpr std::int64_t kBorder = 300, kHeight = 2600;
constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};

// A room over side x side cells with a margin around them.
void add_room_of_squares(GeneratorCanvas3& canvas, std::int64_t side) {
  const std::int64_t length = side * kSquare + 2 * kBorder;
  canvas.add_room({length, length, kHeight});
  canvas.look({length / 2, 100, 1900}, {length / 2, length / 2, 900});
}

Dot3 corner_of_square(std::int64_t cell, std::int64_t side) {
  return {kBorder + cell % side * kSquare, kBorder + cell / side * kSquare, 0};
}

}  // namespace

Scene3 generate_room_boxes_3(const GeneratorRequest3& request) {
  const std::int64_t side = side_of_square(request.n);
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  add_room_of_squares(canvas, side);
  std::int64_t made = 0;
  for (const std::int64_t cell : drawn(static_cast<std::int64_t>(request.n), side * side, chance)) {
    const Dot3 corner = corner_of_square(cell, side);
    const auto low = [&] { return chance.between(20, 320); };
    const auto high = [&] { return chance.between(600, 980); };
    const Dot3 from{low(), low(), 0}, to{high(), high(), chance.between(200, 1800)};
    canvas.add_standing(numbered("box", made++), upright_block(corner + from, corner + to), kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

namespace {

constexpr std::int64_t kMostInATower = 4;

// The heights of towers of n boxes in all, the first as high as it may be.
std::vector<std::int64_t> towers_of(std::int64_t n, Chance& chance) {
  std::vector<std::int64_t> towers = {std::min(n, kMostInATower)};
  for (n -= towers[0]; n > 0; n -= towers.back()) towers.push_back(std::min(n, chance.between(1, kMostInATower)));
  return towers;
}

// The footprint of a box on another one, between 0 and 900: each side is flush, set back or overhanging.
void settle(std::int64_t& low, std::int64_t& high, Chance& chance) {
  const auto moved = [&]() -> std::int64_t {
    switch (chance.below(4)) {
      case 0:
        return chance.between(20, 120);  // set back
      case 1:
        return -chance.between(20, 80);  // overhanging
      default:
        return 0;
    }
  };
  const std::int64_t a = std::max<std::int64_t>(low + moved(), 0), b = std::min<std::int64_t>(high - moved(), 900);
  if (b - a < 200) return;
  low = a;
  high = b;
}

}  // namespace

Scene3 generate_room_stacked_3(const GeneratorRequest3& request) {
  Chance chance(request.seed);
  const std::vector<std::int64_t> towers = towers_of(static_cast<std::int64_t>(request.n), chance);
  const std::int64_t side = side_of_square(towers.size());
  GeneratorCanvas3 canvas(request, 3);
  add_room_of_squares(canvas, side);
  std::int64_t made = 0;
  const std::vector<std::int64_t> cells = drawn(static_cast<std::int64_t>(towers.size()), side * side, chance);
  for (std::size_t tower = 0; tower < towers.size(); ++tower) {
    const Dot3 corner = corner_of_square(cells[tower], side) + Dot3{50, 50, 0};
    Dot3 from{chance.between(0, 250), chance.between(0, 250), 0};
    Dot3 to{chance.between(600, 900), chance.between(600, 900), 0};
    for (std::int64_t level = 0; level < towers[tower]; ++level) {
      if (level > 0) {
        settle(from.x, to.x, chance);
        settle(from.y, to.y, chance);
      }
      from.z = to.z;
      to.z += chance.between(200, 550);
      canvas.add_standing(numbered("box", made++), upright_block(corner + from, corner + to), kPaints[chance.below(4)]);
    }
  }
  return canvas.finish(true);
}

Scene3 generate_room_touching_3(const GeneratorRequest3& request) {
  const auto n = static_cast<std::int64_t>(request.n);
  // An even number of columns: boxes 2 k and 2 k + 1 stand side by side. A strip of the floor stays free.
  const std::int64_t columns = (side_of_square(request.n) + 1) / 2 * 2;
  const std::int64_t rows = (n + columns - 1) / columns;
  const Dot3 size{columns * kSquare, (rows + 1) * kSquare, kHeight};
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  canvas.add_room(size);
  canvas.look({size.x / 2, size.y - 100, 2400}, {size.x / 2, 0, 400});
  const auto gap = [&]() -> std::int64_t { return chance.below(2) == 0 ? 0 : chance.between(100, 300); };
  for (std::int64_t box = 0; box < n; ++box) {
    const Dot3 corner{box % columns * kSquare, box / columns * kSquare, 0};
    const std::int64_t outer = gap(), front = gap(), back = gap();
    const bool touches_next = box % 2 == 0;
    const Dot3 from{touches_next ? outer : 0, front, 0};
    const Dot3 to{kSquare - (touches_next ? 0 : outer), kSquare - back, chance.between(3, 20) * 100};
    canvas.add_block(numbered("box", box), upright_block(corner + from, corner + to), kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

}  // namespace hottel
