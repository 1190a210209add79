#include "solver/radiosity/irradiance.h"

#include <algorithm>

#include "solver/radiosity/scaled_ball.h"

namespace hottel {

void set_irradiances(const ExchangeMatrix& matrix, const RadiositySources& sources, int of, ChannelSolution& channel) {
  const auto ball = [of](const SourceSpectrum& source) {
    return ScaledBall::around(source[of].lower, source[of].upper);
  };
  const ScaledBall sky = ball(sources.sky);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ScaledBall irradiance;
    for (const FactorEntry& entry : matrix.row(i)) {
      const ScaledBall there =
          entry.to == matrix.sky() ? sky : ScaledBall::of(DoubleDoubleBall{channel.elements[entry.to].radiosity, 0, 0});
      irradiance = sum(irradiance, product(ScaledBall::of(DoubleDoubleBall::of(entry.factor)), there));
    }
    if (!sources.direct_irradiance.empty()) irradiance = sum(irradiance, ball(sources.direct_irradiance[i]));
    ElementRadiosity& element = channel.elements[i];
    element.irradiance = std::max(0.0, irradiance.nearest());
    element.net_value = std::clamp(element.net_value, element.net_lower, element.net_upper);
  }
}

}  // namespace hottel
