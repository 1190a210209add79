#include "io/scene/passed_over.h"

#include <gtest/gtest.h>

namespace hottel::passed_over_test {
namespace {

TEST(PassedOver, CountsEachKindAndNamesItsFirst_1) {
  PassedOver some;
  EXPECT_EQ(some.note(), "");
  some.add(PassedKind::kFaceWithoutArea, {"a.stl", 9}, "'a[1]'");
  EXPECT_EQ(some.note(), "1 face without area passed over: 'a[1]' at a.stl:9");
  some.add(PassedKind::kFaceWithoutArea, {"a.stl", 12}, "'a[2]'");
  some.add(PassedKind::kEmptyGeometry, {"b.wkt", 0});
  EXPECT_EQ(some.note(),
            "1 empty geometry passed over at b.wkt\n"
            "2 faces without area passed over, the first 'a[1]' at a.stl:9");
  EXPECT_EQ(some.count(PassedKind::kFaceWithoutArea), 2u);
  EXPECT_EQ(some.count(PassedKind::kLine), 0u);
}

TEST(PassedOver, TakesThoseOfAnother) {
  PassedOver all, more;
  more.add(PassedKind::kLine, {"a.obj", 3});
  all.add(more);
  more.add(PassedKind::kPoint, {"a.obj", 4}, "", 2);
  all.add(more);
  EXPECT_EQ(all.note(), "2 points passed over, the first at a.obj:4\n2 lines passed over, the first at a.obj:3");
}

}  // namespace
}  // namespace hottel::passed_over_test
