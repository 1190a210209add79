// Cell averages against quadrature over the parts into which all lines through two vertices cut a cell.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/average_illumination.h"
#include "tests/oracle/plane/mean_light.h"
#include "tests/oracle/plane/random_scene.h"
#include "tests/solver/plane/solid_scenes.h"

namespace hottel::mean_light_against_oracle_test {
namespace {

double sent_out(int label) { return label < 0 ? 0 : 1 + (label * 7 % 10); }

Scene2 scene_of(const oracle::RandomScene& random) {
  Scene2 scene;
  for (int m = 0; m < 3; ++m) scene.materials.push_back({std::string(1, static_cast<char>('a' + m)), {}, {}});
  for (const oracle::InputSegment& edge : random.edges) {
    Surface surface;
    surface.name = "edge" + std::to_string(scene.surfaces.size());
    surface.material = static_cast<std::uint32_t>(edge.front_material);
    if (edge.back_material >= 0) surface.back = static_cast<std::uint32_t>(edge.back_material);
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.push_back(surface.name);
    scene.add(std::move(surface), {{edge.ax, edge.ay}, {edge.bx, edge.by}});
  }
  return scene;
}

bool is_black(const oracle::RandomScene& random, int label) {
  return label % 2 == 1 && random.edges[static_cast<std::size_t>(label / 2)].back_material < 0;
}

std::vector<oracle::LitSegment> lit_segments(const oracle::RandomScene& random) {
  std::vector<oracle::LitSegment> result;
  const auto real = [](const mpq_class& q) {
    return static_cast<long double>(q.get_num().get_d()) / static_cast<long double>(q.get_den().get_d());
  };
  for (const oracle::Segment& piece : oracle::split(random.edges).pieces)
    result.push_back({real(piece.ax), real(piece.ay), real(piece.bx), real(piece.by),
                      is_black(random, piece.left) ? 0 : sent_out(piece.left),
                      is_black(random, piece.right) ? 0 : sent_out(piece.right)});
  return result;
}

AverageIllumination2 averages(const oracle::RandomScene& random, const Grid2& cells, double sky) {
  const PreparedScene2 prepared = prepare(scene_of(random));
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  std::vector<double> radiosity;
  for (const Element& element : table.elements()) {
    const int edge = static_cast<int>(element.surface);
    radiosity.push_back(sent_out(element.is_back ? oracle::back_label(static_cast<std::size_t>(edge))
                                                 : oracle::front_label(static_cast<std::size_t>(edge))));
  }
  return illuminate_averages(prepared, cells,
                             FaceRadiosity2(prepared.arrangement, table, radiosity, std::vector<double>{sky}));
}

Rational lowest(const oracle::RandomScene& random) {
  Rational low = random.edges.front().ax;
  for (const auto& edge : random.edges)
    for (const mpq_class* c : {&edge.ax, &edge.ay, &edge.bx, &edge.by}) low = std::min<Rational>(low, *c);
  return low;
}

Rational highest(const oracle::RandomScene& random) {
  Rational high = random.edges.front().ax;
  for (const auto& edge : random.edges)
    for (const mpq_class* c : {&edge.ax, &edge.ay, &edge.bx, &edge.by}) high = std::max<Rational>(high, *c);
  return high;
}

// Every sixth cell of a grid that reaches beyond the scene: the largest distance from the oracle less both doubts.
void compare(bool lattice, double sky) {
  std::size_t compared = 0, sharp = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const oracle::RandomScene random = oracle::random_scene(seed, 5 + static_cast<int>(seed % 2), lattice);
    const Rational low = lowest(random), side = (highest(random) - low) / 6;
    const Grid2 cells{{low - side, low - side}, {low + 7 * side, low + 7 * side}, 8, 8};
    const AverageIllumination2 light = averages(random, cells, sky);
    const std::vector<oracle::LitSegment> segments = lit_segments(random);
    const auto x0 = static_cast<long double>(to_double(cells.min.x)), h = static_cast<long double>(to_double(side));
    for (std::size_t cell = seed % 6; cell < 64; cell += 6) {
      const auto ix = static_cast<long double>(cell % 8), iy = static_cast<long double>(cell / 8);
      const oracle::MeanLight mean =
          oracle::mean_light(segments, sky, x0 + ix * h, x0 + iy * h, x0 + (ix + 1) * h, x0 + (iy + 1) * h);
      const double rounding = 1e-14;  // of the corners of the oracle's cell
      EXPECT_LE(std::fabs(static_cast<double>(mean.value - light.grid.values[cell])),
                light.errors[cell] + static_cast<double>(mean.doubt) + rounding)
          << "seed " << seed << " cell " << cell;
      ++compared;
      sharp += mean.doubt < 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 80u);
  EXPECT_GT(sharp, compared / 2);
}

TEST(AverageIlluminationOracle, AgreesWithinItsBoundsOnLatticesOfContacts) {
  compare(true, 0);
  compare(true, 2.5);
}

TEST(AverageIlluminationOracle, AgreesWithinItsBoundsInGeneralPosition) {
  compare(false, 0);
  compare(false, 2.5);
}

// The oracle's mean over the whole cell, in which solids are black, over the share that is free.
TEST(AverageIlluminationOracle, AgreesWithinItsBoundsInCellsPartlyInSolids) {
  std::size_t compared = 0, cut = 0;
  for (const BoxRoom& room : box_rooms()) {
    if (room.scene.surfaces.size() > 13) continue;
    Lit lit(room.scene);
    lit.sky = {1.5};
    const Arrangement2& arrangement = lit.prepared.arrangement;
    std::vector<oracle::LitSegment> segments;
    for (std::size_t piece = 0; piece < arrangement.pieces().size(); ++piece) {
      const Vertices2& vertices = arrangement.vertices();
      const Point2 a = vertices.to_scene(vertices.exact(arrangement.pieces()[piece].a)),
                   b = vertices.to_scene(vertices.exact(arrangement.pieces()[piece].b));
      const auto sends = [&](PieceSideId side) { return arrangement.is_covered(side) ? 0.0 : lit.radiosity(side); };
      segments.push_back({to_double(a.x), to_double(a.y), to_double(b.x), to_double(b.y), sends(left_side(piece)),
                          sends(right_side(piece))});
    }
    const Grid2 cells{{0, 0}, {4, 3}, 6, 9};
    const AverageIllumination2 light = illuminate_averages(lit.prepared, cells, lit.faces());
    const Rational w(2, 3), h(1, 3);
    for (std::uint32_t cell = 0; cell < 54; ++cell) {
      const std::uint32_t ix = cell % 6, iy = cell / 6;
      const double share = free_share(room, w * ix, h * iy, w * (ix + 1), h * (iy + 1));
      if (share == 0 || (share == 1 && cell % 5 != 0)) continue;
      const long double x0 = 2.0L * ix / 3, y0 = 1.0L * iy / 3;
      const oracle::MeanLight mean = oracle::mean_light(segments, 1.5, x0, y0, x0 + 2.0L / 3, y0 + 1.0L / 3);
      EXPECT_NEAR(light.grid.values[cell], static_cast<double>(mean.value) / share,
                  light.errors[cell] + static_cast<double>(mean.doubt) / share + 1e-13)
          << room.name << " " << ix << " " << iy;
      ++compared;
      cut += share < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 80u);
  EXPECT_GT(cut, 30u);
}

}  // namespace
}  // namespace hottel::mean_light_against_oracle_test
