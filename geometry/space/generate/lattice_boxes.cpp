// Boxes with corners on a lattice.
#include <algorithm>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {

Scene3 generate_lattice_boxes_3(const GeneratorRequest3& request) {
  // Sides of 1 to 3, on average 8 units of volume a box: about half of the room is solid, and most boxes meet others.
  const std::int64_t side = std::max<std::int64_t>(4, 2 * side_of_cube(request.n));
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 0);
  canvas.add_inward("room", upright_block({0, 0, 0}, {side, side, side}), {kGlow, kGlow, kGlow, kGlow, kGlow, kGlow});
  for (std::uint64_t k = 0; k < request.n; ++k) {
    const auto length = [&] { return chance.between(1, 3); };
    const Dot3 size{length(), length(), length()};
    const auto place = [&](std::int64_t s) { return chance.between(0, side - s); };
    const std::int64_t x = place(size.x), y = place(size.y), z = place(size.z);
    const Dot3 corner{x, y, z};
    canvas.add_block(numbered("box", k), upright_block(corner, corner + size), kGlow);
  }
  return canvas.finish(true);
}

}  // namespace hottel
