#include "viewer/edit/space/typed_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hottel::typed_point_test {
namespace {

TEST(TypedPoint3, IsExactAndHasThreeCoordinates) {
  for (const char* text : {"0.1, 2/3, -4", "0.1 2/3 -4", " 1/10;  2/3; -4 "}) {
    const Typed<Point3> typed = typed_point_3(text);
    ASSERT_TRUE(typed.value) << text;
    EXPECT_EQ(*typed.value, (Point3{Rational(1, 10), Rational(2, 3), -4}));
  }
  EXPECT_THAT(typed_point_3("1 2").problem, testing::HasSubstr("there are 2"));
  EXPECT_FALSE(typed_point_3("1 2 3 4").value);
  EXPECT_EQ(typed_point_3("1, 2, up").problem, "this is not a number: 'up'");
}

}  // namespace
}  // namespace hottel::typed_point_test
