// The promise to be closed, decided without all factors.
#include "geometry/plane/exchange/closed_promise.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/support/failure.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::closed_promise_test {
namespace {

using namespace testing_scenes;

// A room from x0, y0 to x1, y1: from outside a black block.
std::vector<Line> block(const std::string& name, const std::string& x0, const std::string& y0, const std::string& x1,
                        const std::string& y1) {
  return {{name + "0", x0, y0, x0, y1},
          {name + "1", x0, y1, x1, y1},
          {name + "2", x1, y1, x1, y0},
          {name + "3", x1, y0, x0, y0}};
}

// A yard that is entered at its upper left, and in it a front that looks at the entry, past a baffle from above.
std::vector<Line> yard() {
  return block("floor", "0", "0", "6", "1") + block("top", "0", "5", "6", "6") + block("right", "6", "0", "7", "6") +
         block("left", "0", "1", "1", "4") + std::vector<Line>{{"seeing", "5.5", "5", "5.5", "4"}};
}

void require_closed(const std::vector<Line>& lines, std::uint32_t elements = 1) {
  Scene2 scene = scene_of(lines);
  scene.closed = true;
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  hottel::require_closed(scene, prepare(scene, elements > 1 ? Divided2::kYes : Divided2::kNo), 0);
}

std::string refusal(const std::vector<Line>& lines, std::uint32_t elements = 1) {
  try {
    require_closed(lines, elements);
    return "";
  } catch (const RequestError& error) {
    return error.what();
  }
}

TEST(ClosedPromise2, IsKeptByARoom) { EXPECT_EQ(refusal(room("3")), ""); }

TEST(ClosedPromise2, IsKeptInTheOpenWhereNoFrontSeesTheSky) {
  EXPECT_EQ(refusal(yard() + block("baffle", "2", "2", "3", "5")), "");
  EXPECT_EQ(refusal(yard() + block("baffle", "2", "2", "3", "5"), 3), "");
}

TEST(ClosedPromise2, IsBrokenByTheFirstFrontThatDoes) {
  EXPECT_NE(refusal(yard(), 1).find("the front of 'seeing' sees the sky (F = "), std::string::npos)
      << refusal(yard(), 1);
  // F is that of the element.
  EXPECT_NE(refusal(yard(), 3).find("the front of 'seeing#0' sees the sky (F = "), std::string::npos)
      << refusal(yard(), 3);
}

}  // namespace
}  // namespace hottel::closed_promise_test
