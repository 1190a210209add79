// What a simulation of Python is asked for, by names of options of the program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "python/bindings/scene.h"
#include "python/bindings/waiting.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/refinement.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::python {

struct SimulationOptions {
  std::optional<std::int64_t> elements, iterations, memory;
  std::optional<Rational> element_size;
  std::optional<double> tolerance, until;
  std::optional<std::string> per, sky;
  std::optional<std::filesystem::path> store;
  RefinementLevels levels;
  std::string method = "exact", guarantee = "estimated", solver = "auto", simulate = "auto";
  Waiting waiting;
};

using AnySimulation = std::variant<Simulation2, Simulation3>;

// Throws UsageError for what makes no sense, or not in that dimension.
void require_sense(const SimulationOptions& options, bool is_plane);
// The scene, its surfaces divided as is asked for. Throws UsageError where that is too many.
ValidScene divided(ValidScene scene, const SimulationOptions& options);
// The simulation of a scene that is divided, without trees under its elements. REQUIRES what makes sense. store: where
// factors are kept, or null.
AnySimulation simulation_of(ValidScene scene, const SimulationOptions& options,
                            const std::shared_ptr<FactorStore>& store);
// The same with trees by the levels that are asked for.
std::shared_ptr<const AnySimulation> refined_by(const SimulationOptions& options, AnySimulation simulation,
                                                const StageProgress& progress);
// Opens the store that is asked for, or returns null. Throws UsageError for a method whose factors come from elsewhere.
std::shared_ptr<FactorStore> store_of(const SimulationOptions& options);

}  // namespace hottel::python
