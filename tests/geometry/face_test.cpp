#include "geometry/face.h"

#include <gtest/gtest.h>

namespace hottel {
namespace {

TEST(Face, NumbersFollowTheOrderAndLeadBack) {
  for (std::uint32_t number = 0; number < 8; ++number) {
    const Face face = Face::of(number), next = Face::of(number + 1);
    EXPECT_EQ(face.number(), number);
    EXPECT_LT(face, next);
  }
  EXPECT_EQ(Face::of(5), (Face{2, true}));
}

}  // namespace
}  // namespace hottel
