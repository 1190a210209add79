// hemicube:R, hemicube:R:uniform.
// GUARANTEE: estimated.
// REFERENCE: M. F. Cohen, D. P. Greenberg, The hemi-cube: a radiosity solution for complex environments, 1985.
#include "solver/space/methods/hemicube.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "geometry/space/visibility/direction.h"
#include "kernel/support/failure.h"
#include "solver/methods/factor_rows.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/side_elements.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostPixels = 4096;
constexpr const char* kReference = "Cohen and Greenberg 1985";

// One side of the hemicube: a camera at its centre. A direction out + x right + y up is on it where -1 <= x <= 1 and
// -1 <= y <= 1, on the sides of the half cube 0 <= y.
struct CubeSide {
  Vector3d right, up, out;
  std::uint32_t first_row;  // of `resolution` rows

  Vector3d seen(const Vector3d& way) const { return {dot(way, right), dot(way, up), dot(way, out)}; }
};

std::array<CubeSide, 5> sides_over(const ElementPatch3& patch, std::uint32_t resolution) {
  const Vector3d edge = patch.corners[1] - patch.corners[0], u = 1 / length(edge) * edge, n = patch.normal;
  const Vector3d v = cross(n, u);
  const std::uint32_t half = resolution / 2;
  return {{{u, v, n, 0}, {v, n, u, half}, {-v, n, -u, half}, {-u, n, v, half}, {u, n, -v, half}}};
}

// What one side shows: items and how near they are, pixel by pixel.
class SideBuffer {
 public:
  explicit SideBuffer(std::uint32_t resolution)
      : resolution_(resolution), label_(std::size_t{resolution} * resolution), nearness_(label_.size()) {}

  void clear(std::uint32_t background) {
    std::fill(label_.begin(), label_.end(), background);
    std::fill(nearness_.begin(), nearness_.end(), 0.0);
  }

  // Draws a convex item by its corners as a side sees them, counter-clockwise for the eye.
  void draw(std::span<const Vector3d> corners, std::uint32_t first_row, std::uint32_t label) {
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

  std::span<const std::uint32_t> labels() const { return label_; }

 private:
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

class Hemicube3 final : public ElementMethod3 {
 public:
  explicit Hemicube3(const HemicubeOptions3& options) : options_(options) {
    const char* uniform = options.is_uniform ? ":uniform" : "";
    info_.name = fmt::format("hemicube:{}{}", options.resolution, uniform);
    info_.family = fmt::format("hemicube{}", uniform);
    info_.parameter = options.resolution;
    info_.reference = kReference;
  }
  const MethodInfo& info() const override { return info_; }

 protected:
  ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override {
    const ElementGeometry3 geometry(prepared);
    const SideElements3 items(prepared, geometry.table());
    const std::vector<double> weights = weights_of_pixels();
    ExchangeMatrix matrix =
        matrix_by_rows(geometry.table().elements(), has_patches(geometry), progress, [&]() -> FillRow {
          return [&, buffer = SideBuffer(options_.resolution)](std::uint32_t from, RowSums& by) mutable {
            for (const ElementPatch3& patch : geometry.patches(from))
              look(patch, items, weights, geometry.table().sky(), buffer, by);
          };
        });
    report.row_defect = closure_defect(matrix);
    return matrix;
  }

 private:
  std::vector<double> weights_of_pixels() const {
    std::vector<double> weights = hemicube_weights_3(options_.resolution);
    const double pixels = 3.0 * options_.resolution * options_.resolution;
    if (options_.is_uniform) std::fill(weights.begin(), weights.end(), 1 / pixels);
    return weights;
  }

  static void draw(const ElementPatch3& patch, const CubeSide& side, const SidePart3& item, SideBuffer& buffer) {
    const auto& corners = item.corners;
    const Vector3d out = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!(dot(out, corners[0] - patch.centre) < 0)) return;  // seen from behind
    thread_local std::vector<Vector3d> seen;
    seen.clear();
    for (std::size_t k = corners.size(); k-- > 0;) seen.push_back(side.seen(corners[k] - patch.centre));
    buffer.draw(seen, side.first_row, item.label);
  }

  void look(const ElementPatch3& patch, const SideElements3& items, const std::vector<double>& weights,
            std::uint32_t sky, SideBuffer& buffer, RowSums& by) const {
    const std::uint32_t resolution = options_.resolution;
    for (const CubeSide& side : sides_over(patch, resolution)) {
      buffer.clear(sky);
      for (std::uint32_t number = 0; number < items.all().size(); ++number) {
        if (Face::of(number).surface == patch.piece) continue;
        for (const SidePart3& item : items.all()[number]) draw(patch, side, item, buffer);
      }
      const std::size_t first = std::size_t{side.first_row} * resolution;
      const std::size_t offset = side.first_row == 0 ? 0 : std::size_t{resolution} * resolution - first;
      for (std::size_t k = first; k < buffer.labels().size(); ++k)
        by.add(buffer.labels()[k], patch.share * weights[k + offset]);
    }
  }

  HemicubeOptions3 options_;
  MethodInfo info_;
};

std::unique_ptr<ExchangeMethod3> make(std::string_view variant) {
  HemicubeOptions3 options;
  constexpr std::string_view kUniform = ":uniform";
  const auto refuse = [variant] {
    throw UsageError(
        fmt::format("hemicube{}: expected hemicube:R or hemicube:R:uniform with an even number of pixels "
                    "R from 2 to {}",
                    variant, kMostPixels));
  };
  std::string_view number = variant;
  options.is_uniform = number.ends_with(kUniform);
  if (options.is_uniform) number.remove_suffix(kUniform.size());
  if (number.empty()) refuse();
  number.remove_prefix(1);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), options.resolution);
  if (error != std::errc() || end != number.data() + number.size() || options.resolution < 2 ||
      options.resolution > kMostPixels || options.resolution % 2 != 0)
    refuse();
  return hemicube_method_3(options);
}

}  // namespace

std::vector<double> hemicube_weights_3(std::uint32_t resolution) {
  const auto at = [resolution](std::uint32_t k) { return (2.0 * k - resolution) / resolution; };
  std::vector<double> weights;
  const auto add = [&](const Direction3& normal, std::uint32_t row, std::uint32_t column) {
    const double x = at(column), y = at(row), next_x = at(column + 1), next_y = at(row + 1);
    const std::array<Direction3, 4> corners{unit({x, y, 1}), unit({next_x, y, 1}), unit({next_x, next_y, 1}),
                                            unit({x, next_y, 1})};
    weights.push_back(view_factor_3(corners, normal));
  };
  for (std::uint32_t row = 0; row < resolution; ++row)
    for (std::uint32_t column = 0; column < resolution; ++column) add({0, 0, 1}, row, column);
  for (std::uint32_t row = resolution / 2; row < resolution; ++row)
    for (std::uint32_t column = 0; column < resolution; ++column) add({0, 1, 0}, row, column);
  return weights;
}

std::unique_ptr<ExchangeMethod3> hemicube_method_3(const HemicubeOptions3& options) {
  HOTTEL_REQUIRE(options.resolution >= 2 && options.resolution <= kMostPixels && options.resolution % 2 == 0);
  return std::make_unique<Hemicube3>(options);
}

MethodFamily3 hemicube_family_3() {
  return {
      .name = "hemicube",
      .pattern = "hemicube:R[:uniform]",
      .what = "an item buffer of R pixels on the long edges about each centre",
      .reference = kReference,
      .guarantee = Guarantee::kEstimated,
      .sweep = {"hemicube:32", "hemicube:64", "hemicube:128", "hemicube:256", "hemicube:512", "hemicube:128:uniform"},
      .make = make};
}

}  // namespace hottel
