// Pixels barred by walls in blocks, against each pixel and each wall by itself.
#include "viewer/picture/plane/barred_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace hottel::barred_pixels_test {
namespace {

struct Place {
  double x, y;
};

Wall2 wall(double ax, double ay, double bx, double by) { return {ax, ay, bx, by, 1e-9 * std::hypot(bx - ax, by - ay)}; }

bool is_barred_by(const Wall2& w, Place pixel, Place centre) {
  const double from_side = side(w.ax, w.ay, w.bx, w.by, pixel.x, pixel.y);
  const double to_side = side(w.ax, w.ay, w.bx, w.by, centre.x, centre.y);
  if (std::fabs(to_side) <= w.on_line)
    return (centre.x - w.ax) * (centre.x - w.bx) + (centre.y - w.ay) * (centre.y - w.by) <= 1e-9;
  if ((from_side < 0) == (to_side < 0)) return false;
  return (side(pixel.x, pixel.y, centre.x, centre.y, w.ax, w.ay) < 0) !=
         (side(pixel.x, pixel.y, centre.x, centre.y, w.bx, w.by) < 0);
}

std::vector<double> places(std::size_t count, double from, double to) {
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(from + (to - from) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
  return result;
}

void expect_as_one_by_one(const std::vector<Wall2>& walls, std::size_t side_pixels, Place centre) {
  std::vector<std::uint32_t> all(walls.size());
  std::iota(all.begin(), all.end(), 0u);
  const std::vector<double> x = places(side_pixels, 3, 4), y = places(side_pixels, 7, 8);
  std::vector<std::uint8_t> marks(side_pixels * side_pixels, 1);
  mark_barred(walls, all, {x, y}, centre.x, centre.y, 4, side_pixels, marks.data());
  for (std::size_t j = 0; j < side_pixels; ++j)
    for (std::size_t i = 0; i < side_pixels; ++i) {
      bool is_barred = false;
      for (const Wall2& w : walls) is_barred = is_barred || is_barred_by(w, {x[i], y[j]}, centre);
      ASSERT_EQ(marks[j * side_pixels + i], is_barred ? 5 : 1) << i << ", " << j << " of " << walls.size() << " walls";
    }
}

TEST(BarredPixels2, AreThoseThatSomeWallBars) {
  std::mt19937_64 random(1);
  const auto draw = [&](int steps, double from, double to) {
    return from + (to - from) * static_cast<double>(random() % static_cast<std::uint64_t>(steps + 1)) / steps;
  };
  for (int round = 0; round < 200; ++round) {
    const int steps = round % 2 == 0 ? 8 : 1 << 20;  // on a lattice that pixels and centres share, and anywhere
    std::vector<Wall2> walls;
    const double reach = round % 3 == 0 ? 0.1 : 2;
    for (int k = 0; k < 1 + round % 60; ++k) {
      const double ax = draw(steps, 2, 5), ay = draw(steps, 6, 9);
      const double bx = ax + draw(steps, -reach, reach), by = ay + draw(steps, -reach, reach);
      walls.push_back(wall(ax, ay, bx, by));
    }
    for (const std::size_t pixels : {1u, 2u, 5u, 31u})
      expect_as_one_by_one(walls, pixels, {draw(4, 3, 4.5), draw(4, 7, 8.5)});
  }
}

TEST(BarredPixels2, MayHaveWallsAsLongAsDoublesGo) {
  for (const double far : {1e6, 1e12, 1e18, 1e160, 1e300})
    for (const double tilt : {0.0, 1e-3, 1.0}) {
      expect_as_one_by_one({wall(-far, 7.4 - tilt, far, 7.4 + tilt)}, 17, {4.5, 7.5});
      expect_as_one_by_one({wall(3.3, 7.2, far, tilt * far), wall(3.6, -far, 3.7, far)}, 17, {4.5, 7.5});
    }
}

TEST(BarredPixels2, AreAllWhereTheCentreLiesOnAWall) {
  std::vector<std::uint8_t> marks(16, 0);
  const std::vector<double> x = places(4, 0, 1);
  const std::vector<std::uint32_t> first{0};
  mark_barred({wall(0, 0.5, 1, 0.5)}, first, {x, x}, 0.5, 0.5, 1, 4, marks.data());
  EXPECT_EQ(std::accumulate(marks.begin(), marks.end(), 0), 16);
}

}  // namespace
}  // namespace hottel::barred_pixels_test
