#include "geometry/space/pairs/pair_integrator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/scene/polygon.h"
#include "geometry/space/unobstructed/unobstructed.h"

namespace hottel::pair_integrator_test {
namespace {

using Points = std::vector<Point3>;

Rational ratio(long p, long q) { return Rational(p) / q; }
Rational two_to_minus(int k) { return scaled_by_power_of_two(Rational(1), -k); }

// Polygons, and patches that are the first two of them.
class Pair {
 public:
  explicit Pair(const std::vector<Points>& polygons) : occluders_(made(polygons)), measurer_(occluders_) {}

  Patch3 patch(std::uint32_t surface, bool is_back = false) const {
    Patch3 patch = whole_patch(occluders_, surface);
    if (is_back) std::reverse(patch.corners.begin(), patch.corners.end());
    return patch;
  }
  PairResult3 measure(const PairRequest3& request = tight()) const {
    return measurer_.measure(patch(0), patch(1), request);
  }
  double area(const Patch3& patch) const { return patch_area(occluders_.vertices(), patch).lower; }
  // F of the first to the second polygon.
  double factor(const PairRequest3& request = tight()) const {
    const PairResult3 result = measure(request);
    EXPECT_EQ(result.problem, "");
    EXPECT_LE(result.bounds.lower, result.measure);
    EXPECT_LE(result.measure, result.bounds.upper);
    return result.measure / area(patch(0));
  }
  const Occluders3& occluders() const { return occluders_; }
  const PairIntegrator3& measurer() const { return measurer_; }

  static PairRequest3 tight() {
    PairRequest3 request;
    request.tolerance = 1e-12;
    return request;
  }

 private:
  static std::vector<Polygon3> made(const std::vector<Points>& polygons) {
    std::vector<Polygon3> result;
    for (const Points& points : polygons) result.push_back({points});
    return result;
  }

  Occluders3 occluders_;
  PairIntegrator3 measurer_;
};

// The unit square at a height, its front up or down.
Points square(const Rational& z, bool faces_up) {
  Points points{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  if (!faces_up) std::reverse(points.begin(), points.end());
  return points;
}

Points rectangle(const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1, const Rational& z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

// The sides and the top of a box, and its bottom where it has one.
std::vector<Points> box(const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1,
                        const Rational& z0, const Rational& z1, bool has_bottom) {
  std::vector<Points> faces{{{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}},
                            {{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}},
                            {{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}},
                            {{x1, y1, z0}, {x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}},
                            {{x0, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}}};
  if (has_bottom) faces.push_back({{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}});
  return faces;
}

std::vector<Points> joined(std::vector<Points> a, const std::vector<Points>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

constexpr double kParallel = 0.1998248956983873830416;  // Howell C-11, unit squares at distance 1
constexpr double kAdjacent = 0.2000437760754031542396;  // Howell C-14, unit squares with a common edge

// By symmetry and the algebra of view factors a quarter hidden halfway takes a quarter: View3D's example.
TEST(PairResult3, AQuarterSquareHalfwayHidesAQuarter) {
  const Pair pair({square(0, true), square(1, false), rectangle(0, ratio(1, 2), 0, ratio(1, 2), ratio(1, 2))});
  EXPECT_NEAR(pair.factor(), 0.75 * kParallel, 1e-15);
  EXPECT_EQ(pair.measure().sight, PairVisibility3::kMixed);
}

TEST(PairResult3, AlongEdgesAClearPairIsThatOfClosedForms) {
  PairRequest3 request = Pair::tight();
  request.always_along_edges = true;
  EXPECT_NEAR(Pair({square(0, true), square(1, false)}).factor(request), kParallel, 1e-15);
  const Points wall{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}};
  EXPECT_NEAR(Pair({square(0, true), wall}).factor(request), kAdjacent, 1e-15);
}

// Property (1).
TEST(PairResult3, WhatOnePolygonHidesIsHiddenExactly) {
  const Pair pair({square(0, true), square(1, false), rectangle(-1, 2, -1, 2, ratio(1, 2))});
  EXPECT_EQ(pair.measure().sight, PairVisibility3::kHidden);
  EXPECT_EQ(pair.measure().bounds.upper, 0);
}

TEST(PairResult3, WhatOnlySeveralHideIsHiddenExactly) {
  // A wall of five rectangles in a wheel: no two of them are one convex polygon.
  const Rational quarter = ratio(1, 4), half = ratio(1, 2), most = ratio(3, 4);
  const Pair pair({square(0, true), square(1, false), rectangle(quarter, most, quarter, most, half),
                   rectangle(-1, most, -1, quarter, half), rectangle(most, 2, -1, most, half),
                   rectangle(quarter, 2, most, 2, half), rectangle(-1, quarter, quarter, 2, half)});
  const PairResult3 result = pair.measure();
  EXPECT_EQ(result.sight, PairVisibility3::kMixed);
  EXPECT_EQ(result.measure, 0);
  EXPECT_EQ(result.bounds, (Enclosure{0, 0}));
  EXPECT_EQ(result.problem, "");
}

TEST(PairResult3, NeighboursInOnePlaneHideAsOnePolygon) {
  const Rational half = ratio(1, 2);
  const Pair pair({square(0, true), square(1, false), rectangle(-1, half, -1, half, half),
                   rectangle(half, 2, -1, half, half), rectangle(-1, half, half, 2, half),
                   rectangle(half, 2, half, 2, half)});
  const PairResult3 result = pair.measure();
  EXPECT_EQ(result.sight, PairVisibility3::kHidden);
  EXPECT_EQ(result.measure, 0);
  EXPECT_EQ(result.bounds, (Enclosure{0, 0}));
  EXPECT_EQ(result.problem, "");
}

TEST(PairResult3, AnOccluderThatHidesNothingLeavesTheWhole) {
  // It goes around a corner of the hull of both squares: no plane of the hull is between, and no line meets it.
  const Pair pair({square(0, true),
                   square(1, false),
                   {{ratio(6, 5), ratio(9, 10), ratio(1, 2)},
                    {ratio(3, 2), ratio(3, 2), ratio(1, 2)},
                    {ratio(9, 10), ratio(6, 5), ratio(1, 2)}}});
  const PairResult3 result = pair.measure();
  EXPECT_EQ(result.sight, PairVisibility3::kMixed);
  EXPECT_TRUE(result.is_whole);
  EXPECT_GT(result.maps, 0u);
  EXPECT_NEAR(pair.factor(), kParallel, 1e-15);
}

TEST(PairResult3, ASmallOccluderInTheMiddleIsNotNothing) {
  for (const int k : {10, 20, 40}) {
    const Rational w = two_to_minus(k), half = ratio(1, 2);
    const Pair pair({square(0, true), square(1, false), rectangle(half, half + w, half, half + w, half)});
    const PairResult3 result = pair.measure();
    EXPECT_FALSE(result.is_whole) << k;
    EXPECT_EQ(result.problem, "") << k;
  }
}

// Property (4).
// Doubles hold numbers of 1024 bits.
TEST(PairResult3, NumbersMayBeLongerThanAnyDouble) {
  const std::vector<Points> room =
      joined({square(0, true), square(1, false)}, {{{ratio(1, 2), 0, 0}, {1, ratio(1, 2), 0}, {1, 1, ratio(1, 2)}},
                                                   {{0, 0, ratio(1, 3)}, {ratio(1, 3), 0, ratio(2, 3)}, {0, 1, 0}}});
  const Pair pair(room);
  const double expected = pair.factor();
  Integer factor;
  mpz_ui_pow_ui(factor.get_mpz_t(), 3, 700);
  Patch3 first = pair.patch(0), second = pair.patch(1);
  for (Patch3* patch : {&first, &second}) {
    patch->weight = factor;
    for (IntegerVector& corner : patch->corners) corner = multiple(factor, corner);
    const PairResult3 long_patch = pair.measurer().measure(first, second, Pair::tight());
    EXPECT_EQ(long_patch.problem, "");
    EXPECT_NEAR(long_patch.measure / pair.area(pair.patch(0)), expected, 1e-15);
  }
  std::vector<Points> near = room;
  near[3][0].x += 1 / Rational(factor);  // all vertices are multiples of this number but for one
  EXPECT_NEAR(Pair(near).factor(), expected, 1e-15);
}

TEST(PairResult3, ATolerancePastDoublesIsAProblem) {
  const Pair pair({square(0, true), square(1, false), rectangle(0, ratio(1, 2), 0, ratio(1, 2), ratio(1, 2))});
  PairRequest3 request;
  request.tolerance = 1e-20;
  EXPECT_NE(pair.measure(request).problem, "");
}

TEST(PairResult3, AShiftedOriginAndThePairReversedGiveTheSame) {
  std::vector<Points> polygons = joined({square(0, true), square(1, false)}, box(ratio(1, 5), ratio(2, 5), ratio(3, 10),
                                                                                 ratio(7, 10), 0, ratio(1, 2), false));
  polygons.push_back({{ratio(1, 2), ratio(1, 5), ratio(7, 10)},
                      {ratio(9, 10), ratio(3, 10), ratio(4, 5)},
                      {ratio(7, 10), ratio(4, 5), ratio(3, 10)}});
  const Pair pair(polygons);
  const double factor = pair.factor();
  PairRequest3 request = Pair::tight();
  request.is_reversed = true;
  EXPECT_NEAR(pair.factor(request), factor, 1e-15);
  request.origin_shift[0] = 37;
  request.origin_shift[2] = -5;
  EXPECT_NEAR(pair.factor(request), factor, 1e-13);
}

TEST(PairResult3, ABoxOnAPatchMayHaveABottomOrNone) {
  for (const bool on_first : {true, false}) {
    double factors[2];
    for (const bool has_bottom : {false, true}) {
      // A bottom in the plane of the square would share its area: it is a hair higher, inside the box.
      const Rational low = on_first ? Rational(0) : ratio(1, 2), high = on_first ? ratio(1, 2) : Rational(1);
      std::vector<Points> polygons =
          joined({square(0, true), square(1, false)},
                 box(ratio(1, 5), ratio(2, 5), ratio(3, 10), ratio(7, 10), low, high, false));
      if (has_bottom)
        polygons.push_back(
            rectangle(ratio(1, 5), ratio(2, 5), ratio(3, 10), ratio(7, 10), ratio(3, 4) - ratio(on_first, 2)));
      if (!on_first) polygons.push_back(rectangle(ratio(1, 5), ratio(2, 5), ratio(3, 10), ratio(7, 10), ratio(1, 2)));
      factors[has_bottom] = Pair(polygons).factor();
    }
    EXPECT_NEAR(factors[0], factors[1], 1e-15);
  }
}

// Sweeps: 30 orders of magnitude towards a contact, where the value tends to that of the contact.
TEST(PairResult3Sweep, ABoxThatIsLiftedOffTheFloorTendsToTheOneThatStands) {
  const auto factor = [](const Rational& lift) {
    return Pair(joined({square(0, true), square(1, false)},
                       box(ratio(1, 5), ratio(2, 5), ratio(3, 10), ratio(7, 10), lift, ratio(1, 2), true)));
  };
  // Standing: without the bottom, which would share the floor's area.
  const double standing = Pair(joined({square(0, true), square(1, false)},
                                      box(ratio(1, 5), ratio(2, 5), ratio(3, 10), ratio(7, 10), 0, ratio(1, 2), false)))
                              .factor();
  for (int k = 2; k <= 100; k += 7)
    EXPECT_NEAR(factor(two_to_minus(k)).factor(), standing, std::ldexp(1.0, -k) + 1e-15) << k;
}

TEST(PairResult3Sweep, AGapInAWallLetsThroughInProportion) {
  const Rational half = ratio(1, 2);
  double last = 0;
  for (int k = 5; k <= 45; k += 5) {
    const Rational w = two_to_minus(k);
    const Pair pair(
        {square(0, true), square(1, false), rectangle(-1, half - w, -1, 2, half), rectangle(half + w, 2, -1, 2, half)});
    const PairResult3 result = pair.measure();
    EXPECT_EQ(result.problem, "") << k;
    const double share = std::ldexp(result.measure / pair.area(pair.patch(0)), k);
    if (k > 10) {
      EXPECT_NEAR(share, last, last * std::ldexp(1.0, 5 - k) + 1e-13 * std::ldexp(1.0, k)) << k;
    }
    last = share;
  }
}

TEST(PairResult3Sweep, AnOccluderThatTurnsOutOfAPlaneTendsToTheOneInIt) {
  const Rational half = ratio(1, 2), low = ratio(1, 5), high = ratio(2, 5);
  const auto factor = [&](const Rational& turn) {
    return Pair({square(0, true),
                 square(1, false),
                 {{low, low, half}, {high, low, half + turn}, {high, high, half + turn}, {low, high, half}}})
        .factor();
  };
  const double flat = factor(0);
  for (int k = 3; k <= 100; k += 7) EXPECT_NEAR(factor(two_to_minus(k)), flat, std::ldexp(1.0, -k) + 1e-15) << k;
}

TEST(PairResult3Sweep, ASliverHidesLessAndLess) {
  const Rational half = ratio(1, 2);
  for (int k = 3; k <= 100; k += 7) {
    const Pair pair({square(0, true),
                     square(1, false),
                     {{0, 0, half}, {1, ratio(1, 3), half}, {1, ratio(1, 3) + two_to_minus(k), half}}});
    EXPECT_NEAR(pair.factor(), kParallel, std::ldexp(1.0, 1 - k) + 1e-15) << k;
  }
}

// On a floor a triangle whose lower side is next to the foot of a wall: h before it, and h above the floor. It leans
// away from the wall, which so hides a strip of it and, in the limit, nothing. Arcs around points of the foot are all
// but half a turn.
TEST(PairResult3Sweep, ATriangleStandsInAWallNextToItsFoot) {
  const Points floor{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto leaning = [](const Rational& h) { return Points{{4, 4, 0}, {1, 2 - h, h}, {2, 3, 4}}; };
  const Pair alone({floor, leaning(0)});
  for (int k = 20; k <= 160; k += 4) {
    const Rational h = two_to_minus(k);
    const Pair pair({floor, leaning(h), {{ratio(1, 4), ratio(3, 2), 0}, {ratio(5, 2), 3 + h, 0}, {4, 4, 2}}});
    const PairResult3 result = pair.measure();
    EXPECT_EQ(result.problem, "") << k;
    EXPECT_FALSE(result.is_whole) << k;
    EXPECT_NEAR(pair.factor(), alone.factor(), std::ldexp(2.0, -k) + 1e-12) << k;
  }
}

// Scenes of the storm in which two corners all but coincide, which the pair or its hull then has to tell apart.
TEST(PairResult3Sweep, CornersThatAllButCoincideAreToldApart) {
  for (int k = 40; k <= 100; k += 3) {
    const Rational h = two_to_minus(k);
    // A corner next to a side of the patch, in frames where doubles have its digits and where they do not: from the
    // foot of the one between, that side is half a turn.
    const auto turned = [](const Points& points) {
      Points result;
      for (const Point3& p : points) {
        const Rational x = (3 * p.x - 4 * p.y) / 5, y = (4 * p.x + 3 * p.y) / 5;
        result.push_back({x, (5 * y - 12 * p.z) / 13, (12 * y + 5 * p.z) / 13});
      }
      return result;
    };
    const std::vector<Points> near{
        {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}, {{1, 0, 0}, {1, 2, 0}, {0, 0, 1}}, {{0, 0, 1}, {1 + h, 1, 0}, {1, 2, 0}}};
    const PairResult3 here = Pair(near).measure();
    const Pair away({turned(near[0]), turned(near[1]), turned(near[2])});
    EXPECT_EQ(here.problem, "") << k;
    EXPECT_NEAR(away.factor(), Pair(near).factor(), 2e-12) << k;
    // Two that share a side but for h, nearly in one plane: next to nothing goes from one to the other.
    const Pair grazing({{{0, 0, 0}, {0, -1, -1}, {3, 1, 0}},
                        {{0, -2, -2}, {0, -1, -1}, {3, 1, h}},
                        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    const PairResult3 little = grazing.measure();
    EXPECT_EQ(little.problem, "") << k;
    EXPECT_LE(little.measure, std::ldexp(100.0, -k) * grazing.area(grazing.patch(0))) << k;
  }
}

// From a triangle with a side in a wall, past a triangle that leans off that wall by h, to the wall 8 h further back.
// Where the one that hides rises above that side, what is seen turns over within h.
TEST(PairResult3Sweep, AnOccluderRisesAcrossTheSideOfAPatch) {
  const Points from{{0, 4, 0}, {3, 4, 2}, {0, 0, 0}};
  const auto wall = [](const Rational& y) { return Points{{5, y, 0}, {5, y, 3}, {0, y, 3}, {0, y, 0}}; };
  const auto leaning = [](const Rational& h) { return Points{{0, 4, 0}, {2, 4 + h, 0}, {0, 4, 3}}; };
  const double closed = Pair({from, wall(4)}).factor() - Pair({from, leaning(0)}).factor();
  for (int k = 4; k <= 160; k += 4) {
    const Rational h = two_to_minus(k);
    EXPECT_NEAR(Pair({from, wall(4 + 8 * h), leaning(h)}).factor(), closed, std::ldexp(1.0, -k) + 4e-12) << k;
  }
}

// Two triangles cross near a corner of a patch, and what is seen past both changes twice within 2 h of the end of a
// side: roots that doubles know less well than they are apart. The residual tells what is left out, and so does the sum
// from the other end.
TEST(PairResult3Sweep, EventsNextToTheEndOfASideAreToldApart) {
  for (int k = 3; k <= 100; k += 3) {
    const Rational h = two_to_minus(k);
    const Pair pair({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}},
                     {{0, 0, 4}, {0, 2, 4}, {4, 4, 4}, {4, 0, 4}},
                     {{1, 4, 0}, {4 - h, h, -h}, {1, 2, 2}},
                     {{1, 1, 3}, {h, h, 0}, {4, 0, 0}}});
    PairRequest3 back = Pair::tight();
    back.is_reversed = true;
    EXPECT_NEAR(pair.factor(), pair.factor(back), 1e-13) << k;
    const PairResult3 result = pair.measure();
    EXPECT_LT(result.residual, 1e-12 * std::sqrt(pair.area(pair.patch(0)))) << k;
  }
}

// A floor leaves a triangle of g times 2^12 g of a wall to see, and from a slope that leaves its corner at a small
// angle that triangle passes within g, just where the wall and the slope touch: what bounds it is zero there, and
// nearly zero a second time. The same as the triangle by itself.
TEST(PairResult3Sweep, WhatPassesCloseToAZeroAtTheEndOfASideIsSeen) {
  const Rational h = two_to_minus(12), grazing = ratio(1, 1'000'000);
  for (int k = 20; k <= 42; k += 2) {
    const Rational g = two_to_minus(k);
    const Points slope{{1, -1, -g}, {1 + grazing, -grazing, -68 * g}, {0, 0, -g}};
    const Pair pair({{{1, 0, h}, {0, 0, h}, {0, 0, -g}}, slope, rectangle(-4, 4, -4, 4, 0)});
    const Pair alone({{{g / (h + g), 0, 0}, {0, 0, 0}, {0, 0, -g}}, slope});
    for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
      PairRequest3 request;
      request.tolerance = tolerance;
      const PairResult3 result = pair.measure(request);
      EXPECT_EQ(result.problem, "") << k << ", " << tolerance;
      const double scale = pair.area(pair.patch(0)) / to_double((h + g) / 2);
      const double expected = alone.factor() * to_double(g * g / (h + g) / 2) * scale;
      EXPECT_NEAR(result.measure, expected, result.error) << k << ", " << tolerance;
      EXPECT_LT(result.residual, 1e-12 * std::sqrt(scale)) << k << ", " << tolerance;
      EXPECT_LT(result.nodes, 5000u) << k << ", " << tolerance;
    }
  }
}

// The long sides of a needle all but cancel: in doubles rounding is more than is allowed, of the residual too, and two
// rules differ by less than it. No part is halved for that.
TEST(PairResult3Sweep, PartsOfANeedleAreNotHalvedForWhatRoundingMakes) {
  for (const int k : {28, 34, 40}) {
    const Pair pair({{{0, 0, 0}, {1, 0, 0}, {1, two_to_minus(k), 0}},
                     {{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}},
                     {{ratio(1, 4), -1, ratio(1, 8)}, {ratio(3, 4), -1, ratio(1, 4)}, {ratio(1, 2), 1, ratio(1, 3)}}});
    PairRequest3 loose;
    loose.tolerance = 1e-9;
    const PairResult3 first = pair.measure(loose), result = pair.measure();
    EXPECT_EQ(result.problem, "");
    EXPECT_NEAR(result.measure, first.measure, result.error + first.error) << k;
    EXPECT_LE(result.error, 1e-12 * pair.area(pair.patch(0))) << k;
    EXPECT_LT(result.nodes, 6000u) << k << ": up to 6,800 where they are";
  }
}

TEST(PairResult3Sweep, ADihedralClosesAroundAnOccluder) {
  // Two squares with a common edge, a small angle apart, and a needle between them that hides nothing in the limit.
  for (int k = 1; k <= 50; k += 7) {
    const Rational h = two_to_minus(k);
    const Pair pair(
        {square(0, true),
         {{0, 0, 0}, {0, 1, h}, {1, 1, h}, {1, 0, 0}},
         {{ratio(1, 4), ratio(1, 2), h / 4}, {ratio(3, 4), ratio(1, 2), h / 4}, {ratio(1, 2), ratio(3, 4), h / 4}}});
    const PairResult3 result = pair.measure();
    EXPECT_EQ(result.problem, "") << k;
    // In the limit the triangle covers its own area, a sixteenth; the open ends take as much as the angle.
    EXPECT_NEAR(result.measure / pair.area(pair.patch(0)), 15.0 / 16 - std::ldexp(1.0, -k),
                (k < 5 ? 0.5 : std::ldexp(4.0, -2 * k)) + 1e-13)
        << k;
    EXPECT_LE(result.measure, result.bounds.upper) << k;
  }
}

}  // namespace
}  // namespace hottel::pair_integrator_test
