#include "solver/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What the showcase and generated scenes take, on one core of the machine of benchmarks/results.
constexpr double kSecondsPerPair = 1.0e-6;
constexpr double kSecondsPerCellAndEdge = 2.0e-8;
constexpr double kTypicalVisible = 60;  // faces that one face sees in a furnished or cluttered scene

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

bool is_divided(const SceneTable& scene) {
  return std::ranges::any_of(scene.surfaces, [](const Surface& surface) { return surface.elements > 1; });
}

Plan::Plan(const SceneTable& scene, const PlannedShape& shape, const PlanRequest& request) {
  const auto n = static_cast<double>(scene.surfaces.size());
  const bool is_convex = shape.is_convex_room;
  const auto add = [&](const char* name, bool used, const std::string& why_used, const std::string& why_not,
                       double seconds) {
    const bool is_used = used || request.everything;
    effects_.push_back({name, is_used,
                        used      ? why_used
                        : is_used ? "asked for; the scene does not need it: " + why_not
                                  : why_not,
                        is_used ? seconds : 0});
  };
  const auto count_surfaces = [&](const auto& test) {
    return static_cast<std::size_t>(std::count_if(scene.surfaces.begin(), scene.surfaces.end(), test));
  };
  const auto is_used_material = [&](const auto& test) {
    return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
      return test(scene.materials[surface.material]) || (surface.back && test(scene.materials[*surface.back]));
    });
  };

  add(kOcclusion, !is_convex, plural(scene.surfaces.size(), shape.noun) + " that may hide each other",
      "one convex room: nothing can hide anything", n * std::min(n, kTypicalVisible) * kSecondsPerPair);

  const std::size_t backs = count_surfaces([](const Surface& surface) { return surface.back.has_value(); });
  add(kBackFaces, backs > 0, plural(backs, "back") + " with a material",
      "no back has a material: backs are black and have no row", 0);

  add(kSky, !is_convex && !scene.closed,
      scene.sky_emission.is_zero() ? "the scene is not promised to be closed; the sky is dark" : "the sky emits",
      is_convex ? "one closed room" : "the scene is promised to be closed", 0);

  const std::size_t divided = count_surfaces([](const Surface& surface) { return surface.elements > 1; });
  add(kSubdivision, divided > 0, plural(divided, shape.noun) + " divided into elements",
      fmt::format("no gradients along {}s are asked for", shape.noun), 0);

  const int channels = channel_count(scene);
  add(kChannels, channels > 1, "spectra differ: r, g, b", "every spectrum is a scalar: one channel", 0);

  const bool reflects = is_used_material([](const Material& material) { return !material.reflectivity.is_zero(); });
  add(kInterreflection, reflects, "some faces reflect", "every reflectivity is 0: radiosity is emission",
      std::pow(std::min(n, 1500.0), 3) / 3 * 1e-9 * channels);

  const bool emits = is_used_material([](const Material& material) { return !material.emission.is_zero(); });
  const bool is_lit = emits || !scene.sky_emission.is_zero();
  add(kUnreachable, !is_convex || !is_lit,
      is_lit ? "rooms that no light reaches stay exactly dark and are not solved" : "nothing emits",
      "one room with light", 0);

  add(kIllumination, request.grid_cells > 0, plural(request.grid_cells, "cell"), "no grid is asked for",
      static_cast<double>(request.grid_cells) * std::min(n, 400.0) * kSecondsPerCellAndEdge);

  effects_.push_back({kLights, false, "the scene lists none", 0});  // not simulated, whatever is asked for
}

bool Plan::uses(const std::string& effect) const {
  const auto place =
      std::find_if(effects_.begin(), effects_.end(), [&](const PlannedEffect& e) { return e.effect == effect; });
  HOTTEL_REQUIRE(place != effects_.end());
  return place->used;
}

}  // namespace hottel
