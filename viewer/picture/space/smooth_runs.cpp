#include "viewer/picture/space/smooth_runs.h"

#include <algorithm>
#include <array>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/face_patches.h"

namespace hottel {
namespace {

Direction3 rounded_point(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }

// The mean of the corners of a part.
Direction3 middle_of(const Vertices3& vertices, const Patch3& patch) {
  Direction3 sum;
  const std::vector<Point3> corners = corners_of(vertices, patch);
  for (const Point3& corner : corners) sum = sum + rounded_point(corner);
  return (1.0 / static_cast<double>(corners.size())) * sum;
}

double area_of(const PartRun3::Triangle& triangle) {
  return length(cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0])) / 2;
}

// Sets the values of the middle, which is the first corner of each: a third of it is in the mean of each triangle.
void keep_mean(PartRun3& run, std::span<const double> mean) {
  for (std::size_t c = 0; c < mean.size(); ++c) {
    double all = 0, of_others = 0;
    for (const PartRun3::Triangle& triangle : run.triangles) {
      const double area = area_of(triangle);
      all += area;
      of_others += area * (triangle.values[1][c] + triangle.values[2][c]) / 3;
    }
    const double middle = all > 0 ? 3 * (mean[c] - of_others / all) : mean[c];
    for (PartRun3::Triangle& triangle : run.triangles) triangle.values[0][c] = std::clamp(middle, 0.0, 2 * mean[c]);
  }
}

}  // namespace

std::vector<PartRun3> smooth_runs_3(const PreparedScene3& prepared, const ElementTable3& table, const SmoothMesh3& mesh,
                                    std::span<const double> at_corners, std::span<const double> values,
                                    std::size_t channels) {
  std::vector<PartRun3> result(table.parts().size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const std::span<const std::uint32_t> ring = mesh.ring(k);
    if (ring.empty()) continue;
    const ElementTable3::Part& part = table.parts()[k];
    const Direction3 middle = middle_of(prepared.occluders().vertices(), part.patch);
    for (std::size_t c = 0; c < ring.size(); ++c) {
      const std::array<std::uint32_t, 2> ends{ring[c], ring[c + 1 == ring.size() ? 0 : c + 1]};
      PartRun3::Triangle& triangle = result[k].triangles.emplace_back();
      triangle.corners = {middle, rounded_point(mesh.corners()[ends[0]]), rounded_point(mesh.corners()[ends[1]])};
      for (std::size_t channel = 0; channel < channels; ++channel)
        for (std::size_t end = 0; end < 2; ++end)
          triangle.values[end + 1][channel] = at_corners[ends[end] * channels + channel];
    }
    keep_mean(result[k], values.subspan(part.label * channels, channels));
  }
  return result;
}

}  // namespace hottel
