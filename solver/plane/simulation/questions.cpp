#include "solver/plane/simulation/questions.h"

#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/solved_light.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {

Rounded view_factor(const Simulation2& simulation, const std::string& from, const std::string& to) {
  return simulation.factors()->matrix.factor(from, to);
}

ElementRadiosity radiosity_of(const Simulation2& simulation, const std::string& element, std::size_t channel) {
  const auto factors = simulation.factors();
  const std::uint32_t row = require_element(factors->matrix, element);
  if (row == factors->matrix.sky() || !factors->matrix.has_row(row))
    throw UsageError(quoted_name(element) + " has no radiosity: it is the sky, or has no material or no area");
  const auto solution = simulation.radiosities();
  HOTTEL_REQUIRE(channel < solution->channels.size());
  return solution->channels[channel].elements[row];
}

PointLight2 light_at(const Simulation2& simulation, const Point2& point) {
  try {
    const auto solution = simulation.radiosities();
    const auto prepared = simulation.prepared();
    const Grid2 about{{point.x - 1, point.y - 1}, {point.x + 1, point.y + 1}, 1, 1};  // its one cell has that centre
    SolvedLight2 light = illuminate("point", *prepared, about, simulation.granularity(), *solution);
    return {solution->channel_names, std::move(light.grid.values), ""};
  } catch (const RequestError& error) {
    return {{}, {}, error.what()};
  }
}

}  // namespace hottel
