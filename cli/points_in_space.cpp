#include "cli/points_in_space.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "geometry/scene_names.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/visibility/point_bounds.h"
#include "geometry/space/visibility/seen_faces.h"
#include "io/files/output_file.h"
#include "io/results/csv_field.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/with_file_context.h"

namespace hottel {
namespace {

// A scene that points look at.
class SeenFaces3 {
 public:
  SeenFaces3(const Scene3& scene, bool proves)
      : scene_(scene), arrangement_(scene), occluders_(arrangement_.polygons()), proves_(proves) {}

  // The lines of a point by its number; nothing in a solid.
  std::optional<std::string> lines(std::size_t number, const Point3& eye) const {
    if (arrangement_.solids().around(eye)) return std::nullopt;
    const std::string begin = begin_of(number, eye);
    return proves_ ? proven_lines(begin, eye) : plain_lines(begin, eye);
  }

 private:
  static constexpr double kNothing = 1e-14;  // what rounding makes of a sky that is not seen

  std::string plain_lines(const std::string& begin, const Point3& eye) const {
    const VisibilityMap3 map = faces_seen_from(eye, occluders_, arrangement_);
    std::string text;
    for (const VisibilityMap3::Share& share : map.shares)
      text += begin + csv_field(face_name(scene_, share.face)) + end_of(share.fraction);
    if (map.sky_fraction > kNothing) text += begin + "sky" + end_of(map.sky_fraction);
    return text;
  }

  std::string proven_lines(const std::string& begin, const Point3& eye) const {
    const ExactVisibilityMap3 exact(occluders_, eye);
    const VisibilityMap3 map = faces_seen_from(eye, exact.map(), arrangement_);
    const PointBounds3 bounds = point_bounds(exact, arrangement_);
    std::string text;
    for (std::size_t k = 0; k < map.shares.size(); ++k)
      text += begin + csv_field(face_name(scene_, map.shares[k].face)) +
              end_of(map.shares[k].fraction, bounds.shares[k].fraction);
    if (map.sky_fraction > kNothing) text += begin + "sky" + end_of(map.sky_fraction, bounds.sky_fraction);
    return text;
  }

  static std::string begin_of(std::size_t number, const Point3& eye) {
    std::string text = std::to_string(number) + ",";
    for (const double x : to_doubles(eye)) text += shortest(x) + ",";
    return text;
  }
  static std::string end_of(double fraction) {
    return "," + shortest(fraction) + "," + shortest(4 * std::numbers::pi * fraction) + "\n";
  }
  static std::string end_of(double fraction, const Enclosure& bounds) {
    const double value = bounds.contains(fraction) ? fraction : bounds.lower;
    return "," + shortest(value) + "," + shortest(bounds.lower) + "," + shortest(bounds.upper) + "," +
           shortest(4 * std::numbers::pi * value) + "\n";
  }

  const Scene3& scene_;
  Arrangement3 arrangement_;
  Occluders3 occluders_;
  bool proves_;
};

// Some points at a time; returns how many are in solids.
std::size_t write_lines(const SeenFaces3& seen, std::span<const Point3> points, const Streams& streams,
                        OutputFile& file) {
  constexpr std::size_t kBatch = 1024;
  const auto progress = streams.progress("what points see");
  std::size_t in_solids = 0;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    std::vector<std::optional<std::string>> texts(std::min(kBatch, points.size() - first));
    parallel_for(
        texts.size(), [&](std::size_t k) { texts[k] = seen.lines(first + k, points[first + k]); }, 4);
    for (const auto& text : texts) text ? file.write(*text) : void(++in_solids);
    if (progress) progress(static_cast<double>(first + texts.size()) / static_cast<double>(points.size()));
  }
  return in_solids;
}

}  // namespace

void write_seen_faces(const std::vector<Point3>& points, const Scene3& scene, const std::string& out, bool proves,
                      Streams& streams) {
  if (!out.empty() && out != "-" && std::filesystem::path(out).extension() != ".csv")
    throw UsageError("what points in space see is written as .csv, not '" + out + "'");
  streams.write_with(out, [&](OutputFile& file) {
    file.write(std::string("point,x,y,z,face,fraction") + (proves ? ",lower,upper" : "") + ",solid_angle\n");
    const std::size_t in_solids =
        with_file_context(scene.file, [&] { return write_lines(SeenFaces3(scene, proves), points, streams, file); });
    if (in_solids > 0) streams.note("in solids, where nothing is seen, are " + counted(in_solids, "point"));
  });
}

}  // namespace hottel
