// Rays in doubles that know their errors, against rationals.
#include "tests/oracle/space/filtered_rays.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/oracle/space/nearest_polygon.h"
#include "tests/oracle/space/random_polygons.h"
#include "tests/storm/space/hiding_scene.h"

namespace hottel::oracle::filtered_rays_test {
namespace {

class Drawer {
 public:
  explicit Drawer(std::uint64_t seed) : engine_(seed) {}

  long below(long count) { return static_cast<long>(engine_() % static_cast<std::uint64_t>(count)); }
  mpq_class number() { return mpq_class(below(2000) - 1000) / (1 + below(7)); }
  // From 2^-k to 2^k.
  mpq_class power(long k) {
    const long by = below(2 * k + 1) - k;
    const mpz_class two = mpz_class(1) << std::abs(by);
    return by < 0 ? mpq_class(1, two) : mpq_class(two, 1);
  }
  const SpacePolygon& any(const std::vector<SpacePolygon>& polygons) {
    return polygons[static_cast<std::size_t>(below(static_cast<long>(polygons.size())))];
  }
  // A corner, a point of a side, or one inside; a third of them moved by 2^-10 to 2^-70 off that.
  SpacePoint place(const SpacePolygon& polygon) {
    const std::size_t k = static_cast<std::size_t>(below(static_cast<long>(polygon.size()))), kind = below(4);
    SpacePoint sum;
    mpq_class weights = 0;
    for (std::size_t c = 0; c < polygon.size(); ++c) {
      const bool is_near = c == k || (kind > 0 && c == (k + 1) % polygon.size());
      const long weight = kind > 1 || is_near ? 1 + below(1000) : 0;
      sum = {sum.x + weight * polygon[c].x, sum.y + weight * polygon[c].y, sum.z + weight * polygon[c].z};
      weights += weight;
    }
    SpacePoint place{sum.x / weights, sum.y / weights, sum.z / weights};
    if (below(3) == 0) {
      const mpq_class step(1, mpz_class(1) << (10 + below(61)));
      place = {place.x + step * (below(3) - 1), place.y + step * (below(3) - 1), place.z + step * (below(3) - 1)};
    }
    return place;
  }

 private:
  std::mt19937_64 engine_;
};

struct Counts {
  std::uint64_t rays = 0, undecided = 0, vague = 0, met = 0;
};

void compare(const std::vector<SpacePolygon>& polygons, Drawer& draw, Counts& counts) {
  const SpacePoint eye =
      draw.below(2) == 0 ? draw.place(draw.any(polygons)) : SpacePoint{draw.number(), draw.number(), draw.number()};
  const RayCaster exact(polygons, eye);
  FilteredRayCaster filtered(polygons, eye);
  for (int k = 0; k < 40; ++k) {
    SpacePoint way = draw.below(3) == 0 ? SpacePoint{draw.number(), draw.number(), draw.number()}
                                        : draw.place(draw.any(polygons)) - eye;
    if (draw.below(4) == 0) {
      const mpq_class length = draw.power(100);
      way = {way.x * length, way.y * length, way.z * length};
    }
    if (way == SpacePoint{}) continue;
    const NearestPolygon a = exact(way), b = filtered(way);
    ASSERT_EQ(a.is_plain, b.is_plain);
    ASSERT_EQ(a.polygon, b.polygon);
    ++counts.rays;
    counts.vague += a.is_plain ? 0 : 1;
    counts.met += a.polygon >= 0 ? 1 : 0;
  }
  counts.undecided += filtered.undecided();
}

TEST(FilteredRayCaster, TellsWhatTheExactOneTells) {
  Drawer draw(1);
  Counts counts;
  for (std::uint64_t n = 0; n < 80; ++n) {
    std::vector<SpacePolygon> polygons = n % 4 == 0 ? piercing_triangles(n, 30, 12, 9) : storm::hiding_scene_3(n);
    if (n % 8 == 3) polygons = moved(polygons, mpq_class(1) / 3, {1'000'000'000, mpq_class(1) / 7, 0});
    if (n % 8 == 5) polygons = moved(polygons, draw.power(120), {draw.number(), 0, draw.number()});
    for (int e = 0; e < 4; ++e) ASSERT_NO_FATAL_FAILURE(compare(polygons, draw, counts)) << "scene " << n;
  }
  fmt::print("{} rays, {} met something, {} vague, {} asked of rationals\n", counts.rays, counts.met, counts.vague,
             counts.undecided);
  EXPECT_GE(counts.undecided, counts.vague);
  EXPECT_GT(counts.vague, counts.rays / 20);
  EXPECT_LT(counts.undecided, counts.rays / 2);
  EXPECT_GT(counts.met, counts.rays / 4);
}

// Errors hold what rationals come to, over sums and products of numbers that cancel.
TEST(RoughNumber, HoldsTheExactNumber) {
  Drawer draw(2);
  int told = 0, untold = 0;
  for (int n = 0; n < 20'000; ++n) {
    mpq_class exact = draw.number() * draw.power(20);
    RoughNumber rough = RoughNumber::of(exact);
    for (int step = 0; step < 5; ++step) {
      const mpq_class other = draw.below(4) == 0
                                  ? mpq_class(exact * (1 + draw.power(60) * mpq_class(1, mpz_class(1) << 70)))
                                  : mpq_class(draw.number() * draw.power(10));
      const bool is_product = step > 0 && draw.below(2) == 0 && std::fabs(rough.value) < 0x1p60 && other < 1000;
      if (std::fabs(other.get_d()) > 0x1p80) continue;
      exact = is_product ? mpq_class(exact * other) : mpq_class(exact - other);
      rough = is_product ? rough * RoughNumber::of(other) : rough - RoughNumber::of(other);
      ASSERT_LE(abs(exact - mpq_class(rough.value)), mpq_class(rough.error));
      ASSERT_TRUE(rough.sign() == 0 || rough.sign() == sgn(exact));
      ++(rough.sign() != 0 ? told : untold);
    }
  }
  EXPECT_GT(told, untold);
  EXPECT_GT(untold, 1000);
}

TEST(RoughNumber, TellsNothingOfWhatIsBeyondItsRange) {
  const RoughNumber one = RoughNumber::of(1);
  for (const unsigned power : {90u, 5000u}) {
    const mpq_class large(mpz_class(1) << power);
    const RoughNumber far = RoughNumber::of(large), near = RoughNumber::of(1 / large);
    for (const RoughNumber& some : {far, far * one, one * far, far + one, far * RoughNumber::of(0), near, near * one})
      EXPECT_EQ(some.sign(), 0);
    EXPECT_EQ((one - near).sign(), 1);
  }
  EXPECT_EQ(RoughNumber::of(0).sign(), 0);
  EXPECT_EQ(RoughNumber::of(mpq_class(-1, 3)).sign(), -1);
}

}  // namespace
}  // namespace hottel::oracle::filtered_rays_test
