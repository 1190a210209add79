// Random triangles in a room.
#include <array>
#include <set>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {

Scene3 generate_triangle_soup_3(const GeneratorRequest3& request) {
  constexpr std::int64_t kCell = 1000, kReach = 700, kMargin = 50;  // millimetres
  const auto n = static_cast<std::int64_t>(request.n) - 6;
  const std::int64_t side = side_of_cube(static_cast<std::uint64_t>(n));
  const std::int64_t length = (side - 1) * kCell + 2 * (kReach + kMargin);
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  canvas.add_room({length, length, length});
  canvas.look({length / 2, kMargin / 2, length / 2}, {length / 2, length, length / 2});
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kWood};
  // Triangles of one plane might overlap: each has a plane of its own. Those of the walls are out of reach.
  std::set<std::array<std::int64_t, 4>> planes;
  for (std::int64_t k = 0; k < n;) {
    const std::int64_t first = kMargin + kReach;
    const Dot3 centre{first + k % side * kCell, first + k / side % side * kCell, first + k / side / side * kCell};
    std::array<Dot3, 3> corners;
    for (Dot3& corner : corners) {
      const std::int64_t x = chance.between(-kReach, kReach), y = chance.between(-kReach, kReach),
                         z = chance.between(-kReach, kReach);
      corner = centre + Dot3{x, y, z};
    }
    const auto& [a, b, c] = corners;
    const Dot3 normal = cross(b - a, c - a);
    constexpr std::int64_t kLeastNormal = 200'000;  // a tenth of a square metre
    if (dot(normal, normal) < kLeastNormal * kLeastNormal) continue;
    if (!planes.insert(plane_of(a, b, c)).second) continue;
    canvas.begin(numbered("triangle", k++));
    canvas.add({a, b, c}, kPaints[chance.below(4)]);
  }
  return canvas.finish(true);
}

}  // namespace hottel
