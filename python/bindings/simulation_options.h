// What a simulation of Python is asked for, by names of options of the program.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "python/bindings/scene.h"
#include "python/bindings/waiting.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::python {

struct SimulationOptions {
  std::optional<std::int64_t> elements, iterations, memory;
  std::optional<Rational> element_size;
  std::optional<double> tolerance, until;
  std::optional<std::string> per, sky;
  std::string method = "exact", guarantee = "estimated", solver = "auto", simulate = "auto";
  Waiting waiting;
};

using AnySimulation = std::variant<Simulation2, Simulation3>;

// Throws UsageError for what makes no sense, or not in that dimension.
void require_sense(const SimulationOptions& options, bool is_plane);
// The scene, its surfaces divided as is asked for. Throws UsageError where that is too many.
hottel::Scene divided(hottel::Scene scene, const SimulationOptions& options);
// The simulation of a scene that is divided. REQUIRES what makes sense.
std::shared_ptr<const AnySimulation> simulation_of(hottel::Scene scene, const SimulationOptions& options);

}  // namespace hottel::python
