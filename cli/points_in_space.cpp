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
  explicit SeenFaces3(const Scene3& scene) : scene_(scene), arrangement_(scene), occluders_(arrangement_.polygons()) {}

  // The lines of a point by its number; nothing in a solid.
  std::optional<std::string> lines(std::size_t number, const Point3& eye) const {
    if (arrangement_.solids().around(eye)) return std::nullopt;
    const VisibilityMap3 map = faces_seen_from(eye, occluders_, arrangement_);
    const std::string begin = begin_of(number, eye);
    std::string text;
    for (const VisibilityMap3::Share& share : map.shares)
      text += begin + csv_field(face_name(scene_, share.face)) + end_of(share.fraction);
    if (map.sky_fraction > kNothing) text += begin + "sky" + end_of(map.sky_fraction);
    return text;
  }

 private:
  static constexpr double kNothing = 1e-14;  // what rounding makes of a sky that is not seen

  static std::string begin_of(std::size_t number, const Point3& eye) {
    std::string text = std::to_string(number) + ",";
    for (const double x : to_doubles(eye)) text += shortest(x) + ",";
    return text;
  }
  static std::string end_of(double fraction) {
    return "," + shortest(fraction) + "," + shortest(4 * std::numbers::pi * fraction) + "\n";
  }

  const Scene3& scene_;
  Arrangement3 arrangement_;
  Occluders3 occluders_;
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

void write_seen_faces(const std::vector<Point3>& points, const Scene3& scene, const std::string& out,
                      Streams& streams) {
  if (!out.empty() && out != "-" && std::filesystem::path(out).extension() != ".csv")
    throw UsageError("what points in space see is written as .csv, not '" + out + "'");
  streams.write_with(out, [&](OutputFile& file) {
    file.write("point,x,y,z,face,fraction,solid_angle\n");
    const std::size_t in_solids =
        with_file_context(scene.file, [&] { return write_lines(SeenFaces3(scene), points, streams, file); });
    if (in_solids > 0) streams.note("in solids, where nothing is seen, are " + counted(in_solids, "point"));
  });
}

}  // namespace hottel
