#include "cli/points_in_space.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/space/visibility/point_bounds.h"
#include "geometry/space/visibility/seen_faces.h"
#include "io/external/space/point_list.h"
#include "io/files/output_file.h"
#include "io/results/space/seen_files.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/with_file_context.h"

namespace hottel {
namespace {

// A scene that points look at.
class LookedAtScene3 {
 public:
  LookedAtScene3(const Scene3& scene, bool keeps_pieces, bool proves)
      : arrangement_(scene), occluders_(arrangement_.polygons()), keeps_pieces_(keeps_pieces), proves_(proves) {}

  const Solids3& solids() const { return arrangement_.solids(); }

  SeenByPoint3 from(Point3 eye) const {
    SeenByPoint3 seen{std::move(eye), {}, {}, {}};
    seen.solid = solids().around(seen.eye);
    if (seen.solid) return seen;
    VisibilityMap3 map = proves_ ? proven_map(seen) : faces_seen_from(seen.eye, occluders_, arrangement_);
    if (keeps_pieces_) {
      seen.map = std::move(map);
    } else {
      seen.map.shares = std::move(map.shares);
      seen.map.sky_fraction = map.sky_fraction;
    }
    return seen;
  }

 private:
  // Its numbers are within their bounds, which it sets.
  VisibilityMap3 proven_map(SeenByPoint3& seen) const {
    const ExactVisibilityMap3 exact(occluders_, seen.eye);
    VisibilityMap3 map = faces_seen_from(seen.eye, exact.map(), arrangement_);
    seen.bounds = point_bounds(exact, arrangement_);
    const auto keep_within = [](double& value, const Enclosure& bounds) {
      if (!bounds.contains(value)) value = bounds.lower;
    };
    for (std::size_t k = 0; k < map.shares.size(); ++k)
      keep_within(map.shares[k].fraction, seen.bounds->shares[k].fraction);
    keep_within(map.sky_fraction, seen.bounds->sky_fraction);
    return map;
  }

  Arrangement3 arrangement_;
  Occluders3 occluders_;
  bool keeps_pieces_, proves_;
};

SeenFormat3 format_of(const SeenRequest3& request) {
  const bool is_file = !request.out.empty() && request.out != "-";
  const auto format = is_file ? seen_format_3(request.out) : SeenFormat3::kCsv;
  if (!format) throw UsageError("what points in space see is written as .csv, .npz or .vtu, not '" + request.out + "'");
  if (request.has_pieces && *format != SeenFormat3::kNpz)
    throw UsageError("--pieces are for a .npz: a .vtu always has them, a csv never");
  if (request.has_bounds && *format == SeenFormat3::kVtu)
    throw UsageError("--guarantee enclosed gives bounds to a .csv or a .npz, not to a .vtu");
  return *format;
}

// Some points at a time; returns how many are in solids.
std::size_t write_all(const SeenRequest3& request, std::size_t count, const LookedAtScene3& scene,
                      const Streams& streams, SeenWriter3& writer) {
  constexpr std::size_t kBatch = 256;
  const auto progress = streams.progress("what points see");
  PointReader3 reader(request.text, request.name);
  std::size_t in_solids = 0;
  for (std::size_t done = 0; done < count;) {
    std::vector<Point3> points = reader.next(kBatch);
    std::vector<SeenByPoint3> seen(points.size());
    parallel_for(
        points.size(), [&](std::size_t k) { seen[k] = scene.from(std::move(points[k])); }, 4);
    for (const SeenByPoint3& each : seen) {
      writer.add(each);
      in_solids += each.solid ? 1 : 0;
    }
    done += points.size();
    if (progress) progress(static_cast<double>(done) / static_cast<double>(count));
  }
  writer.finish();
  return in_solids;
}

}  // namespace

void write_seen_faces(const SeenRequest3& request, const Scene3& scene, Streams& streams) {
  const SeenFormat3 format = format_of(request);
  const std::size_t count = count_points_3(request.text, request.name);
  streams.write_with(request.out, [&](OutputFile& file) {
    const std::size_t in_solids = with_file_context(scene.file, [&] {
      const LookedAtScene3 looked_at(scene, request.has_pieces || format == SeenFormat3::kVtu, request.has_bounds);
      const SeenFileOptions3 options{scene, looked_at.solids(), request.has_pieces, request.has_bounds,
                                     std::filesystem::path(request.out).parent_path()};
      const auto writer = seen_writer_3(format, options, [&file](std::string_view bytes) { file.write(bytes); });
      return write_all(request, count, looked_at, streams, *writer);
    });
    if (in_solids > 0) streams.note("in solids, where nothing is seen, are " + counted(in_solids, "point"));
  });
}

}  // namespace hottel
