#include "geometry/face.h"

#include <gtest/gtest.h>

namespace hottel::face_test {
namespace {

TEST(Face, IsFoundAgainByItsNumber) {
  for (std::uint32_t number = 0; number < 8; ++number) EXPECT_EQ(Face::of(number).number(), number);
  EXPECT_EQ((Face{3, false}.number()), 6u);
  EXPECT_EQ((Face{3, true}.number()), 7u);
}

TEST(Face, IsOrderedBySurfaceTheFrontBeforeTheBack) {
  for (std::uint32_t a = 0; a < 8; ++a)
    for (std::uint32_t b = 0; b < 8; ++b) EXPECT_EQ(Face::of(a) < Face::of(b), a < b);
}

}  // namespace
}  // namespace hottel::face_test
