#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_views.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::illumination_test {
namespace {

using testing::Each;

const Rational kTiny(1, 1ul << 62);

TEST(IlluminationGrid2, EqualsTheAnglesOfTheExactVisibilityPolygon) {
  std::vector<Scene2> scenes{pillar_room()};
  for (unsigned seed = 1; seed <= 12; ++seed)
    scenes.push_back(random_lattice_scene(seed, 4 + 2 * static_cast<int>(seed)));
  GeneratorRequest2 request;
  request.kind = "room";
  request.n = 40;
  request.seed = 3;
  scenes.push_back(generate_2(request));
  std::size_t compared = 0;
  for (const Scene2& scene : scenes) {
    const Lit lit(scene, 3);
    Grid2 cells = default_grid(scene, 17);
    const Rational margin = (cells.max.x - cells.min.x) / 3;
    cells.min.x -= margin;
    cells.max.y += margin;
    const IlluminationGrid2 grid = lit.grid(cells);
    for (std::uint32_t iy = 0; iy < cells.ny; ++iy)
      for (std::uint32_t ix = 0; ix < cells.nx; ++ix) {
        const Point2 eye = cell_centre(cells, ix, iy);
        const Eye2 look(lit.prepared.arrangement.vertices(), lit.prepared.arrangement.vertices().from_scene(eye));
        View2 view;
        const auto kind = lit.location.look_around(look, view).kind;
        if (kind == Location2::Kind::kOnEdge || kind == Location2::Kind::kOnVertex) continue;
        if (solid_around(lit.prepared.arrangement, view) != Solids2::kNone) {
          ASSERT_TRUE(std::isnan(grid.at(ix, iy, 0)));
          continue;
        }
        for (std::uint32_t c = 0; c < 3; ++c)
          ASSERT_NEAR(grid.at(ix, iy, c), lit.reference(eye, c), 1e-14 * 10) << ix << " " << iy;
        ++compared;
      }
  }
  EXPECT_GT(compared, 3000u);
}

TEST(IlluminationGrid2, IsExactlyBWhereEverythingSeenSendsOutB) {
  const double b = 0.1;
  const Lit lit(square_room(), 1, b);
  EXPECT_THAT(lit.grid({{0, 0}, {1, 1}, 20, 30}).values, Each(b));
  Scene2 convex;
  add_polygon(convex, {{0, 0}, {-1, 3}, {2, 5}, {6, 4}, {7, 1}, {3, -1}});
  const Lit hexagon(convex, 1, b);
  EXPECT_EQ(hexagon.at(3, 2), b);
  EXPECT_EQ(hexagon.at(Rational(1, 3), Rational(1, 7)), b);
}

TEST(IlluminationGrid2, HalfOpenRoomsSeeTheSkyUnderItsAngle) {
  Scene2 scene;  // three walls of a square, open at the top
  add_edge(scene, {0, 0}, {0, 1});
  add_edge(scene, {1, 1}, {1, 0});
  add_edge(scene, {1, 0}, {0, 0});
  Lit lit(scene, 1, 0);
  lit.sky = {4};
  EXPECT_NEAR(lit.at(Rational(1, 2), Rational(1, 2)), 1.0, 1e-15);  // a quarter of the turn
  lit.by_element.assign(lit.by_element.size(), 2);
  EXPECT_NEAR(lit.at(Rational(1, 2), Rational(1, 2)), 2.5, 1e-15);
}

TEST(IlluminationGrid2, SeesAStraightEdgeUnderItsAngleFromOutside) {
  Scene2 scene;  // its front looks down
  add_edge(scene, {-1, 0}, {1, 0});
  Lit lit(scene, 1, 0);
  lit.by_element = {8, 8};
  EXPECT_NEAR(lit.at(0, -1), 2.0, 1e-15);
  EXPECT_EQ(lit.at(0, 1), 0.0);  // the black back
  EXPECT_EQ(lit.at(3, 0), 0.0);  // on its line
  lit.sky = {1};
  EXPECT_NEAR(lit.at(0, -1), 2.75, 1e-15);
  EXPECT_NEAR(lit.at(0, 1), 0.75, 1e-15);
  EXPECT_EQ(lit.at(3, 0), 1.0);
  EXPECT_NEAR(lit.at(-1000000, 1), 1.0, 1e-6);
}

TEST(IlluminationGrid2, IsBlackBehindBlackBacksAndOutsideRooms) {
  const Lit lit(pillar_room(), 2, 3);
  EXPECT_THAT(lit.grid({{Rational(2, 5), Rational(2, 5)}, {Rational(3, 5), Rational(3, 5)}, 4, 4}).values, Each(0.0));
  Lit dark(pillar_room(), 1, 3);
  dark.sky = {0};
  EXPECT_EQ(dark.at(-5, Rational(1, 2)), 0.0);
  EXPECT_EQ(dark.at(2, 2), 0.0);
}

TEST(IlluminationGrid2, OnAnEdgeIsTheMeanOfTheLimitsFromItsSides) {
  const Lit lit(pillar_room());
  const Rational x(1, 2), y(2, 5);
  const double mean = (lit.reference({x, y - kTiny}) + lit.reference({x, y + kTiny})) / 2;
  EXPECT_NEAR(lit.at(x, y), mean, 1e-13);
  EXPECT_NEAR(lit.at(0, x), lit.reference({kTiny, x}) / 2 + lit.reference({-kTiny, x}) / 2, 1e-13);

  std::size_t found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Lit random(random_lattice_scene(seed, 14));
    const Arrangement2& arrangement = random.prepared.arrangement;
    for (const Segment2& piece : arrangement.pieces()) {
      const Vertices2& vertices = arrangement.vertices();
      const Point2 a = vertices.to_scene(vertices.exact(piece.a)), b = vertices.to_scene(vertices.exact(piece.b));
      const Rational mx = (2 * a.x + b.x) / 3, my = (2 * a.y + b.y) / 3, nx = (a.y - b.y) * kTiny,
                     ny = (b.x - a.x) * kTiny;
      const double sides = (random.reference({mx + nx, my + ny}) + random.reference({mx - nx, my - ny})) / 2;
      ASSERT_NEAR(random.at(mx, my), sides, 1e-12) << seed;
      ++found;
    }
  }
  EXPECT_GT(found, 500u);
}

TEST(IlluminationGrid2, AtAVertexIsTheMeanOverTheDirectionsOfApproach) {
  std::vector<Scene2> scenes{pillar_room(), random_lattice_scene(5, 12), random_lattice_scene(8, 20)};
  Scene2 free_end;
  add_edge(free_end, {0, 0}, {1, 0}, true);
  add_edge(free_end, {-1, 2}, {2, 3}, true);
  scenes.push_back(free_end);
  for (const Scene2& scene : scenes) {
    const Lit lit(scene);
    const Vertices2& vertices = lit.prepared.arrangement.vertices();
    for (const VertexId v : IdRange<VertexId>(std::min<std::size_t>(vertices.size(), 12))) {
      const Point2 at = vertices.to_scene(vertices.exact(v));
      constexpr int kDirections = 400;
      double sum = 0;
      for (int k = 0; k < kDirections; ++k) {
        const double phi = 2 * std::numbers::pi * (k + 0.37) / kDirections;
        sum += lit.reference({at.x + Rational(std::cos(phi)) * kTiny, at.y + Rational(std::sin(phi)) * kTiny});
      }
      EXPECT_NEAR(lit.at(at.x, at.y), sum / kDirections, 0.03) << v.index();  // jumps: an error of one direction in 400
    }
  }
}

TEST(IlluminationGrid2, KnowsTheValuesAtACornerOfARoom) {
  Lit lit(square_room(), 1, 0);  // walls: left, top, right, bottom
  lit.by_element = {1, 0, 0, 0, 0, 0, 0, 0};
  lit.sky = {0};
  // Three quarters of the directions of approach are outside. From inside at the angle phi above the floor one sees
  // the left wall under pi/2 + phi, on average 3/4 pi.
  EXPECT_NEAR(lit.at(0, 0), 0.25 * 0.75 / 2, 1e-15);
  lit.by_element = {0, 0, 1, 0, 0, 0, 0, 0};  // the upper wall, seen under 45 degrees
  EXPECT_NEAR(lit.at(0, 0), 0.25 * 0.125, 1e-15);
}

TEST(IlluminationGrid2, IsDefinedEverywhereOnALatticeOfContacts) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Lit lit(random_lattice_scene(seed, 30));
    const IlluminationGrid2 grid = lit.grid(
        {{Rational(-1, 4), Rational(-1, 4)}, {Rational(35, 4), Rational(35, 4)}, 18, 18});  // centres: multiples of 1/2
    for (const double value : grid.values) {
      EXPECT_GE(value, 0.0);
      EXPECT_LT(value, 10.0 + 1e-12);
    }
  }
}

TEST(IlluminationGrid2, IsDefinedInScenesOnOneLine) {
  Scene2 scene;
  add_edge(scene, {0, 0}, {1, 0}, true);
  add_edge(scene, {2, 0}, {3, 0}, true);
  const Lit lit(scene, 1, 2);
  EXPECT_THAT(lit.grid({{Rational(-3, 4), -1}, {Rational(15, 4), 1}, 9, 3}).values,
              Each(testing::DoubleNear(2.0, 1e-14)));
  EXPECT_EQ(Lit(Scene2{}, 1, 2).at(5, 5), 2.0);
}

TEST(IlluminationGrid2, DoesNotDependOnTheThreads) {
  GeneratorRequest2 request;
  request.kind = "clutter";
  request.n = 60;
  request.seed = 2;
  const Lit lit(generate_2(request), 3);
  const Grid2 cells = default_grid(lit.prepared.scene, 150);
  const IlluminationGrid2 once = lit.grid(cells);
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(lit.grid(cells).values, once.values) << threads;
  }
}

TEST(IlluminationGrid2, CellsDoNotDependOnTheGridAroundThem) {
  const Lit lit(random_lattice_scene(4, 25));
  const Grid2 cells{{0, 0}, {8, 8}, 16, 8};  // some centres on edges and vertices
  const IlluminationGrid2 grid = lit.grid(cells);
  for (std::uint32_t iy = 0; iy < 8; ++iy)
    for (std::uint32_t ix = 0; ix < 16; ++ix) {
      const Point2 centre = cell_centre(cells, ix, iy);
      EXPECT_EQ(grid.at(ix, iy), lit.at(centre.x, centre.y)) << ix << " " << iy;
    }
}

TEST(IlluminationGrid2, BeginsWithTheLowestRow) {
  Scene2 scene;
  add_polygon(scene, {{0, 0}, {0, 2}, {3, 2}, {3, 0}});
  Lit lit(scene, 1, 0);
  lit.by_element[2 * 3] = 1;  // the floor
  const IlluminationGrid2 grid = lit.grid({{0, 0}, {3, 2}, 3, 2});
  EXPECT_EQ(grid.values.size(), 6u);
  EXPECT_GT(grid.values[1], grid.values[4]);
  EXPECT_EQ(grid.at(1, 0), grid.values[1]);
  EXPECT_NEAR(grid.at(0, 0), lit.reference({Rational(1, 2), Rational(1, 2)}), 1e-15);
}

TEST(IlluminationGrid2, ElementsSendOutWhatTheyHave) {
  Scene2 scene = square_room();
  scene.surfaces[1].elements = 2;
  Lit lit(scene, 1, 0);
  const auto label = [&](const std::string& name) {
    for (std::uint32_t k = 0; k < lit.table.count(); ++k)
      if (lit.table.elements()[k].name == name) return k;
    ADD_FAILURE() << name;
    return 0u;
  };
  lit.by_element[label("edge1#1")] = 8;  // the right half of the upper wall
  EXPECT_NEAR(lit.at(Rational(1, 2), Rational(1, 2)), 1.0, 1e-15);
  EXPECT_NEAR(lit.at(Rational(3, 4), Rational(3, 4)), 2.0, 1e-15);
}

TEST(IlluminationGrid2, ReportsProgressAndStops) {
  const Lit lit(pillar_room());
  std::vector<double> reports;
  illuminate_points(lit.prepared, {{0, 0}, {1, 1}, 256, 256}, lit.table, lit.sent_out(),
                    [&](double f) { reports.push_back(f); });
  EXPECT_GE(reports.size(), 3u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1.0);
  EXPECT_THROW(
      illuminate_points(lit.prepared, {{0, 0}, {1, 1}, 256, 256}, lit.table, lit.sent_out(), [](double) { throw 1; }),
      int);
  request_interrupt();
  EXPECT_THROW(lit.grid({{0, 0}, {1, 1}, 8, 8}), Interrupted);
  interrupt_flag = false;
}

TEST(DefaultGrid, HasSquareCellsOverTheBoundingBox) {
  Scene2 scene;
  add_edge(scene, {-1, 2}, {3, 5});
  Grid2 grid = default_grid(scene);
  EXPECT_EQ(grid.nx, 256u);
  EXPECT_EQ(grid.ny, 192u);
  EXPECT_EQ(grid.min, (Point2{-1, 2}));
  EXPECT_EQ(grid.max, (Point2{3, 5}));
  add_edge(scene, {0, 2}, {1, Rational(51, 10)});
  grid = default_grid(scene);
  EXPECT_EQ(grid.ny, 199u);  // 3.1 / (4 / 256) = 198.4
  EXPECT_EQ(grid.max.y, 2 + Rational(199, 64));
  scene.grids = {Grid2{{0, 0}, {1, 2}, 3, 4}};
  EXPECT_EQ(default_grid(scene).nx, 3u);
  EXPECT_EQ(grid_over(scene, 10, 20).max, (Point2{1, 2}));
  EXPECT_EQ(grid_over(scene, 10, 20).ny, 20u);
  scene.grids = {{{0, 0}, {1, 2}, 3, 4, "first"}, {{5, 5}, {6, 6}, 1, 1, "second"}};
  EXPECT_EQ(default_grid(scene), scene.grids.front());
  EXPECT_EQ(grid_over(scene, 10, 20), (Grid2{{0, 0}, {1, 2}, 10, 20, "first"}));
}

TEST(DefaultGrid, HasCellsEvenForFlatAndEmptyScenes) {
  Scene2 flat;
  add_edge(flat, {0, 1}, {4, 1});
  EXPECT_EQ(default_grid(flat).nx, 256u);
  EXPECT_EQ(default_grid(flat).ny, 1u);
  EXPECT_LT(grid_over(flat, 4, 4).min.y, grid_over(flat, 4, 4).max.y);
  EXPECT_LT(default_grid(Scene2{}).min.x, default_grid(Scene2{}).max.x);
  EXPECT_LT(grid_over(Scene2{}, 2, 3).min.y, grid_over(Scene2{}, 2, 3).max.y);
}

TEST(InverseSquare, EqualsTheSumOverSeenFractionsOfElements) {
  Scene2 scene = pillar_room();
  scene.surfaces[1].elements = 3;
  add_edge(scene, {Rational(1, 10), Rational(1, 2)}, {Rational(3, 10), Rational(7, 10)}, true);
  const Lit lit(scene);
  const Grid2 cells{{0, 0}, {1, 1}, 9, 7};
  const IlluminationGrid2 grid = illuminate_inverse_square(lit.prepared, cells, lit.table, lit.by_element, 1);
  for (std::uint32_t iy = 0; iy < cells.ny; ++iy)
    for (std::uint32_t ix = 0; ix < cells.nx; ++ix) {
      const Point2 eye = cell_centre(cells, ix, iy);
      double sum = 0;
      for (const auto& part : visibility_polygon(lit.prepared.arrangement, lit.location, eye).parts) {
        if (part.side == kSky) continue;
        const std::uint32_t label = lit.table.of(part.side);
        const Element& element = lit.table.elements()[label];
        if (!element.material) continue;
        const Edge2& edge = lit.prepared.scene.edges[element.surface];
        const Rational t = Rational(2 * element.part + 1) / Rational(2 * element.parts);
        const Point2 centre = point_at(edge, t);
        const Rational dx = centre.x - eye.x, dy = centre.y - eye.y;
        const double squared = std::max(to_double(dx * dx + dy * dy), 1.0 / 18 / 18);
        const double seen = std::hypot(to_double(part.to.x - part.from.x), to_double(part.to.y - part.from.y));
        sum += seen / element.area.value / squared * lit.by_element[label];
      }
      EXPECT_NEAR(grid.at(ix, iy), sum, 1e-12 * (1 + sum)) << ix << " " << iy;
    }
}

TEST(InverseSquare, KeepsHalfACellAwayFromTheMiddleOfAnEdge) {
  Scene2 scene;
  add_edge(scene, {1, Rational(1, 1000)}, {-1, Rational(1, 1000)});  // its front looks up
  const Lit lit(scene, 1, 3);
  const IlluminationGrid2 grid = illuminate_inverse_square(
      lit.prepared, {{-1, Rational(-1, 100)}, {1, Rational(1, 10)}, 1, 1}, lit.table, lit.by_element, 1);
  const double half = 0.055;
  EXPECT_NEAR(grid.values[0], 3 / (half * half), 1e-9);
}

}  // namespace
}  // namespace hottel::illumination_test
