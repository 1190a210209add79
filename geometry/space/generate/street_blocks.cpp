// Buildings along streets.
#include <array>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kLot = 200, kStreet = 140;       // decimetres
constexpr std::int64_t kLotsAcross = 3, kLotsDeep = 2;  // of a block between streets

std::int64_t place_of(std::int64_t lot, std::int64_t lots_of_a_block) {
  return lot * kLot + lot / lots_of_a_block * kStreet;
}

}  // namespace

Scene3 generate_street_blocks_3(const GeneratorRequest3& request) {
  const auto n = static_cast<std::int64_t>(request.n);
  const std::int64_t columns = side_of_square(request.n), rows = (n + columns - 1) / columns;
  const Dot3 far{place_of(columns - 1, kLotsAcross) + kLot + kStreet, place_of(rows - 1, kLotsDeep) + kLot + kStreet,
                 0};
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 1);
  canvas.begin("ground");
  canvas.add({{-kStreet, -kStreet, 0}, {far.x, -kStreet, 0}, far, {-kStreet, far.y, 0}}, kGrey);
  canvas.look({far.x / 2, -2 * kStreet, 1000}, {far.x / 2, far.y / 3, 100});
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  for (std::int64_t k = 0; k < n; ++k) {
    const Dot3 corner{place_of(k % columns, kLotsAcross), place_of(k / columns, kLotsDeep), 0};
    const auto gap = [&] { return chance.between(5, 50); };
    const bool is_tower = chance.below(10) == 0;
    const Dot3 from{gap(), gap(), 0};
    const Dot3 to{kLot - gap(), kLot - gap(), is_tower ? chance.between(300, 900) : chance.between(60, 250)};
    canvas.add_standing(numbered("building", k), upright_block(corner + from, corner + to), kPaints[chance.below(4)]);
  }
  const Rational half(1, 2), most(7, 10);
  return canvas.finish_under_sky({{half, most, 1}, false});
}

}  // namespace hottel
