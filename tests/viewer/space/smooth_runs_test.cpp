// Runs of values over elements: their means, their range, and that neighbours agree.
#include "viewer/picture/space/smooth_runs.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>

#include "geometry/space/prepared/element_table.h"
#include "io/scene/scene_json.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::smooth_runs_test {
namespace {

PreparedScene3 divided(const std::string& name, std::uint32_t elements) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return prepare(std::move(scene));
}

double area_of(const PartRun3::Triangle& t) {
  return length(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0])) / 2;
}

// With the means of elements at the corners where they meet.
std::vector<PartRun3> blended(const PreparedScene3& prepared, const ElementTable3& table,
                              const std::vector<double>& values) {
  const SmoothMesh3 mesh(prepared, table);
  return smooth_runs_3(prepared, table, mesh, mesh.at_corners(values, 1), values, 1);
}

// Values that change slowly from element to element.
std::vector<double> gentle_values(const ElementTable3& table) {
  std::vector<double> values;
  for (std::uint32_t i = 0; i < table.count(); ++i) values.push_back(10 + (i * 7 % 5));
  return values;
}

TEST(SmoothRuns3, KeepTheMeansOfElements) {
  const PreparedScene3 prepared = divided("two_boxes.json", 4);
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  const std::vector<double> values = gentle_values(table);
  const std::vector<PartRun3> runs = blended(prepared, table, values);
  ASSERT_EQ(runs.size(), table.parts().size());
  int checked = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].triangles.empty()) continue;
    double sum = 0, area = 0;
    for (const PartRun3::Triangle& t : runs[k].triangles) {
      area += area_of(t);
      sum += area_of(t) * (t.values[0][0] + t.values[1][0] + t.values[2][0]) / 3;
    }
    EXPECT_NEAR(sum / area, values[table.parts()[k].label], 1e-12 * 20);
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

TEST(SmoothRuns3, AreNeverNegativeAndEqualWhereAllIs) {
  const PreparedScene3 prepared = divided("cube.json", 3);
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  std::vector<double> spikes(table.count(), 0.0);
  for (std::size_t k = 0; k < spikes.size(); k += 4) spikes[k] = 100;
  for (const PartRun3& run : blended(prepared, table, spikes))
    for (const PartRun3::Triangle& t : run.triangles)
      for (const auto& value : t.values) EXPECT_GE(value[0], 0);
  for (const PartRun3& run : blended(prepared, table, std::vector<double>(table.count(), 3.0)))
    for (const PartRun3::Triangle& t : run.triangles)
      for (const auto& value : t.values) EXPECT_NEAR(value[0], 3, 1e-14);
}

}  // namespace
}  // namespace hottel::smooth_runs_test
