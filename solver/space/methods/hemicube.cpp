// hemicube:R, hemicube:R:uniform, and each with :egl.
// GUARANTEE: estimated.
// REFERENCE: M. F. Cohen, D. P. Greenberg, The hemi-cube: a radiosity solution for complex environments, 1985.
#include "solver/space/methods/hemicube.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "geometry/space/visibility/direction.h"
#include "kernel/support/failure.h"
#include "solver/methods/factor_rows.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/space/methods/contact_rows.h"
#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/item_buffer.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostPixels = 4096;
constexpr const char* kHemicubeReference = "Cohen and Greenberg 1985";
constexpr std::string_view kUniform = ":uniform", kEgl = ":egl";

class Hemicube3 final : public ElementMethod3 {
 public:
  explicit Hemicube3(const HemicubeOptions3& options) : options_(options) {
    const std::string variant =
        std::string(options.is_uniform ? kUniform : "") + std::string(options.by_egl ? kEgl : "");
    info_.name = fmt::format("hemicube:{}{}", options.resolution, variant);
    info_.family = "hemicube" + variant;
    info_.parameter = options.resolution;
    info_.reference = kHemicubeReference;
  }
  const MethodInfo& info() const override { return info_; }

 protected:
  ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override {
    const ElementGeometry3 geometry(prepared);
    const SideElements3 items(prepared, geometry.table());
    const std::vector<double> weights = weights_of_pixels();
    // A context of OpenGL takes one row at a time; its driver has threads of its own.
    const std::shared_ptr<ItemBuffer3> shared = options_.by_egl ? gl_item_buffer_3(options_.resolution) : nullptr;
    std::mutex one_at_a_time;
    ExchangeMatrix matrix =
        matrix_by_rows(geometry.table().elements(), has_patches(geometry), progress, [&]() -> FillRow {
          const std::shared_ptr<ItemBuffer3> buffer =
              shared ? shared : std::shared_ptr<ItemBuffer3>(software_item_buffer_3(options_.resolution));
          return [&, buffer](std::uint32_t from, RowSums& by) {
            std::unique_lock lock(one_at_a_time, std::defer_lock);
            if (shared) lock.lock();
            for (const ElementPatch3& patch : geometry.patches(from))
              look(patch, items, weights, geometry.table().sky(), *buffer, by);
            add_contacts(geometry, from, by);
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

  void look(const ElementPatch3& patch, const SideElements3& items, const std::vector<double>& weights,
            std::uint32_t sky, ItemBuffer3& buffer, RowSums& by) const {
    const std::uint32_t resolution = options_.resolution;
    for (const CubeSide3& side : sides_over_3(patch, resolution)) {
      const std::span<const std::uint32_t> labels = buffer.draw(patch, side, items, sky);
      // Weights of the top come first, then those of one side for all.
      const std::size_t offset = side.first_row == 0 ? 0 : std::size_t{resolution} * resolution;
      for (std::size_t k = 0; k < labels.size(); ++k) by.add(labels[k], patch.share * weights[k + offset]);
    }
  }

  HemicubeOptions3 options_;
  MethodInfo info_;
};

std::unique_ptr<ExchangeMethod3> make(std::string_view variant) {
  HemicubeOptions3 options;
  const auto refuse = [variant] {
    throw UsageError(fmt::format(
        "hemicube{}: expected hemicube:R, hemicube:R:uniform, hemicube:R:egl or hemicube:R:uniform:egl with "
        "an even number of pixels R from 2 to {}",
        variant, kMostPixels));
  };
  std::string_view number = variant;
  options.by_egl = number.ends_with(kEgl);
  if (options.by_egl) number.remove_suffix(kEgl.size());
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
      .pattern = "hemicube:R[:uniform][:egl]",
      .what = "an item buffer of R pixels on the long edges about each centre",
      .reference = kHemicubeReference,
      .guarantee = Guarantee::kEstimated,
      .sweep = {"hemicube:32", "hemicube:64", "hemicube:128", "hemicube:256", "hemicube:512", "hemicube:128:uniform"},
      .make = make};
}

}  // namespace hottel
