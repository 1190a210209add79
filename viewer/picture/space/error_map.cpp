#include "viewer/picture/space/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/with_file_context.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel {
namespace {

constexpr double kDecades = 1e-4;  // least over largest value of the scale

}  // namespace

ShownValues error_values_3(const MethodComparison3& comparison, const MethodResult& result) {
  ShownValues shown;
  shown.name = "error";
  shown.unit = "1";
  shown.elements.resize(comparison.exact().size());
  const double scale = comparison.exact_solution() ? largest_radiosity(*comparison.exact_solution()) : 0;
  if (!result.solution || scale == 0) {
    shown.scale = {0, 1, false};
    shown.title = result.info.name + ": no radiosities to compare";
    return shown;
  }
  const std::vector<ChannelSolution>& exact = comparison.exact_solution()->channels;
  double largest = 0;
  for (std::uint32_t i = 0; i < comparison.exact().size(); ++i) {
    if (!comparison.exact().has_row(i)) continue;
    double error = 0;
    for (std::size_t c = 0; c < exact.size(); ++c)
      error = std::max(
          error, std::abs(result.solution->channels[c].elements[i].radiosity - exact[c].elements[i].radiosity) / scale);
    shown.elements[i] = error;
    largest = std::max(largest, error);
  }
  shown.scale = largest > 0 ? ColourScale{kDecades * largest, largest, true} : ColourScale{0, 1, false};
  shown.scale.has_zero =
      shown.scale.logarithmic && std::ranges::find(shown.elements, std::optional(0.0)) != shown.elements.end();
  shown.title = fmt::format("{}: |error of radiosity| / largest radiosity, up to {:.2g}", result.info.name, largest);
  return shown;
}

std::string error_map_3(const MethodComparison3& comparison, const MethodResult& result, PictureFormat format) {
  return with_file_context(comparison.prepared().scene.file, [&] {
    RenderOptions3 options;
    options.shown = error_values_3(comparison, result);
    options.has_outlines = true;
    return RenderedView3(comparison.prepared(), Granularity::kElement, comparison.required_solution(),
                         std::move(options))
        .file(format);
  });
}

}  // namespace hottel
