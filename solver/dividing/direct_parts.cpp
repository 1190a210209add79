#include "solver/dividing/direct_parts.h"

#include <utility>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

DirectParts::DirectParts(const SceneTable& scene, std::vector<Element> elements, std::span<const LightShares> shares) {
  if (scene.lights.empty()) return;
  const ExchangeMatrix matrix(std::move(elements), Guarantee::kEstimated);
  const RadiositySources sources = sources_of(matrix, scene, shares);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const RationalEnclosure& number =
          sources.direct_irradiance.empty() ? RationalEnclosure() : sources.direct_irradiance[i][c];
      values_.push_back(to_double((number.lower + number.upper) / 2));
    }
}

}  // namespace hottel
