#include "geometry/closed_promise.h"

#include <fmt/format.h>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

void refuse_promise(const SceneTable& scene, const Element& element, std::optional<double> factor) {
  const Surface& surface = scene.surfaces[element.surface];
  throw RequestError(fmt::format("{}: the scene promises to be closed, but the front of '{}' sees the sky{}",
                                 place_of(scene, surface).text(), element.is_part() ? surface.name : element.name,
                                 factor ? fmt::format(" (F = {})", shortest(*factor)) : ""));
}

void require_closed(const SceneTable& scene, const ExchangeMatrix& matrix) {
  if (!scene.closed) return;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    if (element.is_back || !matrix.has_row(i)) continue;
    const Rounded sky = matrix.factor(i, matrix.sky());
    if (sky.value != 0 || sky.side != 0) refuse_promise(scene, element, sky.value);
  }
}

}  // namespace hottel
