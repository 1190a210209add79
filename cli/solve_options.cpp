#include "cli/solve_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "geometry/near_names.h"
#include "io/files/disk_space.h"
#include "io/results/exr.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

RadiosityOptions system_asked(const SolveOptions& options, bool has_symmetric_rows) {
  const auto solver = solver_named(options.solver);
  if (!solver) {
    std::vector<std::string> known;
    for (int k = 0; k <= static_cast<int>(Solver::kShooting); ++k) known.push_back(to_string(static_cast<Solver>(k)));
    throw UnknownName(
        fmt::format("there is no solver called '{}'; there are {}", options.solver, fmt::join(known, ", ")),
        options.solver, known);
  }
  RadiosityOptions result{.solver = *solver, .iterations = options.iterations, .until = options.until};
  if (!options.iterations && !options.until) return result;
  if (*solver == Solver::kCholesky || *solver == Solver::kLu)
    throw UsageError("--iterations and --until do not apply to " + options.solver + ", which is direct");
  if (*solver == Solver::kAuto) result.solver = has_symmetric_rows ? Solver::kCg : Solver::kBicgstab;
  return result;
}

LightTest light_test_of(const SolveOptions& options, const SceneTable& scene) {
  if (options.lights != SolveOptions().lights && scene.lights.empty())
    throw UsageError("--lights says how lights fall on faces, and " + options.scene + " has none");
  return *light_test(options.lights);
}

bool wants_picture(const SolveOptions& options, const Shown& shown) {
  return !options.no_picture && (!options.no_illumination || !shown.is_light());
}

bool renders_array(const SolveOptions& options) { return options.render.ends_with(".npy"); }

bool renders_numbers(const SolveOptions& options) { return renders_array(options) || is_exr(options.render); }

PictureRange range_of(const ShownValues& shown, const std::string& grid) {
  return {grid, shown.name, shown.unit, shown.least, shown.greatest, shown.scale.lower, shown.scale.upper};
}

Tone tone_asked(const std::optional<std::string>& name, Tone usual) {
  if (!name) return usual;
  const auto tone = tone_of(*name);
  if (!tone)
    throw UnknownName("there is no tone curve called '" + *name + "': linear, reinhard, log, max", *name,
                      std::vector<std::string>{"linear", "reinhard", "log", "max"});
  return *tone;
}

namespace {

void require_render(const SolveOptions& options, const Shown& shown) {
  if (options.render.empty() || picture_format(options.render)) return;
  if (!renders_numbers(options))
    throw UsageError("a picture is written as .png, .svg, .pdf, .exr or .npy, not '" + options.render + "'");
  if (is_exr(options.render)) require_exr("--render " + options.render);
  if (!shown.is_light()) throw UsageError("--render " + options.render + " is linear light: it goes with --show light");
}

}  // namespace

Shown shown_of(const SolveOptions& options) {
  Shown shown = shown_by(options.show);
  if (!options.bar.empty()) shown.scale = scale_by(options.bar);
  if (!options.channel.empty()) choose_channel(shown, options.channel);
  const SolveOptions usual;
  if (!shown.is_light() && (options.tone || options.exposure != usual.exposure))
    throw UsageError("--tone and --exposure need --show light: " + options.show + " has a scale");
  require_render(options, shown);
  return shown;
}

void require_room_for_light(const SolveOptions& options, const std::string& its_cells, std::uint64_t cells,
                            int channels, const std::string& advice, const std::filesystem::path& directory) {
  const std::uint64_t bytes = cells * static_cast<std::uint64_t>(channels) * sizeof(double);
  const std::string what = fmt::format("{}: light on {} cells", options.scene, its_cells);
  const std::string remedy = "; " + advice + ", or --no-illumination";
  if (const std::uint64_t allowed = memory_allowed(options.memory.value_or(0)); bytes > allowed)
    throw RequestError(fmt::format("{} takes {} bytes of memory; allowed are {}{}", what, bytes, allowed, remedy));
  require_space(directory / "illumination.npy", bytes, what + " takes", remedy);
}

}  // namespace hottel
