// A town: a building on each lot, in rows.
#include <array>
#include <random>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kLotsInARow = 25, kPlot = 80, kGap = 8;  // quarters of a metre
constexpr std::int64_t kQuarter = 25;                           // centimetres
constexpr std::uint32_t kGroundElements = 20, kFaceElements = 2;

// Whole numbers by remainders, not those of Chance: the towns of which benchmark results are kept were drawn so.
class Remainders {
 public:
  explicit Remainders(std::uint64_t seed) : engine_(seed) {}
  // A number in [low, high]. REQUIRES: low <= high.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

// Bottom, top, and the sides around.
void add_building(GeneratorCanvas3& canvas, const Block3& block, bool has_bottom, Paint paint) {
  const Faces3 faces = faces_of(block);
  const auto [bottom, top, west, east, south, north] = std::array<std::size_t, 6>{0, 1, 2, 3, 4, 5};
  for (const std::size_t f : {bottom, top, south, east, north, west}) {
    if (f == bottom && !has_bottom) continue;
    const auto& [a, b, c, d] = faces[f];
    if (f == north || f == west)
      canvas.add({d, a, b, c}, paint);
    else
      canvas.add({a, b, c, d}, paint);
  }
}

}  // namespace

Scene3 generate_town_3(const GeneratorRequest3& request) {
  const auto n = static_cast<std::int64_t>(request.n);
  const std::int64_t rows = (n + kLotsInARow - 1) / kLotsInARow;
  const Dot3 far{kLotsInARow * kPlot * kQuarter, rows * kPlot * kQuarter, 0};
  Remainders remainders(request.seed);
  GeneratorCanvas3 canvas(request, 2);
  canvas.divide(kGroundElements);
  canvas.begin("ground");
  canvas.add({{0, 0, 0}, {far.x, 0, 0}, far, {0, far.y, 0}}, kGrey);
  canvas.look({far.x / 2, -20'000, 20'000}, {far.x / 2, far.y / 3, 1'000});
  canvas.divide(kFaceElements);
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  for (std::int64_t k = 0; k < n; ++k) {
    const std::int64_t width = remainders.between(32, 56), depth = remainders.between(32, 56);
    const std::int64_t height = remainders.between(24, 160);
    const std::int64_t x = k % kLotsInARow * kPlot + remainders.between(kGap, kPlot - kGap - width);
    const std::int64_t y = k / kLotsInARow * kPlot + remainders.between(kGap, kPlot - kGap - depth);
    canvas.begin(numbered("building", k));
    add_building(canvas, upright_block(kQuarter * Dot3{x, y, 0}, kQuarter * Dot3{x + width, y + depth, height}),
                 request.has_bottoms, kPaints[static_cast<std::size_t>(k % 4)]);
  }
  const Rational half(1, 2), most(7, 10);
  return canvas.finish_under_sky({{half, most, 1}, false});
}

}  // namespace hottel
