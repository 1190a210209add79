// The sky by cones of directions: against closed forms, against others' measures, and with convex bodies one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/sky/sky_cones.h"
#include "tests/geometry/space/box_faces.h"

namespace hottel::sky_test {
namespace {

using box_faces::box;
using box_faces::operator+;
using box_faces::Points;
using box_faces::polygons_of;

constexpr double kPi = std::numbers::pi;

Rational ratio(long p, long q) { return Rational(p) / q; }

// At a height, facing up.
Points level(const Rational& z, const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}
// Across x at a place, facing +x.
Points wall(const Rational& x, const Rational& y0, const Rational& y1, const Rational& z0, const Rational& z1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}
std::vector<Points> open_box(const Point3& a, const Point3& b) {
  std::vector<Points> faces = box(a, b);
  faces.erase(faces.begin());
  return faces;
}

// Of rectangles at right angles with an edge of length 1 in common, the first one w wide, the second h high.
double perpendicular(double w, double h) {
  const double ww = w * w, hh = h * h, both = ww + hh, root = std::sqrt(both);
  const double logs = std::log((1 + ww) * (1 + hh) / (1 + both)) + ww * std::log(ww * (1 + both) / ((1 + ww) * both)) +
                      hh * std::log(hh * (1 + both) / ((1 + hh) * both));
  return (w * std::atan(1 / w) + h * std::atan(1 / h) - root * std::atan(1 / root) + logs / 4) / (kPi * w);
}
// Of equal squares of side 1 that face each other at a distance.
double opposite_squares(double distance) {
  const double x = 1 / distance, xx = x * x, root = std::sqrt(1 + xx);
  return 2 / (kPi * xx) *
         (std::log((1 + xx) / std::sqrt(1 + 2 * xx)) + 2 * x * root * std::atan(x / root) - 2 * x * std::atan(x));
}

class Scene {
 public:
  explicit Scene(const std::vector<Points>& polygons) : occluders_(polygons_of(polygons)), measurer_(occluders_) {
    const Rational unit = scaled_by_power_of_two(occluders_.vertices().scale(), occluders_.vertices().shift());
    square_ = to_double(unit * unit);
  }

  PairResult3 sky(const Patch3& patch, const PairRequest3& request = {.tolerance = 1e-12}) const {
    return in_scene(measurer_.measure(patch, Patch3::all_of_the_sky(), request));
  }
  PairResult3 sky(std::uint32_t surface, bool is_back = false) const {
    return sky(whole_patch(occluders_, surface, is_back));
  }
  double factor(std::uint32_t surface, bool is_back = false) const {
    const Patch3 patch = whole_patch(occluders_, surface, is_back);
    const PairResult3 m = sky(patch);
    EXPECT_TRUE(m.problem.empty()) << m.problem;
    return m.measure / area(patch);
  }
  // One minus what goes to all others.
  double rest(std::uint32_t surface, bool is_back = false) const {
    const Patch3 patch = whole_patch(occluders_, surface, is_back);
    double sum = 0;
    for (std::uint32_t s = 0; s < occluders_.size(); ++s)
      for (const bool is_other_back : {false, true})
        if (s != surface)
          sum += in_scene(measurer_.measure(patch, whole_patch(occluders_, s, is_other_back), {.tolerance = 1e-12}))
                     .measure;
    return 1 - sum / area(patch);
  }
  // Everything walked, polygon by polygon.
  PairResult3 walked(const Patch3& patch) const { return sky(patch, {.tolerance = 1e-12, .asks_hiders = false}); }

  double area(const Patch3& patch) const { return square_ * patch_area(occluders_.vertices(), patch).lower; }
  const Occluders3& occluders() const { return occluders_; }
  const PairIntegrator3& measurer() const { return measurer_; }

 private:
  PairResult3 in_scene(PairResult3 m) const {
    m.measure *= square_;
    m.error *= square_;
    m.bounds = {m.bounds.lower * square_, m.bounds.upper * square_};
    return m;
  }

  Occluders3 occluders_;
  PairIntegrator3 measurer_;
  double square_ = 1;
};

std::vector<Points> triangle_of_normal(long x, long y, long z) {
  // Two ways at right angles to it, and to each other or not.
  const Point3 n{x, y, z};
  const Point3 u = x == 0 && y == 0 ? Point3{1, 0, 0} : Point3{-n.y, n.x, 0};
  const Point3 v{n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  return {{{0, 0, 0}, u, v}};
}

const std::array<std::array<long, 3>, 7> kNormals{
    {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {1, 1, 1}, {3, -2, 5}, {-70, 1, 1}, {1, 999, -1000}}};

// (1): each direction on the front is in one cone, told by signs.
TEST(SkyCones3, CoverTheFrontOnceEach) {
  std::mt19937_64 random(7);
  const auto any = [&random] { return static_cast<long>(random() % 2001) - 1000; };
  for (const auto& [x, y, z] : kNormals) {
    const Scene scene(triangle_of_normal(x, y, z));
    const IntegerVector& normal = scene.occluders().exact_normal(0);
    const std::vector<Patch3> cones = sky_cones(whole_patch(scene.occluders(), 0));
    for (int k = 0; k < 4000; ++k) {
      const IntegerVector way{any(), any(), any()};
      if (dot_sign(normal, way) <= 0) continue;
      int inside = 0, on_border = 0;
      for (const Patch3& cone : cones) {
        int least = 1;
        for (std::size_t c = 0; c < cone.corners.size(); ++c)
          least = std::min(least, -determinant_sign(cone.corners[c], cone.corners[(c + 1) % cone.corners.size()], way));
        inside += least > 0;
        on_border += least == 0;
      }
      EXPECT_TRUE(inside == 1 || (inside == 0 && on_border > 1)) << inside << ' ' << on_border;
    }
  }
}

// Each is convex and pointed, with corners that are told by few bits; (2).
TEST(SkyCones3, AreConvexConesOfFewBits) {
  for (const auto& [x, y, z] : kNormals) {
    const Scene scene(triangle_of_normal(x, y, z));
    const std::vector<Patch3> cones = sky_cones(whole_patch(scene.occluders(), 0));
    EXPECT_EQ(cones.size(), 12u);
    for (const Patch3& cone : cones) {
      EXPECT_TRUE(cone.is_far() && cone.is_sky() && !cone.is_all_of_the_sky());
      const std::size_t n = cone.corners.size();
      for (std::size_t a = 0; a < n; ++a) {
        EXPECT_LE(bits(cone.corners[a]), 9);
        for (std::size_t b = 2; b < n; ++b)
          EXPECT_LT(determinant_sign(cone.corners[a], cone.corners[(a + 1) % n], cone.corners[(a + b) % n]), 0);
      }
    }
  }
}

TEST(SkyCones3, WhatNothingHidesAddsUpToTheArea) {
  for (const auto& [x, y, z] : kNormals) {
    const Scene scene(triangle_of_normal(x, y, z));
    const Vertices3& vertices = scene.occluders().vertices();
    const Patch3 patch = whole_patch(scene.occluders(), 0);
    const Enclosure area = patch_area(vertices, patch);
    Enclosure sum{0, 0};
    for (const Patch3& cone : sky_cones(patch))
      sum = sum_of_nonnegative(sum, unobstructed_sky(vertices, patch, cone).bounds);
    EXPECT_LE(sum.lower, area.upper);
    EXPECT_GE(sum.upper, area.lower);
    EXPECT_NEAR(sum.upper / sum.lower, 1, 1e-12);
    EXPECT_NEAR(scene.factor(0), 1, 1e-14);
    const PairResult3 m = scene.sky(0);
    EXPECT_TRUE(m.is_whole);
    EXPECT_EQ(m.sight, PairVisibility3::kClear);
  }
}

TEST(TheSky, BesideAWallOnTheEdge) {
  for (const double height : {0.125, 1.0, 8.0, 512.0}) {
    const Rational h = ratio(static_cast<long>(height * 8), 8);
    const Scene scene({level(0, 0, 1, 0, 1), wall(0, 0, 1, 0, h)});
    EXPECT_NEAR(scene.factor(0), 1 - perpendicular(1, height), 2e-12) << height;
    EXPECT_NEAR(scene.factor(1), 1 - perpendicular(1, height) / height, 2e-12) << height;
    EXPECT_NEAR(scene.factor(1, true), 1, 1e-14);
    EXPECT_NEAR(scene.factor(0, true), 1, 1e-14);
  }
}

TEST(TheSky, FromTheFloorOfACourtyard) {
  for (const double height : {0.25, 1.0, 4.0}) {
    const Rational h = ratio(static_cast<long>(height * 4), 4);
    std::vector<Points> walls = box({0, 0, 0}, {1, 1, h});
    walls.erase(walls.begin() + 1);  // no lid
    std::reverse(walls[0].begin() + 1, walls[0].end());
    const Scene scene(walls);
    EXPECT_NEAR(scene.factor(0), opposite_squares(height), 2e-12) << height;
    EXPECT_NEAR(scene.factor(1, true), scene.rest(1, true), 2e-11) << height;
    EXPECT_NEAR(scene.factor(1), 1, 1e-14);
  }
}

TEST(TheSky, FromTheGroundOfACanyon) {
  for (const long length : {1L, 10L, 1000L}) {
    const Scene scene({level(0, 0, 1, 0, length), wall(0, 0, length, 0, 2), wall(1, 0, length, 0, 2)});
    const double l = static_cast<double>(length);
    EXPECT_NEAR(scene.factor(0), 1 - 2 * perpendicular(1 / l, 2 / l), 4e-12) << length;
  }
}

TEST(TheSky, PastAPlate) {
  for (const Rational& z : {ratio(1, 100), Rational(1), Rational(50)}) {
    const Scene scene({level(0, 0, 1, 0, 1), level(z, 0, 1, 0, 1)});
    EXPECT_NEAR(scene.factor(0), 1 - opposite_squares(to_double(z)), 2e-12) << z;
    EXPECT_NEAR(scene.factor(1, true), scene.factor(0), 2e-12) << z;
    EXPECT_TRUE(scene.sky(1).is_whole);
  }
}

// The ground's edges run outside and under the box.
TEST(TheSky, OfAGroundUnderABox) {
  for (const long x : {1L, -1L, 3L}) {
    const std::vector<Points> polygons = std::vector<Points>{level(0, 0, 4, 0, 5)} + open_box({x, 1, 0}, {x + 2, 3, 1});
    const Scene scene(polygons);
    EXPECT_NEAR(scene.factor(0), scene.rest(0), 1e-11) << x;
    const Patch3 ground = whole_patch(scene.occluders(), 0);
    EXPECT_NEAR(scene.sky(ground).measure, scene.walked(ground).measure, 1e-10) << x;
    for (std::uint32_t s = 1; s < 6; ++s) EXPECT_NEAR(scene.factor(s), scene.rest(s), 1e-11) << s;
    for (std::uint32_t s = 1; s < 6; ++s) EXPECT_NEAR(scene.factor(s, true), scene.rest(s, true), 1e-11) << s;
  }
}

// A cube, seen from within its floor, with a slit of this width across its ceiling.
std::vector<Points> room_with_slit(const Rational& slit) {
  const Rational half = ratio(1, 2);
  std::vector<Points> room = box({0, 0, 0}, {1, 1, 1});
  room.erase(room.begin() + 1);
  std::reverse(room[0].begin() + 1, room[0].end());
  room.push_back(level(1, 0, half, 0, 1));
  room.push_back(level(1, half + slit, 1, 0, 1));
  return room;
}

// Through a slit so narrow that what passes is a billionth.
TEST(TheSky, ThroughASlit) {
  const Scene scene(room_with_slit(ratio(1, 1'000'000'000)));
  const double factor = scene.factor(0);
  EXPECT_GT(factor, 0.2e-9);
  EXPECT_LT(factor, 0.3e-9);
  EXPECT_NEAR(factor, scene.rest(0), 1e-11);
}

// Planes of faces through others, an edge that points to the zenith, needles.
TEST(TheSky, WhereThingsAreInOnePlane) {
  const Scene scene({level(1, 0, 1, 0, 1),
                     wall(2, 0, 1, 0, 1),
                     wall(3, 0, 1, 0, ratio(3, 2)),
                     level(1, 4, 5, 0, ratio(1, 1'000'000)),
                     {{0, 3, 1}, {1, 3, 1}, {0, 3, 2}}});
  for (std::uint32_t s = 0; s < 5; ++s)
    for (const bool is_back : {false, true}) EXPECT_NEAR(scene.factor(s, is_back), scene.rest(s, is_back), 1e-10) << s;
}

// A line across the middle of a cube's ceiling is a view factor of .2185506 from its floor, for each length of width
// (quadrature of one closed form).
TEST(TheSky, ThroughSlitsDownToABillionthOfABillionth) {
  for (const int exponent : {3, 6, 9, 12, 15, 18}) {
    const Rational slit = 1 / Rational(Integer("1" + std::string(exponent, '0')));
    const Scene scene(room_with_slit(slit));
    const PairResult3 m = scene.sky(0);
    EXPECT_TRUE(m.problem.empty()) << m.problem;
    EXPECT_GT(m.bounds.upper, 0) << exponent;
    EXPECT_FALSE(m.is_whole);
    EXPECT_NEAR(m.measure, 0.2185506 * to_double(slit), 1e-4 * to_double(slit) + 2e-12) << exponent;
  }
}

// A face in the plane of a roof: beside it, apart from it, and with an edge on its edge; and from just below and above.
TEST(TheSky, OfAFaceInThePlaneOfARoof) {
  for (const long x : {2L, 3L, 9L}) {
    const std::vector<Points> house = box({0, 0, 0}, {2, 2, 1});
    const Scene scene(std::vector<Points>{level(1, x, x + 1, 0, 2)} + house);
    const PairResult3 up = scene.sky(0);
    EXPECT_TRUE(up.is_whole) << x;
    EXPECT_NEAR(scene.factor(0), 1, 1e-14) << x;
    EXPECT_NEAR(scene.factor(0, true), scene.rest(0, true), 1e-11) << x;
    for (std::uint32_t s = 1; s <= house.size(); ++s) EXPECT_NEAR(scene.factor(s), scene.rest(s), 1e-11) << x << s;
    for (const Rational& off : {ratio(1, 1'000'000'000), ratio(-1, 1'000'000'000)}) {
      const Scene moved(std::vector<Points>{level(1 + off, x, x + 1, 0, 2)} + house);
      EXPECT_EQ(moved.sky(0).is_whole, off > 0) << x << off;
      EXPECT_NEAR(moved.factor(0), 1, 1e-8) << x << off;
      EXPECT_NEAR(moved.factor(0), moved.rest(0), 1e-11) << x << off;
    }
  }
}

// Masts towards the zenith, a billionth wide, that stand on a corner, on an edge and on the inside of a face, and a
// wall that ends in its plane.
TEST(TheSky, BesideEdgesTowardsTheZenith) {
  const Rational thin = ratio(1, 1'000'000'000), half = ratio(1, 2);
  const auto mast = [&](const Rational& x, const Rational& y) {
    return Points{{x, y, 0}, {x + thin, y, 0}, {x + thin, y, 5}, {x, y, 5}};
  };
  const Scene scene({level(0, 0, 1, 0, 1),
                     mast(0, 0),
                     mast(half, 0),
                     mast(half, half),
                     mast(1 - thin, 1),
                     {{1, 0, -1}, {1, 1, -1}, {1, 1, 0}, {1, 0, 0}}});
  for (std::uint32_t s = 0; s < scene.occluders().size(); ++s)
    for (const bool is_back : {false, true}) EXPECT_NEAR(scene.factor(s, is_back), scene.rest(s, is_back), 1e-10) << s;
  EXPECT_LT(scene.factor(0), 1);
  EXPECT_NEAR(scene.factor(0), 1, 1e-8);
}

std::vector<Points> blocks(bool are_open) {
  std::vector<Points> all{level(0, 0, 12, 0, 12)};
  for (long x = 0; x < 3; ++x)
    for (long y = 0; y < 3; ++y) {
      const Point3 a{4 * x + 1, 4 * y + 1, 0}, b{4 * x + 3, 4 * y + 2 + (x + y) % 2, 1 + (5 * x + 3 * y) % 4};
      all = all + (are_open ? open_box(a, b) : box(Point3{a.x, a.y, a.z + ratio(1, 8)}, b));
    }
  return all;
}

// Convex bodies hide as one, and what is behind them from all of an edge is left out: the numbers are those of all
// polygons one by one, with fewer signs asked.
TEST(TheSky, IsTheSameWhereBodiesHideAsOne) {
  for (const bool are_open : {true, false}) {
    const Scene scene(blocks(are_open));
    std::uint64_t together = 0, alone = 0;
    for (std::uint32_t s = 0; s < scene.occluders().size(); s += 3)
      for (const bool is_back : {false, true}) {
        const Patch3 patch = whole_patch(scene.occluders(), s, is_back);
        const PairResult3 m = scene.sky(patch), walked = scene.walked(patch);
        EXPECT_TRUE(m.problem.empty() && walked.problem.empty());
        EXPECT_NEAR(m.measure, walked.measure, m.error + walked.error + 1e-13) << s << is_back;
        EXPECT_EQ(m.measure == 0, walked.measure == 0) << s << is_back;
        EXPECT_EQ(m.is_whole, walked.is_whole) << s << is_back;
        together += m.signs.by_tier[0];
        alone += walked.signs.by_tier[0];
      }
    EXPECT_LT(together, alone / 2);
  }
}

// A body that is open to the sky, from within it, from beside it and from above it.
TEST(TheSky, PastABodyThatIsOpenAbove) {
  std::vector<Points> open = box({0, 0, 0}, {2, 2, 1});
  open.erase(open.begin() + 1);
  const Scene scene(open + std::vector<Points>{level(ratio(1, 2), ratio(1, 2), 1, ratio(1, 2), 1),
                                               level(ratio(3, 2), 3, 4, 0, 1), level(ratio(1, 2), 3, 4, 2, 3),
                                               wall(-1, 0, 2, 0, 3)});
  for (std::uint32_t s = 0; s < scene.occluders().size(); ++s)
    for (const bool is_back : {false, true}) {
      EXPECT_NEAR(scene.factor(s, is_back), scene.rest(s, is_back), 1e-11) << s << is_back;
      const Patch3 patch = whole_patch(scene.occluders(), s, is_back);
      EXPECT_NEAR(scene.sky(patch).measure, scene.walked(patch).measure, 1e-11) << s << is_back;
    }
}

// A body through the plane of a patch hides there what is beyond it, and what is before it is not hidden.
TEST(TheSky, PastABodyThatIsPartlyBehind) {
  const Scene scene(std::vector<Points>{level(0, 0, 2, 0, 2), level(ratio(1, 2), 6, 8, 0, 2)} +
                    box({3, ratio(1, 2), -1}, {4, ratio(3, 2), 2}) + box({ratio(1, 2), ratio(1, 2), 1}, {1, 1, 2}));
  for (std::uint32_t s = 0; s < 2; ++s)
    for (const bool is_back : {false, true}) EXPECT_NEAR(scene.factor(s, is_back), scene.rest(s, is_back), 1e-11) << s;
}

// A body beside a patch that leans under it: from above it is seen through the patch, and does not hide that.
TEST(TheSky, PastABodyThatLeansUnderThePatch) {
  const Point3 top{-1, 1, 1}, a{1, ratio(1, 2), -2}, b{1, ratio(3, 2), -2}, c{-1, 1, -2};
  const Scene scene({level(0, 0, 2, 0, 2), level(5, 0, 1, 0, 2), {top, a, b}, {top, b, c}, {top, c, a}, {a, c, b}});
  for (std::uint32_t s = 0; s < 6; ++s)
    for (const bool is_back : {false, true}) {
      EXPECT_NEAR(scene.factor(s, is_back), scene.rest(s, is_back), 1e-11) << s << is_back;
      const Patch3 patch = whole_patch(scene.occluders(), s, is_back);
      EXPECT_NEAR(scene.sky(patch).measure, scene.walked(patch).measure, 1e-11) << s << is_back;
    }
}

// In a row, alone, and with details, bit for bit.
TEST(TheSky, HasTheSameBitsHoweverItIsAsked) {
  const Scene scene(blocks(true));
  for (std::uint32_t s = 0; s < 12; s += 5) {
    const Patch3 patch = whole_patch(scene.occluders(), s);
    PairRow3 row(scene.measurer(), patch);
    const PairResult3 in_row = row.measure(Patch3::all_of_the_sky()),
                      alone = scene.measurer().measure(patch, Patch3::all_of_the_sky());
    EXPECT_EQ(in_row.measure, alone.measure);
    EXPECT_EQ(in_row.error, alone.error);
    EXPECT_EQ(in_row.bounds, alone.bounds);
  }
}

}  // namespace
}  // namespace hottel::sky_test
