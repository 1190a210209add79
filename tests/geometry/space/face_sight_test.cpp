// Which faces some point of a face sees: exactly those with which it exchanges something.
#include "geometry/space/exchange/face_sight.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"

namespace hottel::face_sight_test {
namespace {

TEST(FaceSight3, HasTheFacesOfARowOfFactorsAndWhetherAnythingIsHidden) {
  for (const char* name : {"two_boxes", "cornell_box", "cube"}) {
    const PreparedScene3 prepared =
        prepare(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name + ".json"));
    const ExchangeMatrix matrix = exact_exchange(prepared, {.tolerance = 1e-3});
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const std::vector<SeenFace3> seen = faces_seen_by(prepared, Face::of(i));
      const FactorRow row = matrix.row(i);
      ASSERT_EQ(seen.size(), row.size()) << name << " " << matrix.name(i);
      for (std::size_t k = 0; k < seen.size(); ++k) {
        EXPECT_EQ(seen[k].face ? seen[k].face->number() : matrix.sky(), row[k].to);
        if (!seen[k].face) continue;
        EXPECT_EQ(seen[k].is_whole, row[k].visibility == 1) << matrix.name(row[k].to);
      }
    }
  }
}

}  // namespace
}  // namespace hottel::face_sight_test
