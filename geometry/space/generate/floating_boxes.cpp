// Rooms with boxes in the air: along the axes, turned, and through each other.
#include <algorithm>
#include <array>
#include <vector>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kCell = 1000;  // millimetres: each box, or cluster of boxes, keeps to a cube of the room
constexpr std::int64_t kMargin = 300;
constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};

void add_room_of_cells(GeneratorCanvas3& canvas, std::int64_t side, std::int64_t cell = kCell) {
  const std::int64_t length = side * cell + 2 * kMargin;
  canvas.add_room({length, length, length});
  canvas.look({length / 2, 100, length - 150}, {length / 2, length / 2, length / 2});
}

Dot3 corner_of_cell(std::int64_t place, std::int64_t side, std::int64_t cell = kCell) {
  return {kMargin + place % side * cell, kMargin + place / side % side * cell, kMargin + place / side / side * cell};
}

// Three ways at right angles, right-handed, each of the same length.
struct Frame3 {
  Dot3 u, v, w;
  std::int64_t length;
};

// The rotation of a quaternion of whole numbers, times the square of its length. It is no quarter turn: some of its
// ways is along no axis.
Frame3 turned_frame(Chance& chance) {
  while (true) {
    const std::int64_t a = chance.between(-3, 3), b = chance.between(-3, 3), c = chance.between(-3, 3),
                       d = chance.between(-3, 3);
    const std::int64_t length = a * a + b * b + c * c + d * d;
    const Frame3 frame{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
                       {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
                       {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d},
                       length};
    const auto is_along_an_axis = [](const Dot3& way) { return (way.x != 0) + (way.y != 0) + (way.z != 0) == 1; };
    if (length == 0 || length > 30) continue;
    if (is_along_an_axis(frame.u) && is_along_an_axis(frame.v) && is_along_an_axis(frame.w)) continue;
    return frame;
  }
}

// A turned box about a centre. Its half sides are from `least` to `most`, but for less than 30 units.
Block3 turned_block(const Dot3& centre, std::int64_t least, std::int64_t most, Chance& chance) {
  const Frame3 frame = turned_frame(chance);
  const auto times = [&] { return chance.between(least, most) / frame.length; };
  const Dot3 u = times() * frame.u, v = times() * frame.v, w = times() * frame.w;
  return {centre - u - v - w, 2 * u, 2 * v, 2 * w};
}

// True iff a face of one lies in the plane of a face of the other.
bool share_a_plane(const Block3& a, const Block3& b) {
  const Faces3 faces_a = faces_of(a), faces_b = faces_of(b);
  return std::any_of(faces_a.begin(), faces_a.end(), [&](const auto& f) {
    return std::any_of(faces_b.begin(), faces_b.end(),
                       [&](const auto& g) { return plane_of(f[0], f[1], f[2]) == plane_of(g[0], g[1], g[2]); });
  });
}

}  // namespace

Scene3 generate_room_floating_3(const GeneratorRequest3& request) {
  const std::int64_t side = side_of_cube(request.n);
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  add_room_of_cells(canvas, side);
  std::int64_t made = 0;
  for (const std::int64_t cell : drawn(static_cast<std::int64_t>(request.n), side * side * side, chance)) {
    const Dot3 corner = corner_of_cell(cell, side);
    const auto low = [&] { return chance.between(20, 350); };
    const auto high = [&] { return chance.between(500, 980); };
    const Dot3 from{low(), low(), low()}, to{high(), high(), high()};
    canvas.add_block(numbered("box", made++), upright_block(corner + from, corner + to), kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

Scene3 generate_room_turned_3(const GeneratorRequest3& request) {
  const std::int64_t side = side_of_cube(request.n);
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  add_room_of_cells(canvas, side);
  std::int64_t made = 0;
  for (const std::int64_t cell : drawn(static_cast<std::int64_t>(request.n), side * side * side, chance)) {
    const auto middle = [&] { return kCell / 2 + chance.between(-30, 30); };
    const Dot3 centre = corner_of_cell(cell, side) + Dot3{middle(), middle(), middle()};
    // Half the diagonal is at most 250 sqrt 3 < 434, and the centre less than 52 from the middle.
    const Block3 block = turned_block(centre, 100, 250, chance);
    canvas.add_block(numbered("box", made++), block, kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

Scene3 generate_room_piercing_3(const GeneratorRequest3& request) {
  constexpr std::int64_t kClusterCell = 1500;
  const auto n = static_cast<std::int64_t>(request.n);
  const std::int64_t clusters = std::max<std::int64_t>(1, n / 3);
  const std::int64_t side = side_of_cube(static_cast<std::uint64_t>(clusters));
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  add_room_of_cells(canvas, side, kClusterCell);
  const std::vector<std::int64_t> cells = drawn(clusters, side * side * side, chance);
  std::int64_t made = 0;
  for (std::int64_t k = 0; k < clusters; ++k) {
    const Dot3 corner = corner_of_cell(cells[static_cast<std::size_t>(k)], side, kClusterCell);
    // Every box of the cluster has the middle of the cell in its inside: half its sides are more than 110 long, and its
    // centre is less than 104 away.
    std::vector<Block3> cluster;
    while (made < n * (k + 1) / clusters) {
      const auto middle = [&] { return kClusterCell / 2 + chance.between(-60, 60); };
      const Block3 block = turned_block(corner + Dot3{middle(), middle(), middle()}, 140, 370, chance);
      if (std::any_of(cluster.begin(), cluster.end(), [&](const Block3& b) { return share_a_plane(block, b); }))
        continue;
      cluster.push_back(block);
      canvas.add_block(numbered("box", made++), block, kPaints[chance.below(4)]);
    }
  }
  return canvas.finish(true);
}

}  // namespace hottel
