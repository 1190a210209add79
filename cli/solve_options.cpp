#include "cli/solve_options.h"

#include <vector>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"
#include "viewer/picture/picture_options.h"

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

std::optional<PictureRange> range_of(const std::optional<ShownValues>& shown) {
  if (!shown) return std::nullopt;
  return PictureRange{shown->name, shown->unit, shown->scale.lower, shown->scale.upper};
}

Shown shown_of(const SolveOptions& options) {
  Shown shown = shown_by(options.show);
  if (!options.channel.empty()) shown.channel = std::string("rgb").find(options.channel);
  const SolveOptions usual;
  if (!shown.is_light() && (options.tone != usual.tone || options.exposure != usual.exposure))
    throw UsageError("--tone and --exposure are of --show light: " + options.show + " has a scale");
  if (!options.render.empty() && !picture_format(options.render))
    throw UsageError("a picture is written as .png, .svg or .pdf, not '" + options.render + "'");
  return shown;
}

}  // namespace hottel
