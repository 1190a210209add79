// Item buffers: what they show against brute force, and by OpenGL against software.
#include "solver/space/methods/item_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::item_buffer_test {
namespace {

constexpr std::uint32_t kNothing = 0xfffffffe;

struct Items {
  PreparedScene3 prepared;
  ElementGeometry3 geometry;
  SideElements3 items;

  Items(const std::string& name, std::uint32_t elements)
      : prepared(ready(name, elements)), geometry(prepared), items(prepared, geometry.table()) {}

  static PreparedScene3 ready(const std::string& name, std::uint32_t elements) {
    Scene3 scene = std::get<ValidScene3>(read_scene(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name));
    divide_into(scene, elements);
    return prepare(std::move(scene));
  }
};

// What a direction (x, y, 1) meets among the items of a label: how far out it is, and how near to an edge, in pixels.
struct Meeting {
  bool is_met = false;
  double distance = std::numeric_limits<double>::infinity();  // along `out`
  double to_edge = std::numeric_limits<double>::infinity();
};

Meeting meeting(const ElementPatch3& patch, const CubeSide3& side, const SideElements3& items, std::uint32_t label,
                double x, double y, std::uint32_t resolution) {
  Meeting result;
  for_items_3(patch, side, items, [&](std::span<const Vector3d> seen, std::uint32_t of) {
    if (of != label) return;
    bool is_inside = true;
    Vector3d normal;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const Vector3d &a = seen[k], &b = seen[k + 1 == seen.size() ? 0 : k + 1], edge = cross(a, b);
      const double value = edge.x * x + edge.y * y + edge.z;
      is_inside = is_inside && value > 0;
      normal = normal + cross(a - seen[0], b - seen[0]);
      // The point of the line through the edge that is next to the direction, where it is on the edge or close to it.
      const double slope = std::hypot(edge.x, edge.y);
      if (slope > 0) result.to_edge = std::min(result.to_edge, std::fabs(value) / slope * resolution / 2);
    }
    if (!is_inside) return;
    const double distance = dot(normal, seen[0]) / (normal.x * x + normal.y * y + normal.z);
    result.is_met = true;
    result.distance = std::min(result.distance, distance);
  });
  return result;
}

double centre(std::size_t pixel, std::uint32_t resolution) {
  return (2.0 * static_cast<double>(pixel) + 1 - resolution) / resolution;
}

TEST(ItemBuffer3, ShowsTheNearestItemInEachPixel) {
  const Items scene("room_turned.json", 1);
  const std::uint32_t resolution = 8;
  const auto buffer = software_item_buffer_3(resolution);
  std::size_t checked = 0;
  for (const ElementPatch3& patch : scene.geometry.all_patches())
    for (const CubeSide3& side : sides_over_3(patch, resolution)) {
      const auto labels = buffer->draw(patch, side, scene.items, kNothing);
      ASSERT_EQ(labels.size(), std::size_t{resolution} * (resolution - side.first_row));
      for (std::size_t k = 0; k < labels.size(); ++k) {
        const double x = centre(k % resolution, resolution), y = centre(side.first_row + k / resolution, resolution);
        std::uint32_t nearest = kNothing;
        double distance = std::numeric_limits<double>::infinity();
        bool is_in_doubt = false;
        for (std::uint32_t label = 0; label < scene.geometry.count(); ++label) {
          const Meeting m = meeting(patch, side, scene.items, label, x, y, resolution);
          is_in_doubt = is_in_doubt || m.to_edge < 1e-9 || std::fabs(m.distance - distance) < 1e-9 * distance;
          if (m.is_met && m.distance < distance) {
            distance = m.distance;
            nearest = label;
          }
        }
        if (is_in_doubt) continue;
        ++checked;
        EXPECT_EQ(labels[k], nearest);
      }
    }
  EXPECT_GT(checked, 5000u);
}

// Where the two differ the centre is next to an edge of what one of them shows, or both items are equally far.
TEST(ItemBuffer3, ByOpenGlDiffersOnlyNextToEdgesAndWhereDepthsAreEqual) {
  constexpr double kEdge = 0x1p-7, kDepth = 0x1p-20;
  for (const std::uint32_t resolution : {64u, 256u}) {
    std::unique_ptr<ItemBuffer3> by_gl;
    try {
      by_gl = gl_item_buffer_3(resolution);
    } catch (const RequestError& error) {
      // What a machine without OpenGL is told; there is nothing to compare.
      EXPECT_NE(std::string(error.what()).find("without :egl the hemicube is drawn in software"), std::string::npos);
      return;
    }
    const auto software = software_item_buffer_3(resolution);
    for (const char* name : {"room_turned.json", "two_boxes.json", "crate.vs3"}) {
      const Items scene(name, 2);
      std::size_t pixels = 0, different = 0, wrong = 0;
      for (const ElementPatch3& patch : scene.geometry.all_patches())
        for (const CubeSide3& side : sides_over_3(patch, resolution)) {
          const auto one = software->draw(patch, side, scene.items, kNothing);
          const auto other = by_gl->draw(patch, side, scene.items, kNothing);
          ASSERT_EQ(one.size(), other.size());
          pixels += one.size();
          for (std::size_t k = 0; k < one.size(); ++k) {
            if (one[k] == other[k]) continue;
            ++different;
            const double x = centre(k % resolution, resolution),
                         y = centre(side.first_row + k / resolution, resolution);
            const Meeting a = meeting(patch, side, scene.items, one[k], x, y, resolution);
            const Meeting b = meeting(patch, side, scene.items, other[k], x, y, resolution);
            const bool is_near_edge = std::min(a.to_edge, b.to_edge) <= kEdge;
            const bool is_equally_far =
                a.is_met && b.is_met && std::fabs(a.distance - b.distance) <= kDepth * std::max(a.distance, b.distance);
            wrong += is_near_edge || is_equally_far ? 0 : 1;
          }
        }
      EXPECT_EQ(wrong, 0u) << name << ", " << resolution << " pixels: of " << pixels << " differ " << different;
      EXPECT_LT(static_cast<double>(different), 1e-2 * static_cast<double>(pixels)) << name;
    }
  }
}

}  // namespace
}  // namespace hottel::item_buffer_test
