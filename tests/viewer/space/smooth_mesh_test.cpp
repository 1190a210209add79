// Corners where values of elements are blended: means by areas, corners within sides, creases, linear values.
#include "viewer/picture/space/smooth_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "viewer/picture/space/camera_view.h"

namespace hottel::smooth_mesh_test {
namespace {

struct LexicalLess {
  bool operator()(const Point3& a, const Point3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};

// Two squares side by side, of one element and of four, seen from above.
constexpr const char* kSquares = R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
  "polygons": [{"name": "a", "group": "g", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
    {"name": "b", "group": "g", "points": [[1,0,0],[2,0,0],[2,1,0],[1,1,0]], "material": "m", "elements": 2}]})";

struct Meshed {
  PreparedScene3 prepared;
  ElementTable3 table;
  SmoothMesh3 mesh;

  explicit Meshed(const std::string& text) : Meshed(parse_scene_3(text, "squares.json")) {}
  explicit Meshed(const Scene3& scene)
      : prepared(prepare(scene)),
        table(prepared.scene, prepared.arrangement(), prepared.occluders(), Granularity::kElement),
        mesh(prepared, table) {}

  // The value at the corners that lie at a point; nothing where there are none or their values differ.
  std::optional<double> at(const Point3& point, const std::vector<double>& by_element) const {
    const std::vector<double> values = mesh.at_corners(by_element, 1);
    std::optional<double> result;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!(mesh.corners()[k] == point)) continue;
      if (result && *result != values[k]) return std::nullopt;
      result = values[k];
    }
    return result;
  }
  std::vector<double> values(const std::vector<std::pair<std::string, double>>& named) const {
    std::vector<double> result(table.count(), 0);
    for (const auto& [name, value] : named)
      for (std::uint32_t i = 0; i < table.count(); ++i)
        if (table.elements()[i].name == name) result[i] = value;
    return result;
  }
};

TEST(SmoothMesh3, ACornerHasTheMeanByAreas) {
  const Meshed squares(kSquares);
  const std::vector<double> values = squares.values({{"a", 8}, {"b#0", 1}, {"b#1", 2}, {"b#2", 4}, {"b#3", 6}});
  EXPECT_EQ(*squares.at({0, 0, 0}, values), 8);
  EXPECT_NEAR(*squares.at({1, 0, 0}, values), (8 + 0.25 * 1) / 1.25, 1e-15);
  EXPECT_NEAR(*squares.at({1, 1, 0}, values), (8 + 0.25 * 4) / 1.25, 1e-15);
  EXPECT_NEAR(*squares.at({Rational(3, 2), Rational(1, 2), 0}, values), (1 + 2 + 4 + 6) / 4.0, 1e-15);
  EXPECT_NEAR(*squares.at({2, Rational(1, 2), 0}, values), (2 + 6) / 2.0, 1e-15);
}

// Of b's elements nothing is taken in the middle of a's side.
TEST(SmoothMesh3, AHangingCornerTakesTheCoarseSidesValue) {
  const Meshed squares(kSquares);
  ASSERT_EQ(squares.mesh.hanging().size(), 1u);
  EXPECT_EQ(squares.mesh.hanging()[0].share, 0.5);
  const std::vector<double> values = squares.values({{"a", 8}, {"b#0", 1}, {"b#1", 2}, {"b#2", 4}, {"b#3", 6}});
  const double below = *squares.at({1, 0, 0}, values), above = *squares.at({1, 1, 0}, values);
  EXPECT_NEAR(*squares.at({1, Rational(1, 2), 0}, values), (below + above) / 2, 1e-15);
  // Where a has no value b's elements stand alone.
  const std::vector<double> alone =
      squares.values({{"a", std::nan("")}, {"b#0", 1}, {"b#1", 2}, {"b#2", 4}, {"b#3", 6}});
  EXPECT_NEAR(*squares.at({1, Rational(1, 2), 0}, alone), (1 + 4) / 2.0, 1e-15);
  EXPECT_TRUE(std::isnan(*squares.at({0, 0, 0}, alone)));
}

TEST(SmoothMesh3, CornersWithinASideBelongToIt) {
  const Meshed squares(kSquares);
  std::size_t part = 0;
  while (squares.table.elements()[squares.table.parts()[part].label].name != "a") ++part;
  ASSERT_EQ(squares.mesh.ring(part).size(), 5u);
  const Point3& third = squares.mesh.corners()[squares.mesh.ring(part)[2]];
  EXPECT_TRUE(third == (Point3{1, Rational(1, 2), 0}));
}

// A quad that is no parallelogram, a triangle and a pentagon side by side, and an L beside them.
constexpr const char* kShapes =
    R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
    {"name": "quad", "group": "g", "points": [[0,0,0],[3,0,0],[2,2,0],[0,1,0]], "material": "m"},
    {"name": "triangle", "group": "g", "points": [[3,0,0],[5,1,0],[2,2,0]], "material": "m", "elements": 2},
    {"name": "pentagon", "group": "g", "points": [[0,1,0],[2,2,0],[2,4,0],[1,5,0],[-1,3,0]], "material": "m"},
    {"name": "L", "group": "g", "points": [[2,2,0],[5,1,0],[5,6,0],[4,6,0],[4,4,0],[2,4,0]], "material": "m"}]})";

// The triangle divided by 3: its corners lie within sides of its neighbours, and theirs within its sides.
std::string staggered() {
  std::string text = kShapes;
  return text.replace(text.find(R"("elements": 2)"), 13, R"("elements": 3)");
}

// Elements under random trees, a mesh of them, and the corners that each part has by itself.
struct RandomTrees {
  Meshed meshed;

  RandomTrees(const std::string& text, std::mt19937& random) : meshed(grown(text, random)) {}

  static Scene3 grown(const std::string& text, std::mt19937& random) {
    Scene3 scene = parse_scene_3(text, "shapes.json");
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      std::vector<TreeNode>& leaves = scene.surfaces[s].trees.front;
      const std::function<void(TreeNode)> grow = [&](const TreeNode& node) {
        if (node.path.depth() == 4 || random() % 2 == 0) {
          leaves.push_back(node);
          return;
        }
        for (int digit = 0; digit < 4; ++digit) grow({node.part, node.path.child(digit)});
      };
      for (std::uint32_t part = 0; part < root_count(scene.polygons[s], scene.surfaces[s].elements); ++part)
        grow({part, {}});
    }
    return scene;
  }

  const std::vector<Point3>& corners() const { return meshed.mesh.corners(); }
  std::size_t parts() const { return meshed.table.parts().size(); }
  bool is_drawn(std::size_t part) const { return !meshed.mesh.ring(part).empty(); }
  std::vector<Point3> own_corners(std::size_t part) const {
    return corners_of(meshed.prepared.occluders().vertices(), meshed.table.parts()[part].patch);
  }
  std::vector<double> random_values(std::mt19937& random, std::size_t channels) const {
    std::vector<double> result;
    std::uniform_real_distribution<double> value(0.1, 10);
    for (std::size_t k = 0; k < meshed.table.count() * channels; ++k) result.push_back(value(random));
    return result;
  }
};

bool is_within(const Point3& p, const Point3& a, const Point3& b) {
  return cross(p - a, b - a).is_zero() && dot(p - a, b - a) > 0 && dot(p - b, a - b) > 0;
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(to_double(a.x - b.x), to_double(a.y - b.y), to_double(a.z - b.z));
}

// (1), of elements divided where light ends: a corner in the side of a coarser element is in its ring, and has one
// value, so that the jump across inner edges is 0.
TEST(SmoothMesh3, InnerEdgesOfTreesHaveNoJump) {
  std::mt19937 random(11);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(round % 2 == 0 ? staggered() : kSquares, random);
    std::set<std::pair<Rational, Rational>> places;
    for (const Point3& corner : trees.corners())
      EXPECT_TRUE(places.emplace(corner.x, corner.y).second) << "one corner, and one value, at a point";
    EXPECT_FALSE(trees.meshed.mesh.hanging().empty()) << "sides with finer neighbours";
    for (std::size_t part = 0; part < trees.parts(); ++part) {
      const auto ring = trees.meshed.mesh.ring(part);
      for (std::size_t k = 0; k < ring.size(); ++k)
        for (const Point3& p : trees.corners())
          EXPECT_FALSE(is_within(p, trees.corners()[ring[k]], trees.corners()[ring[(k + 1) % ring.size()]]))
              << "a corner in a side that is none of its own";
    }
  }
}

// (3): with (1) the values of two neighbours along their common side are those between the ends of the longer one.
TEST(SmoothMesh3, ElementsOfTreesAreLinearAlongTheirSides) {
  std::mt19937 random(12);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(round % 2 == 0 ? kShapes : kSquares, random);
    const std::vector<double> values = trees.meshed.mesh.at_corners(trees.random_values(random, 1), 1);
    std::size_t within = 0;
    for (std::size_t part = 0; part < trees.parts(); ++part) {
      if (!trees.is_drawn(part)) continue;
      std::map<Point3, double, LexicalLess> at;
      for (const std::uint32_t corner : trees.meshed.mesh.ring(part))
        at.emplace(trees.corners()[corner], values[corner]);
      const std::vector<Point3> own = trees.own_corners(part);
      for (std::size_t k = 0; k < own.size(); ++k) {
        const Point3 &a = own[k], &b = own[(k + 1) % own.size()];
        for (const auto& [p, value] : at) {
          if (!is_within(p, a, b)) continue;
          ++within;
          EXPECT_NEAR(value, std::lerp(at.at(a), at.at(b), distance(a, p) / distance(a, b)), 1e-13);
        }
      }
    }
    EXPECT_GT(within, 0u);
  }
}

// (4).
TEST(SmoothMesh3, ValuesStayWithinThoseOfTheElements) {
  std::mt19937 random(13);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(staggered(), random);
    const std::vector<double> values = trees.random_values(random, 3);
    const std::vector<double> blended = trees.meshed.mesh.at_corners(values, 3);
    for (std::size_t c = 0; c < 3; ++c) {
      double least = 10, most = 0;
      for (std::size_t k = c; k < values.size(); k += 3) {
        least = std::min(least, values[k]);
        most = std::max(most, values[k]);
      }
      for (std::size_t k = c; k < blended.size(); k += 3) {
        EXPECT_GE(blended[k], least);
        EXPECT_LE(blended[k], most);
      }
    }
  }
}

TEST(SmoothMesh3, ConstantsAreReproducedExactly) {
  std::mt19937 random(14);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(staggered(), random);
    const double constant = 0.1 * (round + 1) / 3;
    for (const double value :
         trees.meshed.mesh.at_corners(std::vector<double>(trees.meshed.table.count(), constant), 1))
      EXPECT_EQ(value, constant);
  }
}

TEST(HangingCorners, AnAffineFieldAtTheCornersStays) {
  std::mt19937 random(15);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(kShapes, random);
    std::vector<double> values;
    for (const Point3& p : trees.corners()) values.push_back(1 + 2 * to_double(p.x) - 0.7 * to_double(p.y));
    std::vector<double> hung = values;
    for (const HangingCorner3& hanging : trees.meshed.mesh.hanging()) hung[hanging.corner] = 1e6;
    hang(trees.meshed.mesh.hanging(), 1, hung);
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(hung[k], values[k], 1e-13);
  }
}

TEST(HangingCorners, ComeAfterTheEndsOfTheirSides) {
  std::mt19937 random(16);
  for (int round = 0; round < 8; ++round) {
    const RandomTrees trees(kShapes, random);
    std::set<std::uint32_t> waiting;
    for (const HangingCorner3& hanging : trees.meshed.mesh.hanging()) waiting.insert(hanging.corner);
    for (const HangingCorner3& hanging : trees.meshed.mesh.hanging()) {
      EXPECT_FALSE(waiting.contains(hanging.from) || waiting.contains(hanging.to));
      waiting.erase(hanging.corner);
    }
    EXPECT_TRUE(waiting.empty());
  }
}

TEST(HangingCorners, OfSidesInACircleAreLeftOut) {
  // 1 hangs between 10 and 2, 2 between 10 and 3, 3 between 10 and 1: a circle. 4 hangs between 1 and 10 beside it, and
  // 1 waits for nothing outside of it. 5 is needed by the circle and waits for none.
  const std::vector<HangingCorner3> ordered =
      in_order({{4, 1, 10, 0.5}, {1, 5, 2, 0.5}, {2, 10, 3, 0.5}, {3, 10, 1, 0.5}, {5, 10, 11, 0.25}, {6, 4, 10, 0.5}});
  std::vector<std::uint32_t> corners;
  for (const HangingCorner3& hanging : ordered) corners.push_back(hanging.corner);
  EXPECT_EQ(corners, (std::vector<std::uint32_t>{4, 5, 6}));
}

// Four bricks around a square: nothing goes round for ever, and nothing jumps.
TEST(SmoothMesh3, BricksLaidAsAPinwheelKeepTheirMeans) {
  const Meshed pinwheel(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
    {"name": "a", "group": "g", "points": [[0,0,0],[2,0,0],[2,1,0],[0,1,0]], "material": "m"},
    {"name": "b", "group": "g", "points": [[2,0,0],[3,0,0],[3,2,0],[2,2,0]], "material": "m"},
    {"name": "c", "group": "g", "points": [[1,2,0],[3,2,0],[3,3,0],[1,3,0]], "material": "m"},
    {"name": "d", "group": "g", "points": [[0,1,0],[1,1,0],[1,3,0],[0,3,0]], "material": "m"},
    {"name": "e", "group": "g", "points": [[1,1,0],[2,1,0],[2,2,0],[1,2,0]], "material": "m"}]})");
  EXPECT_TRUE(pinwheel.mesh.hanging().empty());
  const std::vector<double> values = pinwheel.values({{"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}, {"e", 10}});
  EXPECT_NEAR(*pinwheel.at({1, 1, 0}, values), (2 * 1 + 2 * 4 + 10) / 5.0, 1e-15);
}

TEST(SmoothMesh3, SurfacesThatAreNotOneStayApart) {
  const auto is_apart = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.rfind(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const Meshed squares(text);
    const std::vector<double> values = squares.values({{"a", 8}, {"b#0", 1}, {"b#2", 1}, {"b#1", 1}, {"b#3", 1}});
    return squares.at({1, 0, 0}, values) == 1;
  };
  const std::string two = std::string(kSquares);
  EXPECT_FALSE(is_apart(two, "0.5", "0.25"));
  EXPECT_TRUE(is_apart(two, R"("group": "g", )", ""));                                               // of no group
  EXPECT_TRUE(is_apart(two, "[2,0,0],[2,1,0]", "[2,0,1],[2,1,1]"));                                  // a crease
  EXPECT_TRUE(is_apart(two, "[1,0,0],[2,0,0],[2,1,0],[1,1,0]", "[1,0,0],[1,1,0],[2,1,0],[2,0,0]"));  // turned over
  std::string other = two;
  other.replace(other.find(R"({"m":)"), 5, R"({"n": {"reflectivity": 0.25}, "m":)");
  EXPECT_TRUE(is_apart(other, R"("material": "m", "elements")", R"("material": "n", "elements")"));
}

Camera3 above(std::uint32_t pixels) {
  Camera3 camera;
  camera.eye = {1, Rational(1, 2), 2};
  camera.target = {1, Rational(1, 2), 0};
  camera.up = {0, 1, 0};
  camera.field_of_view = 80;
  camera.width = camera.height = pixels;
  return camera;
}

ElementPaint3 plain_paint(std::vector<double> values) {
  return {.channels = 1, .values = std::move(values), .scale = {}, .unknown = {0}, .black = {0}, .sky = {-1e6}};
}

// From pixel to pixel nothing jumps, not at the corner in the side of a either; each element by itself is flat.
TEST(CameraView3, BlendedValuesHaveNoSteps) {
  const Meshed squares(kSquares);
  const ElementPaint3 paint = plain_paint(squares.values({{"a", 8}, {"b#0", 1}, {"b#1", 2}, {"b#2", 4}, {"b#3", 6}}));
  const auto largest_step = [&](const SmoothMesh3* mesh) {
    constexpr std::uint32_t kPixels = 480;
    const PixelValues3 pixels = camera_view_3({squares.prepared, squares.table, paint, mesh}, above(kPixels));
    double step = 0;
    for (std::uint32_t y = 1; y < kPixels; ++y)
      for (std::uint32_t x = 1; x < kPixels; ++x) {
        const double here = pixels.at(x, y)[0], left = pixels.at(x - 1, y)[0], up = pixels.at(x, y - 1)[0];
        if (here < 1 || left < 1 || up < 1) continue;  // the border, and the ground beside it
        step = std::max({step, std::fabs(here - left), std::fabs(here - up)});
      }
    return step;
  };
  EXPECT_GT(largest_step(nullptr), 1);
  // A pixel is 4 tan 40° / 480 = 0.007 wide; no triangle is steeper than some 8 / 0.25.
  EXPECT_LT(largest_step(&squares.mesh), 0.007 * 8 / 0.25);
  EXPECT_GT(largest_step(&squares.mesh), 0);
}

// Values of elements that are linear in their middles are so wherever elements are around.
TEST(CameraView3, LinearValuesStayLinear) {
  const Meshed floor(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
    {"name": "f", "points": [[0,0,0],[2,0,0],[2,1,0],[0,1,0]], "material": "m", "elements": 6}]})");
  const auto truth = [](double x, double y) { return 1 + 2 * x - 0.5 * y; };
  std::vector<double> values(floor.table.count(), 0);
  for (std::uint32_t k = 0; k < 36; ++k) values[k] = truth((k % 6 + 0.5) / 3, (k / 6 + 0.5) / 6.0);
  const ElementPaint3 paint = plain_paint(values);
  Camera3 camera = above(64);
  camera.eye = {Rational(1, 2), Rational(1, 4), 1};  // askew
  const PixelValues3 pixels = camera_view_3({floor.prepared, floor.table, paint, &floor.mesh}, camera);
  // Directions of pixels by hand.
  const double fx = 0.5, fy = 0.25, fz = -1, length = std::sqrt(fx * fx + fy * fy + fz * fz);
  const double f[3] = {fx / length, fy / length, fz / length};
  double r[3] = {f[1] * 0 - f[2] * 1, f[2] * 0 - f[0] * 0, f[0] * 1 - f[1] * 0};  // forward x up (0, 1, 0)
  const double n = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  for (double& c : r) c /= n;
  const double u[3] = {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]};
  const double half = std::tan(40 * std::acos(-1) / 180);
  int inner = 0;
  for (std::uint32_t py = 0; py < 64; ++py)
    for (std::uint32_t px = 0; px < 64; ++px) {
      const auto place = [&](double sx, double sy) {
        const double a = (2 * sx / 64 - 1) * half, b = (1 - 2 * sy / 64) * half;
        const double t = -1 / (f[2] + a * r[2] + b * u[2]);
        return std::pair(0.5 + t * (f[0] + a * r[0] + b * u[0]), 0.25 + t * (f[1] + a * r[1] + b * u[1]));
      };
      bool is_inner = true;
      for (const double dx : {0.0, 1.0})
        for (const double dy : {0.0, 1.0}) {
          const auto [x, y] = place(px + dx, py + dy);
          is_inner = is_inner && x > 1.0 / 3 && x < 5.0 / 3 && y > 1.0 / 6 && y < 5.0 / 6;
        }
      if (!is_inner) continue;
      ++inner;
      const auto [x, y] = place(px + 0.5, py + 0.5);
      // Of a pixel that triangles share each has the value in the middle of its part: all but the value of the middle.
      EXPECT_NEAR(pixels.at(px, py)[0], truth(x, y), 2e-3) << px << ' ' << py;
    }
  EXPECT_GT(inner, 200);
}

}  // namespace
}  // namespace hottel::smooth_mesh_test
