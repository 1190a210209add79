// Cubes in each other.
#include <array>
#include <vector>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {

Scene3 generate_nested_cubes_3(const GeneratorRequest3& request) {
  constexpr std::int64_t kInnermost = 400, kGap = 300;  // millimetres: the gaps on two opposite sides are kGap together
  const auto n = static_cast<std::int64_t>(request.n);
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  const auto gap = [&] { return chance.between(60, kGap - 60); };
  Dot3 corner;
  for (std::int64_t k = 0; k < n; ++k) {
    const std::int64_t side = kInnermost + (n - 1 - k) * kGap;
    const Block3 cube = upright_block(corner, corner + Dot3{side, side, side});
    const Paint paint = kPaints[chance.below(4)];
    if (k % 2 == 0)
      canvas.add_inward(numbered("cube", k), cube, {paint, kLamp, paint, paint, paint, paint});
    else
      canvas.add_block(numbered("cube", k), cube, paint);
    const std::int64_t x = gap(), y = gap(), z = gap();
    corner = corner + Dot3{x, y, z};
  }
  return canvas.finish(true);
}

}  // namespace hottel
