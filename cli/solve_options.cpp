#include "cli/solve_options.h"

#include <vector>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"

namespace hottel {

Solver solver_of(const SolveOptions& options, bool has_symmetric_rows) {
  const auto solver = solver_named(options.solver);
  if (!solver) {
    std::vector<std::string> known;
    for (int k = 0; k <= static_cast<int>(Solver::kShooting); ++k) known.push_back(to_string(static_cast<Solver>(k)));
    throw UnknownName("there is no solver called '" + options.solver + "'", options.solver, known);
  }
  if (!options.iterations && !options.until) return *solver;
  if (*solver == Solver::kCholesky || *solver == Solver::kLu)
    throw UsageError("--iterations and --until do not apply to " + options.solver + ", which is direct");
  if (*solver == Solver::kAuto) return has_symmetric_rows ? Solver::kCg : Solver::kBicgstab;
  return *solver;
}

}  // namespace hottel
