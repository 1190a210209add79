#include "viewer/edit/plane/typed_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hottel::typed_point_test {
namespace {

TEST(TypedPoint2, IsExact) {
  for (const char* text : {"0.1, 2/3", "0.1 2/3", " 1/10;  2/3 "}) {
    const Typed<Point2> typed = typed_point_2(text);
    ASSERT_TRUE(typed.value) << text;
    EXPECT_EQ(*typed.value, (Point2{Rational(1, 10), Rational(2, 3)}));
  }
}

TEST(TypedPoint2, HasTwoCoordinates) {
  EXPECT_THAT(typed_point_2("1").problem, testing::HasSubstr("there are 1"));
  EXPECT_THAT(typed_point_2("").problem, testing::HasSubstr("there are 0"));
  EXPECT_FALSE(typed_point_2("1 2 3").value);
  EXPECT_EQ(typed_point_2("1, up").problem, "this is not a number: 'up'");
}

}  // namespace
}  // namespace hottel::typed_point_test
