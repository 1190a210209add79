// Hills under a sky, with buildings whose feet are in the ground.
#include <algorithm>
#include <array>
#include <vector>

#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::int64_t kTerrainCell = 1000, kFoot = 100;  // centimetres
constexpr std::int64_t kLotCells = 2;                     // along a side
constexpr std::int64_t kPolygonsOfABuilding = 6;

// Cells along a side: a tenth of the polygons is for buildings, the rest for two triangles a cell.
std::int64_t cells_for(std::uint64_t n) { return static_cast<std::int64_t>(integer_root((n - n / 10) / 2)); }

// Heights at the corners of cells: 0 along the border of the square, positive within.
class Heights {
 public:
  Heights(std::int64_t cells, Chance& chance)
      : cells_(cells), heights_(static_cast<std::size_t>((cells + 1) * (cells + 1)), 0) {
    const std::int64_t hills = 2 + cells / 2;
    for (std::int64_t hill = 0; hill < hills; ++hill) raise_hill(chance);
    for (std::int64_t j = 1; j < cells; ++j)
      for (std::int64_t i = 1; i < cells; ++i) at(i, j) += chance.between(10, 60);
  }

  std::int64_t operator()(std::int64_t i, std::int64_t j) const { return heights_[place(i, j)]; }

  // The least and the greatest height of the ground over a square of cells.
  std::array<std::int64_t, 2> range(std::int64_t i, std::int64_t j, std::int64_t side) const {
    std::array<std::int64_t, 2> range{(*this)(i, j), (*this)(i, j)};
    for (std::int64_t v = j; v <= j + side; ++v)
      for (std::int64_t u = i; u <= i + side; ++u)
        range = {std::min(range[0], (*this)(u, v)), std::max(range[1], (*this)(u, v))};
    return range;
  }

  Dot3 point(std::int64_t i, std::int64_t j) const { return {i * kTerrainCell, j * kTerrainCell, (*this)(i, j)}; }

 private:
  std::size_t place(std::int64_t i, std::int64_t j) const { return static_cast<std::size_t>(j * (cells_ + 1) + i); }
  std::int64_t& at(std::int64_t i, std::int64_t j) { return heights_[place(i, j)]; }

  // h (1 - r^2 / R^2)^2 within R of the middle, rounded down, which leaves the border at 0; the steepest slope of one
  // hill is below 0.25.
  void raise_hill(Chance& chance) {
    const std::int64_t radius = chance.between(3, std::max<std::int64_t>(3, cells_ / 4));  // cells
    const std::int64_t x = chance.between(radius, cells_ - radius);
    const std::int64_t y = chance.between(radius, cells_ - radius);
    const std::int64_t height = chance.between(5, 15) * radius * kTerrainCell / 100, square = radius * radius;
    for (std::int64_t j = std::max<std::int64_t>(1, y - radius); j < std::min(cells_, y + radius); ++j)
      for (std::int64_t i = std::max<std::int64_t>(1, x - radius); i < std::min(cells_, x + radius); ++i) {
        const std::int64_t rest = square - (i - x) * (i - x) - (j - y) * (j - y);
        if (rest > 0) at(i, j) += height * rest / square * rest / square;
      }
  }

  std::int64_t cells_;
  std::vector<std::int64_t> heights_;
};

// Two triangles for each cell, fronts upward, split one way and the other in turn.
void add_ground(GeneratorCanvas3& canvas, const Heights& heights, std::int64_t cells) {
  canvas.begin("ground");
  for (std::int64_t j = 0; j < cells; ++j)
    for (std::int64_t i = 0; i < cells; ++i) {
      const Dot3 a = heights.point(i, j), b = heights.point(i + 1, j), c = heights.point(i + 1, j + 1),
                 d = heights.point(i, j + 1);
      if ((i + j) % 2 == 0) {
        canvas.add({a, b, c}, kGrey);
        canvas.add({a, c, d}, kGrey);
      } else {
        canvas.add({a, b, d}, kGrey);
        canvas.add({b, c, d}, kGrey);
      }
    }
}

}  // namespace

Scene3 generate_terrain_3(const GeneratorRequest3& request) {
  const std::int64_t cells = cells_for(request.n), lots = cells / kLotCells;
  const std::int64_t buildings = (static_cast<std::int64_t>(request.n) - 2 * cells * cells) / kPolygonsOfABuilding;
  Chance chance(request.seed);
  const Heights heights(cells, chance);
  GeneratorCanvas3 canvas(request, 2);
  add_ground(canvas, heights, cells);
  const std::int64_t end = cells * kTerrainCell;
  canvas.look({end / 2, -end / 2, end / 2}, {end / 2, end / 2, 0});
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kWood};
  const std::vector<std::int64_t> chosen = drawn(buildings, lots * lots, chance);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const std::int64_t i = chosen[k] % lots * kLotCells, j = chosen[k] / lots * kLotCells;
    const auto [lowest, highest] = heights.range(i, j, kLotCells);
    const auto gap = [&chance] { return chance.between(130, 570); };
    const Dot3 corner{i * kTerrainCell, j * kTerrainCell, 0},
        opposite{(i + kLotCells) * kTerrainCell, (j + kLotCells) * kTerrainCell, 0};
    const Dot3 from{gap(), gap(), lowest - kFoot};
    const Dot3 to{-gap(), -gap(), highest + chance.between(300, 2000)};
    canvas.add_block(numbered("building", k), upright_block(corner + from, opposite + to), kPaints[chance.below(4)]);
  }
  const Rational half(1, 2), most(7, 10);
  return canvas.finish_under_sky({{half, most, 1}, false});
}

}  // namespace hottel
