// What points of faces get from elements: the sum over all that is seen, and its mean over elements.
#include "solver/space/light/gathered_light.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/space/prepared/face_patches.h"
#include "io/scene/scene_json.h"
#include "solver/space/light/sent_out.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::gathered_light_test {
namespace {

Simulation3 solved(const std::string& name, std::uint32_t elements) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return Simulation3(std::move(scene), {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-6}});
}

// A point of a quadrilateral or triangle, by its first corner and the two beside it.
Point3 point_of(const std::vector<Point3>& corners, const Rational& s, const Rational& t) {
  const Point3& o = corners[0];
  const Vector3 a = corners[1] - o, b = corners.back() - o;
  return {o.x + s * a.x + t * b.x, o.y + s * a.y + t * b.y, o.z + s * a.z + t * b.z};
}

Face side_of(const ElementTable3::Part& part) { return {part.patch.surface, part.is_back}; }

Vector3 normal_of_side(const PreparedScene3& prepared, const Face& side) {
  const IntegerVector& n = prepared.occluders().exact_normal(side.surface);
  const int sign = side.is_back ? -1 : 1;
  return {Rational(sign * n.x), Rational(sign * n.y), Rational(sign * n.z)};
}

TEST(GatheredLight3, IsTheSumOverAllThatIsSeen) {
  const Simulation3 simulation = solved("two_boxes.json", 3);
  const auto solution = simulation.radiosities();
  const PreparedScene3& prepared = *simulation.prepared();
  const SentOut3 obvious(prepared, Granularity::kElement, *solution);
  const GatheredLight3 gathered(prepared, Granularity::kElement, *solution);
  const auto table = prepared.elements(Granularity::kElement);
  std::vector<double> expected(solution->channels.size()), found(expected.size());
  for (std::size_t k = 0; k < table->parts().size(); k += 5) {
    const ElementTable3::Part& part = table->parts()[k];
    if (part.patch.is_sky() || !table->has_row(part.label)) continue;
    const Point3 point =
        point_of(corners_of(prepared.occluders().vertices(), part.patch), Rational(2, 7), Rational(3, 11));
    obvious.irradiance(point, normal_of_side(prepared, side_of(part)), expected);
    gathered.irradiance(point, side_of(part), found);
    for (std::size_t c = 0; c < found.size(); ++c) EXPECT_NEAR(found[c], expected[c], 1e-12 * (1 + expected[c])) << k;
  }
}

// An identity: the mean over an element of what its points get is what it gets.
TEST(GatheredLight3, HasTheIrradianceOfAnElementInTheMean) {
  const Simulation3 simulation = solved("cube.json", 2);
  const auto solution = simulation.radiosities();
  const PreparedScene3& prepared = *simulation.prepared();
  const GatheredLight3 gathered(prepared, Granularity::kElement, *solution);
  const auto table = prepared.elements(Granularity::kElement);
  constexpr int kAcross = 24;
  std::vector<double> here(solution->channels.size());
  for (std::uint32_t label = 0; label < table->count(); label += 7) {
    if (!table->has_row(label)) continue;
    const ElementTable3::Part& part = table->parts(label)[0];
    const auto corners = corners_of(prepared.occluders().vertices(), part.patch);
    ASSERT_EQ(corners.size(), 4u);
    double sum = 0;
    for (int s = 0; s < kAcross; ++s)
      for (int t = 0; t < kAcross; ++t) {
        gathered.irradiance(point_of(corners, Rational(2 * s + 1, 2 * kAcross), Rational(2 * t + 1, 2 * kAcross)),
                            side_of(part), here);
        sum += here[0];
      }
    const double expected = solution->channels[0].elements[label].irradiance;
    EXPECT_NEAR(sum / (kAcross * kAcross), expected, 2e-4 * expected) << table->elements()[label].name;
  }
}

}  // namespace
}  // namespace hottel::gathered_light_test
