#include "solver/space/methods/item_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hottel {
namespace {

// Items and how near they are, pixel by pixel.
class SoftwareItemBuffer3 final : public ItemBuffer3 {
 public:
  explicit SoftwareItemBuffer3(std::uint32_t resolution)
      : resolution_(resolution), label_(std::size_t{resolution} * resolution), nearness_(label_.size()) {}

  std::span<const std::uint32_t> draw(const ElementPatch3& patch, const CubeSide3& side, const SideElements3& items,
                                      std::uint32_t background) override {
    std::fill(label_.begin(), label_.end(), background);
    std::fill(nearness_.begin(), nearness_.end(), 0.0);
    for_items_3(patch, side, items,
                [&](std::span<const Vector3d> corners, std::uint32_t label) { add(corners, side.first_row, label); });
    return std::span(label_).subspan(std::size_t{side.first_row} * resolution_);
  }

 private:
  void add(std::span<const Vector3d> corners, std::uint32_t first_row, std::uint32_t label) {
    if (misses(corners, first_row)) return;
    // x n.x + y n.y + n.z >= 0 for all edges is the cone of the item; the opposite edge of a neighbour has exactly -n.
    edges_.clear();
    Vector3d normal;
    for (std::size_t k = 0; k < corners.size(); ++k)
      edges_.push_back(cross(corners[k], corners[k + 1 == corners.size() ? 0 : k + 1]));
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      normal = normal + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    const double distance = dot(normal, corners[0]);
    if (distance == 0) return;
    for (std::uint32_t row = first_row; row < resolution_; ++row) draw_row(row, 1 / distance * normal, label);
  }

  double centre(std::uint32_t pixel) const { return (2.0 * pixel + 1 - resolution_) / resolution_; }

  // Whether all corners are beyond one border of the side.
  static bool misses(std::span<const Vector3d> corners, std::uint32_t first_row) {
    const auto all = [corners](auto is_beyond) { return std::all_of(corners.begin(), corners.end(), is_beyond); };
    return all([](const Vector3d& c) { return c.z <= 0; }) || all([](const Vector3d& c) { return c.x >= c.z; }) ||
           all([](const Vector3d& c) { return -c.x >= c.z; }) || all([](const Vector3d& c) { return c.y >= c.z; }) ||
           all([first_row](const Vector3d& c) { return first_row > 0 ? c.y <= 0 : -c.y >= c.z; });
  }

  // A centre on an edge belongs to the item on the side of the edge's normal that a fixed rule names.
  static bool is_inside(const Vector3d& edge, double x, double y) {
    const double value = edge.x * x + (edge.y * y + edge.z);
    return value > 0 || (value == 0 && (edge.x > 0 || (edge.x == 0 && edge.y > 0)));
  }

  void draw_row(std::uint32_t row, const Vector3d& nearness, std::uint32_t label) {
    const double y = centre(row);
    double from = -1, to = 1;
    for (const Vector3d& edge : edges_) {
      const double constant = edge.y * y + edge.z;
      if (edge.x > 0) from = std::max(from, -constant / edge.x);
      if (edge.x < 0) to = std::min(to, -constant / edge.x);
      if (edge.x == 0 && constant < 0) return;
    }
    if (!(from <= to)) return;
    const auto pixel = [this](double x) {
      return static_cast<std::int64_t>(std::floor((x + 1) / 2 * static_cast<double>(resolution_)));
    };
    const std::int64_t first = std::max<std::int64_t>(pixel(from) - 1, 0);
    const std::int64_t last = std::min<std::int64_t>(pixel(to) + 1, resolution_ - 1);
    for (std::int64_t column = first; column <= last; ++column) {
      const double x = centre(static_cast<std::uint32_t>(column));
      // Between the ends all centres are inside: only those next to them are in doubt.
      if (column < first + 3 || column > last - 3)
        if (!std::all_of(edges_.begin(), edges_.end(), [x, y](const Vector3d& e) { return is_inside(e, x, y); }))
          continue;
      const double near = nearness.x * x + (nearness.y * y + nearness.z);
      const std::size_t place = std::size_t{row} * resolution_ + static_cast<std::size_t>(column);
      if (near > nearness_[place]) {
        nearness_[place] = near;
        label_[place] = label;
      }
    }
  }

  std::uint32_t resolution_;
  std::vector<std::uint32_t> label_;
  std::vector<double> nearness_;  // 1 / distance along `out`
  std::vector<Vector3d> edges_;
};

}  // namespace

std::array<CubeSide3, 5> sides_over_3(const ElementPatch3& patch, std::uint32_t resolution) {
  const Vector3d edge = patch.corners[1] - patch.corners[0], u = 1 / length(edge) * edge, n = patch.normal;
  const Vector3d v = cross(n, u);
  const std::uint32_t half = resolution / 2;
  return {{{u, v, n, 0}, {v, n, u, half}, {-v, n, -u, half}, {-u, n, v, half}, {u, n, -v, half}}};
}

std::unique_ptr<ItemBuffer3> software_item_buffer_3(std::uint32_t resolution) {
  return std::make_unique<SoftwareItemBuffer3>(resolution);
}

}  // namespace hottel
