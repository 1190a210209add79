#include "cli/oriented_points.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/external/oriented_points.h"
#include "io/results/oriented_light_csv.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/light/oriented_lights.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/light/oriented_lights.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

// The light at one point, for any thread.
using LightAt = std::function<OrientedLight(const OrientedPoint&)>;

// What is to be said of points without light.
class DarkPoints {
 public:
  void see(std::size_t first, std::span<const OrientedLight> lights) {
    for (std::size_t k = 0; k < lights.size(); ++k)
      if (std::isnan(lights[k].sky_view_factor) && count_++ == 0) first_ = first + k;
  }
  std::string text() const {
    if (count_ == 0) return "";
    return "points in solids, or outside a closed scene, which have no light: " + std::to_string(count_) +
           ", the first is point " + std::to_string(first_);
  }

 private:
  std::size_t count_ = 0, first_ = 0;
};

void write_light(std::span<const OrientedPoint> points, const LightAt& light_at, const Streams& streams,
                 OrientedLightCsv& csv) {
  constexpr std::size_t kBatch = 1024;  // what is held at a time
  const auto progress = streams.progress("light at points");
  DarkPoints dark;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    const auto some = points.subspan(first, std::min(kBatch, points.size() - first));
    std::vector<OrientedLight> lights(some.size());
    parallel_for(
        some.size(), [&](std::size_t k) { lights[k] = light_at(some[k]); }, 4);
    csv.add(some, lights);
    dark.see(first, lights);
    if (progress) progress(static_cast<double>(first + some.size()) / static_cast<double>(points.size()));
  }
  if (const std::string text = dark.text(); !text.empty()) streams.note(text);
}

Point2 point_2(const std::array<Rational, 3>& numbers) { return {numbers[0], numbers[1]}; }

// The light of a scene that is solved.
struct LightOfScene {
  std::vector<std::string> channel_names;
  LightAt light_at;
};

LightOfScene light_of(const Simulation2& simulation, const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const auto lights =
      std::make_shared<const OrientedLights2>(simulation.prepared(), simulation.granularity(), *solution);
  return {solution->channel_names,
          [lights](const OrientedPoint& at) { return lights->at(point_2(at.point), point_2(at.normal)); }};
}

LightOfScene light_of(const Simulation3& simulation, const StageProgress& progress) {
  const auto solution = simulation.radiosities(progress);
  const auto prepared = simulation.prepared();
  const auto lights =
      std::make_shared<const OrientedLights3>(*prepared, simulation.request().factors.granularity, *solution);
  return {solution->channel_names, [lights, prepared, solution](const OrientedPoint& at) {
            return lights->at({at.point[0], at.point[1], at.point[2]}, {at.normal[0], at.normal[1], at.normal[2]});
          }};
}

LightOfScene light_of(ValidScene scene, const StageProgress& progress) {
  if (auto* const plane = std::get_if<ValidScene2>(&scene)) return light_of(Simulation2(std::move(*plane)), progress);
  auto& space = std::get<ValidScene3>(scene);
  const Granularity granularity = is_divided(*space) ? Granularity::kElement : Granularity::kFace;
  return light_of(Simulation3(std::move(space), {.factors = {.granularity = granularity}}), progress);
}

}  // namespace

void write_oriented_light(const OrientedPointsInput& input, ValidScene scene, Streams& streams) {
  if (!input.out.empty() && input.out != "-" && std::filesystem::path(input.out).extension() != ".csv")
    throw UsageError("the light at points with normals is written as .csv, not '" + input.out + "'");
  const int dimension = std::holds_alternative<ValidScene2>(scene) ? 2 : 3;
  const std::vector<OrientedPoint> points = read_oriented_points(input.text, input.name, dimension);
  streams.write_with(input.out, [&](OutputFile& file) {
    const LightOfScene light = light_of(std::move(scene), streams.stages());
    OrientedLightCsv csv(dimension, light.channel_names, [&file](std::string_view text) { file.write(text); });
    with_file_context(input.scene, [&] { write_light(points, light.light_at, streams, csv); });
  });
}

}  // namespace hottel
