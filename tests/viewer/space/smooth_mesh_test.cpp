// Corners where values of elements are blended: means by angles, corners within sides, creases, linear values.
#include "viewer/picture/space/smooth_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "viewer/picture/space/camera_view.h"

namespace hottel {
namespace {

// Two squares side by side, of one element and of four, seen from above.
constexpr const char* kSquares = R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
  "polygons": [{"name": "a", "group": "g", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
    {"name": "b", "group": "g", "points": [[1,0,0],[2,0,0],[2,1,0],[1,1,0]], "material": "m", "elements": 2}]})";

struct Meshed {
  PreparedScene3 prepared;
  ElementTable3 table;
  SmoothMesh3 mesh;

  explicit Meshed(const std::string& text)
      : prepared(prepare(parse_scene_3(text, "squares.json"))),
        table(prepared.scene, prepared.arrangement(), prepared.blockers(), Granularity::kElement),
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

TEST(SmoothMesh3, ACornerHasTheMeanByAngles) {
  const Meshed squares(kSquares);
  const std::vector<double> values = squares.values({{"a", 8}, {"b#0", 1}, {"b#1", 2}, {"b#2", 4}, {"b#3", 6}});
  EXPECT_NEAR(*squares.at({0, 0, 0}, values), 8, 1e-15);
  EXPECT_NEAR(*squares.at({1, 0, 0}, values), (8 + 1) / 2.0, 1e-15);
  EXPECT_NEAR(*squares.at({1, 1, 0}, values), (8 + 4) / 2.0, 1e-15);
  EXPECT_NEAR(*squares.at({Rational(3, 2), Rational(1, 2), 0}, values), (1 + 2 + 4 + 6) / 4.0, 1e-15);
  EXPECT_NEAR(*squares.at({2, Rational(1, 2), 0}, values), (2 + 6) / 2.0, 1e-15);
  // In the middle of a side of a: half of all angles are a's.
  EXPECT_NEAR(*squares.at({1, Rational(1, 2), 0}, values), 8 / 2.0 + (1 + 4) / 4.0, 1e-14);
}

TEST(SmoothMesh3, CornersWithinASideBelongToIt) {
  const Meshed squares(kSquares);
  std::size_t part = 0;
  while (squares.table.elements()[squares.table.parts()[part].label].name != "a") ++part;
  ASSERT_EQ(squares.mesh.ring(part).size(), 5u);
  const Point3& third = squares.mesh.corners()[squares.mesh.ring(part)[2]];
  EXPECT_TRUE(third == (Point3{1, Rational(1, 2), 0}));
}

// (1), of elements divided where light ends: a corner in the side of a coarser element is one of its corners, and has
// one value, so that the jump across inner edges is 0.
TEST(SmoothMesh3, InnerEdgesOfTreesHaveNoJump) {
  std::mt19937 random(11);
  for (int round = 0; round < 10; ++round) {
    Scene3 scene = parse_scene_3(kSquares, "squares.json");
    for (std::size_t s = 0; s < 2; ++s) {
      std::vector<TreeNode>& leaves = scene.surfaces[s].trees.front;
      const std::function<void(TreeNode)> grow = [&](const TreeNode& node) {
        if (node.path.depth() == 4 || random() % 2 == 0) {
          leaves.push_back(node);
          return;
        }
        for (int digit = 0; digit < 4; ++digit) grow({node.part, node.path.child(digit)});
      };
      for (std::uint32_t part = 0; part < scene.surfaces[s].elements * scene.surfaces[s].elements; ++part)
        grow({part, {}});
    }
    const PreparedScene3 prepared = prepare(scene);
    const ElementTable3 table(prepared.scene, prepared.arrangement(), prepared.blockers(), Granularity::kElement);
    const SmoothMesh3 mesh(prepared, table);
    std::set<std::pair<Rational, Rational>> places;
    for (const Point3& corner : mesh.corners())
      EXPECT_TRUE(places.emplace(corner.x, corner.y).second) << "one corner, and one value, at a point";
    std::size_t hanging = 0;
    for (std::size_t part = 0; part < table.parts().size(); ++part) {
      const auto ring = mesh.ring(part);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point3 &a = mesh.corners()[ring[k]], &b = mesh.corners()[ring[(k + 1) % ring.size()]];
        const Point3& before = mesh.corners()[ring[(k + ring.size() - 1) % ring.size()]];
        hanging += cross(a - before, b - a).is_zero() ? 1 : 0;
        for (const Point3& p : mesh.corners()) {
          const bool is_inside = cross(p - a, b - a).is_zero() && dot(p - a, b - a) > 0 && dot(p - b, a - b) > 0;
          EXPECT_FALSE(is_inside) << "a corner in a side that is none of its own";
        }
      }
    }
    EXPECT_GT(hanging, 0u) << "sides with finer neighbours";
  }
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
}  // namespace hottel
