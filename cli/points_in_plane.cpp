#include "cli/points_in_plane.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "cli/scene_input.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/with_file_context.h"
#include "solver/plane/light/point_lights.h"
#include "solver/plane/simulation/queries.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {
namespace {

// What is to be said of polygons that are none.
class PolygonRemarks {
 public:
  void see(std::size_t first, std::span<const RoundedPolygon2> polygons) {
    for (std::size_t k = 0; k < polygons.size(); ++k) {
      const bool is_in_solid = polygons[k].solid != Solids2::kNone;
      if (is_in_solid && in_solids_++ == 0) first_in_solid_ = {first + k, polygons[k].solid};
      const bool is_open = !is_in_solid && (polygons[k].corners.empty() || polygons[k].sees_sky());
      if (is_open && open_++ == 0) first_open_ = first + k;
    }
  }
  std::string text(const Scene2& scene) const {
    std::string result;
    if (in_solids_ > 0)
      result += "points in solids, which see nothing: " + std::to_string(in_solids_) + ", the first is point " +
                std::to_string(first_in_solid_.first) + ", in " + solid_text(scene, first_in_solid_.second) + "\n";
    if (open_ > 0)
      result += "points that see the sky: " + std::to_string(open_) + ", the first is point " +
                std::to_string(first_open_) + "; what they see is unbounded, --range R bounds it\n";
    return result;
  }

 private:
  std::size_t in_solids_ = 0, open_ = 0, first_open_ = 0;
  std::pair<std::size_t, std::uint32_t> first_in_solid_{0, 0};
};

// The scene is solved once, and only where light is asked for.
std::vector<std::vector<double>> lights_at(const PointLights2& lights, const PointLocation2& location,
                                           std::span<const Point2> points) {
  std::vector<std::vector<double>> result(points.size());
  parallel_for(
      points.size(), [&](std::size_t k) { result[k] = lights.at(location, points[k]); }, 16);
  return result;
}

void write_batches(const PolygonRequest2& request, const PreparedScene2& prepared, const PointLights2* lights,
                   const Streams& streams, OutputFile& file) {
  const VisibilityPolygons2 polygons(prepared.arrangement);
  const auto progress = streams.progress("visibility polygons");
  const PolygonFileOptions2 told{request.wanted.wants_exact, request.wanted.range,
                                 lights ? lights->channel_names() : std::vector<std::string>()};
  const auto writer =
      polygon_writer_2(request.format, prepared, told, [&](std::string_view text) { file.write(text); });
  PolygonRemarks remarks;
  constexpr std::size_t kBatch = 1024;  // what is held at a time
  const std::span<const Point2> all(request.points);
  for (std::size_t first = 0; first < all.size(); first += kBatch) {
    const auto points = all.subspan(first, std::min(kBatch, all.size() - first));
    PolygonsOptions2 wanted = request.wanted;
    wanted.progress = [&](double fraction) {
      progress((static_cast<double>(first) + fraction * static_cast<double>(points.size())) /
               static_cast<double>(all.size()));
    };
    const auto found = polygons.all(points, wanted);
    std::vector<std::vector<double>> irradiance;
    if (lights) irradiance = lights_at(*lights, polygons.location(), points);
    writer->add({points, found, irradiance});
    remarks.see(first, found);
  }
  writer->finish();
  streams.note(remarks.text(prepared.scene));
}

}  // namespace

PolygonRequest2 polygon_request(const SeenRequest2& asked) {
  PolygonRequest2 request{.out = asked.out, .has_light = asked.has_light};
  if (!asked.out.empty() && asked.out != "-") {
    const auto format = polygon_format_2(asked.out);
    if (!format) throw UsageError("polygons are written as .csv, .geojson, .wkt or .npz, not '" + asked.out + "'");
    request.format = *format;
  }
  const bool is_wkt = request.format == PolygonFormat2::kWkt, is_npz = request.format == PolygonFormat2::kNpz;
  if (asked.is_exact && (is_wkt || is_npz)) throw UsageError("--exact writes p/q, which .csv and .geojson can hold");
  if (asked.has_light && is_wkt) throw UsageError("--irradiance has no place in .wkt");
  request.wanted.wants_exact = asked.is_exact;
  request.wanted.fronts_only = asked.fronts_only;
  if (!asked.range.empty()) {
    request.wanted.range = number_of(asked.range, "--range");
    if (*request.wanted.range <= 0) throw UsageError("--range is a distance above 0, not " + asked.range);
  }
  request.points = read_points_2(asked.text, asked.name, &request.passed_over);
  return request;
}

void write_polygons(const PolygonRequest2& request, const Simulation2& simulation, Streams& streams) {
  const auto prepared = simulation.prepared(streams.stages());
  std::optional<PointLights2> lights;
  if (request.has_light) lights.emplace(point_lights(simulation, streams.stages()));
  streams.write_with(request.out, [&](OutputFile& file) {
    with_file_context(simulation.scene().file,
                      [&] { write_batches(request, *prepared, lights ? &*lights : nullptr, streams, file); });
  });
}

}  // namespace hottel
