#include "geometry/space/unobstructed/unobstructed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "kernel/legendre_rule.h"
#include "kernel/wide_real.h"
#include "tests/oracle/space/pair_alone.h"
#include "tests/sanitizers.h"

namespace hottel::unobstructed_test {
namespace {

using oracle::SpacePoint;
using oracle::SpacePolygon;
using std::numbers::pi_v;

constexpr int kFewer = kHasAddressSanitizer || kHasThreadSanitizer ? 20 : 1;  // times fewer rounds

// Corners in integer form, of a scene whose doubles are integers.
Vertices3 integer_scene() { return Vertices3({{0, 0, 0}, {1, 0, 0}}); }

// The patch with these corners, over their common denominator.
Patch3 patch_of(const SpacePolygon& polygon) {
  Patch3 patch;
  for (const SpacePoint& p : polygon)
    patch.weight = lcm(lcm(patch.weight, p.x.get_den()), lcm(p.y.get_den(), p.z.get_den()));
  const auto whole = [&patch](const mpq_class& value) {
    return Integer(value.get_num() * (patch.weight / value.get_den()));
  };
  for (const SpacePoint& p : polygon) patch.corners.push_back({whole(p.x), whole(p.y), whole(p.z)});
  return patch;
}

UnobstructedMeasure3 measure(const SpacePolygon& i, const SpacePolygon& j, double tolerance = 1e-13) {
  return unobstructed_measure(integer_scene(), patch_of(i), patch_of(j), tolerance);
}

long double fine_area(const SpacePolygon& polygon) {
  SpacePoint sum;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const SpacePoint n = cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  const mpq_class square = dot(sum, sum);
  return std::sqrt(static_cast<long double>(square.get_d()) +
                   static_cast<long double>(mpq_class(square - square.get_d()).get_d())) /
         2;
}

double area(const SpacePolygon& polygon) { return patch_area(integer_scene(), patch_of(polygon)).upper; }

SpacePolygon reversed(SpacePolygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

SpacePolygon moved(SpacePolygon polygon, const mpq_class& scale, const SpacePoint& offset) {
  for (SpacePoint& p : polygon) p = {scale * p.x + offset.x, scale * p.y + offset.y, scale * p.z + offset.z};
  return polygon;
}

// The rectangle with these sides from a corner, counter-clockwise seen against their cross product.
SpacePolygon rectangle(const SpacePoint& corner, const SpacePoint& first, const SpacePoint& second) {
  const auto sum = [](const SpacePoint& a, const SpacePoint& b) { return SpacePoint{a.x + b.x, a.y + b.y, a.z + b.z}; };
  return {corner, sum(corner, first), sum(sum(corner, first), second), sum(corner, second)};
}

SpacePolygon floor_of(const mpq_class& x, const mpq_class& y) { return rectangle({0, 0, 0}, {x, 0, 0}, {0, y, 0}); }
SpacePolygon ceiling_of(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return rectangle({0, 0, z}, {0, y, 0}, {x, 0, 0});
}

void expect_encloses(const UnobstructedMeasure3& result, long double truth, long double slack = 0) {
  EXPECT_LE(static_cast<long double>(result.bounds.lower), truth + slack);
  EXPECT_GE(static_cast<long double>(result.bounds.upper), truth - slack);
  EXPECT_LE(std::fabs(static_cast<long double>(result.measure) - truth),
            static_cast<long double>(result.error) + slack);
  EXPECT_GE(result.bounds.lower, 0);
  EXPECT_TRUE(result.bounds.contains(result.measure));
}

// The reference is known to 1e-18; the measure is expected to be as good as asked.
void expect_factor(const SpacePolygon& i, const SpacePolygon& j, long double factor) {
  for (const double tolerance : {1e-6, 1e-9, 1e-12, 1e-13, 1e-14}) {
    const UnobstructedMeasure3 result = measure(i, j, tolerance);
    const double size = area(i), least = std::min(size, area(j));
    EXPECT_TRUE(result.has_converged) << tolerance;
    EXPECT_LE(result.error, tolerance * least);
    const long double fine = fine_area(i);
    expect_encloses(result, factor * fine, 2e-18L * fine);
    if (tolerance > 1e-13) continue;
    EXPECT_NEAR(result.measure / size, static_cast<double>(factor), 1e-14);
  }
}

// Howell C-11: aligned parallel rectangles X by Y, in units of their distance.
long double parallel_factor(long double x, long double y) {
  const long double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return 2 / (pi_v<long double> * x * y) *
         (std::log(p * p * q * q / (1 + x * x + y * y)) / 2 + x * q * std::atan(x / q) + y * p * std::atan(y / p) -
          x * std::atan(x) - y * std::atan(y));
}

// Howell C-14: perpendicular rectangles with a common edge of length 1, from width w to height h.
long double corner_factor(long double w, long double h) {
  const long double a = w * w, b = h * h, s = a + b;
  const long double logs = std::log((1 + a) * (1 + b) / (1 + s)) + a * std::log(a * (1 + s) / ((1 + a) * s)) +
                           b * std::log(b * (1 + s) / ((1 + b) * s));
  return (w * std::atan(1 / w) + h * std::atan(1 / h) - std::sqrt(s) * std::atan(1 / std::sqrt(s)) + logs / 4) /
         (pi_v<long double> * w);
}

// Howell C-11, C-14 and C-13 (16 terms) with these sizes, to 22 digits.
TEST(Unobstructed3, AnalyticFactorsAreMet) {
  expect_factor(floor_of(1, 1), ceiling_of(1, 1, 1), 0.1998248956983873830416L);
  expect_factor(floor_of(2, 3), ceiling_of(2, 3, 1), 0.4755764365329529199089L);
  expect_factor(floor_of(10, 10), ceiling_of(10, 10, 1), 0.8269945223972565694584L);
  expect_factor(floor_of(1, 1), ceiling_of(1, 1, 10), 0.003162056838757601625129L);
  expect_factor(floor_of(1, 1), rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0.2000437760754031542396L);
  expect_factor(floor_of(2, 1), rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 3}), 0.1616940143330275840737L);
  expect_factor(floor_of(10, 10), rectangle({0, 0, 0}, {0, 10, 0}, {0, 0, 1}), 0.04325136940068585763541L);
  expect_factor(floor_of(2, 2), rectangle({4, -2, 2}, {0, 3, 0}, {3, 0, 0}), 0.02118281787404705567815L);
}

// In a cube, the opposite face and four neighbours: F + 4 F' = 1.
TEST(Unobstructed3, FacesOfACubeSeeAllOfEachOther) {
  expect_factor(floor_of(1, 1), rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), 0.2000437760754031542396L);
  EXPECT_NEAR(static_cast<double>(parallel_factor(1, 1) + 4 * corner_factor(1, 1)), 1, 1e-16);
}

// The faces of a tetrahedron, fronts inward.
std::vector<SpacePolygon> tetrahedron(std::array<SpacePoint, 4> p) {
  if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) < 0) std::swap(p[0], p[1]);
  return {{p[0], p[1], p[2]}, {p[0], p[3], p[1]}, {p[1], p[3], p[2]}, {p[2], p[3], p[0]}};
}

// By symmetry a third.
TEST(Unobstructed3, FacesOfARegularTetrahedronSeeAThirdOfEachOther) {
  const std::array<SpacePoint, 4> corner{{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};
  const std::vector<SpacePolygon> faces = tetrahedron(corner);
  for (int k = 1; k < 4; ++k) expect_factor(faces[0], faces[k], 1.0L / 3);
}

TEST(Unobstructed3, RectanglesAreAsInHowellsCatalogue) {
  for (int x = 1; x <= 64; x *= 4)
    for (int y = 1; y <= 64; y *= 4) {
      const long double at = x / 8.0L, by = y / 8.0L;
      expect_factor(floor_of(x, y), ceiling_of(x, y, 8), parallel_factor(at, by));
      expect_factor(floor_of(x, 8), rectangle({0, 0, 0}, {0, 8, 0}, {0, 0, y}), corner_factor(at, by));
    }
}

// Turned by exact rotations, so that no coordinate is an axis any more.
TEST(Unobstructed3, IsTheSameInTurnedScenes) {
  const auto turned = [](SpacePolygon polygon) {
    for (SpacePoint& p : polygon) {
      p = {mpq_class(3, 5) * p.x - mpq_class(4, 5) * p.y, mpq_class(4, 5) * p.x + mpq_class(3, 5) * p.y, p.z};
      p = {p.x, mpq_class(5, 13) * p.y - mpq_class(12, 13) * p.z, mpq_class(12, 13) * p.y + mpq_class(5, 13) * p.z};
      p = {mpq_class(8, 17) * p.x - mpq_class(15, 17) * p.z, p.y, mpq_class(15, 17) * p.x + mpq_class(8, 17) * p.z};
    }
    return polygon;
  };
  expect_factor(turned(floor_of(1, 1)), turned(ceiling_of(1, 1, 1)), parallel_factor(1, 1));
  expect_factor(turned(floor_of(1, 1)), turned(rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1})), corner_factor(1, 1));
  expect_factor(turned(floor_of(1, 1)), turned(rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 3})), corner_factor(1, 3));
}

// S = 4/pi int int (h - x) (h - y) / (1 + x^2 + y^2)^2 over [0, h]^2, for squares of side h in the distance 1.
TEST(Unobstructed3, DistantPairsLoseNoDigits) {
  const LegendreRule<long double>& rule = legendre_rule<long double>(20);
  for (long distance = 4; distance <= 1 << 20; distance *= 4) {
    const long double h = 1 / static_cast<long double>(distance);
    long double sum = 0;
    for (std::size_t a = 0; a < rule.node.size(); ++a)
      for (std::size_t b = 0; b < rule.node.size(); ++b) {
        const long double x = rule.node[a], y = rule.node[b], r2 = 1 + h * h * (x * x + y * y);
        sum += rule.weight[a] * rule.weight[b] * (1 - x) * (1 - y) / (r2 * r2);
      }
    const long double truth = 4 / pi_v<long double> * h * h * sum;  // in units of h^2
    if (distance == 4) {
      EXPECT_NEAR(static_cast<double>(truth / parallel_factor(h, h)), 1, 1e-15);
    }
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-13}) {
      const UnobstructedMeasure3 result = measure(floor_of(1, 1), ceiling_of(1, 1, distance), tolerance);
      const double may_lack = tolerance > 1e-7 ? 4 * tolerance * tolerance * result.measure : 0;
      EXPECT_LE(std::fabs(static_cast<long double>(result.measure) - truth), 1e-13L * truth + may_lack) << distance;
      EXPECT_LE(result.error, (distance < 16 ? 1e-12 : 1e-13) * result.measure + may_lack) << distance;
      expect_encloses(result, truth, 1e-17L * truth);
    }
  }
}

struct Random {
  explicit Random(unsigned seed) : engine(seed) {}
  long integer(long low, long high) { return std::uniform_int_distribution<long>(low, high)(engine); }
  SpacePoint point(long size) { return {integer(0, size), integer(0, size), integer(0, size)}; }
  SpacePolygon triangle(long size) {
    SpacePolygon result;
    do {
      result = {point(size), point(size), point(size)};
    } while (oracle::normal_of(result) == SpacePoint{0, 0, 0});
    return result;
  }
  SpacePolygon parallelogram(long size) {
    const SpacePolygon half = triangle(size);
    return rectangle(half[0], half[1] - half[0], half[2] - half[0]);
  }
  SpacePolygon polygon(long size) { return integer(0, 1) ? triangle(size) : parallelogram(size); }

  std::mt19937_64 engine;
};

// Two that face each other, pierce each other, or touch; small lattices are full of contacts.
std::pair<SpacePolygon, SpacePolygon> random_pair(Random& random, long size) {
  std::pair<SpacePolygon, SpacePolygon> result{random.polygon(size), random.polygon(size)};
  if (random.integer(0, 3) == 0) {  // with a common edge
    result.second = {result.first[1], result.first[0], random.point(size)};
    if (oracle::normal_of(result.second) == SpacePoint{0, 0, 0}) result.second = random.triangle(size);
  }
  return result;
}

TEST(Unobstructed3, IsSymmetricBitForBit) {
  Random random(1);
  for (int round = 0; round < 2000 / kFewer; ++round) {
    const auto [i, j] = random_pair(random, round % 2 ? 4 : 1'000'000'000);
    const UnobstructedMeasure3 there = measure(i, j, 1e-9), back = measure(j, i, 1e-9);
    EXPECT_EQ(there.measure, back.measure);
    EXPECT_EQ(there.error, back.error);
    EXPECT_EQ(there.bounds, back.bounds);
  }
}

TEST(Unobstructed3, IsIndependentOfTranslation) {
  Random random(2);
  const mpq_class far = mpq_class(Integer(1) << 90) + 1;
  for (int round = 0; round < 1000 / kFewer; ++round) {
    const auto [i, j] = random_pair(random, round % 2 ? 4 : 1'000'000'000'000);
    const UnobstructedMeasure3 here = measure(i, j, 1e-9);
    for (const SpacePoint& offset : {SpacePoint{-123456789, 7, 1}, SpacePoint{far, -far, 3 * far}}) {
      const UnobstructedMeasure3 there = measure(moved(i, 1, offset), moved(j, 1, offset), 1e-9);
      EXPECT_EQ(there.measure, here.measure);
      EXPECT_EQ(there.bounds, here.bounds);
    }
  }
}

TEST(Unobstructed3, ScalesWithPowersOfTwo) {
  Random random(3);
  for (int round = 0; round < 1000 / kFewer; ++round) {
    const auto [i, j] = random_pair(random, round % 2 ? 4 : 1'000'000'000'000);
    const UnobstructedMeasure3 small = measure(i, j, 1e-9);
    for (const int power : {1, 20, 50, 100}) {
      const mpq_class scale = mpq_class(Integer(1) << power);
      const UnobstructedMeasure3 large = measure(moved(i, scale, {0, 0, 0}), moved(j, scale, {0, 0, 0}), 1e-9);
      EXPECT_EQ(large.measure, std::ldexp(small.measure, 2 * power));
      EXPECT_EQ(large.error, std::ldexp(small.error, 2 * power));
    }
  }
}

// The doubles of a scene with coordinates of 80 bits are 2^-27 of its integers.
TEST(Unobstructed3, IsInSquaresOfTheDoublesOfTheScene) {
  const Rational far = Rational(Integer(1) << 80);
  const Vertices3 scene({{0, 0, 0}, {1, 0, 0}, {far, 0, 0}});
  ASSERT_GT(scene.shift(), 0);
  const Patch3 i = patch_of(floor_of(1, 1)), j = patch_of(ceiling_of(1, 1, 1));
  const int unit = static_cast<int>(-2 * scene.shift());
  EXPECT_EQ(unobstructed_measure(scene, i, j, 1e-9).measure,
            std::ldexp(unobstructed_measure(integer_scene(), i, j, 1e-9).measure, unit));
  EXPECT_TRUE(patch_area(scene, i).contains(std::ldexp(1, unit)));
}

// Slow and of another kind: an integral over the area of i.
TEST(Unobstructed3, EnclosesWhatAnIntegralOverTheAreaGives) {
  Random random(4);
  int compared = 0, fine = 0;
  for (int round = 0; round < 120 / kFewer; ++round) {
    auto [i, j] = random_pair(random, std::array{4L, 30L, 1'000'000L}[round % 3]);
    if (round % 4 != 0) j = moved(j, 1, {0, 0, std::array{4, 30, 1'000'000}[round % 3]});  // seldom cut
    const UnobstructedMeasure3 result = measure(i, j);
    const double size = std::min(area(i), area(j));
    const oracle::FineMeasure truth = oracle::exchange_of_pair_alone(i, j);
    EXPECT_EQ(result.measure == 0, truth.measure == 0);
    if (truth.measure == 0) continue;
    ++compared;
    EXPECT_TRUE(result.has_converged);
    expect_encloses(result, truth.measure, 2 * truth.error + 1e-17L * static_cast<long double>(size));
    fine += truth.error < 1e-15L * static_cast<long double>(size);
  }
  EXPECT_GT(fine, compared * 3 / 4);
}

TEST(Unobstructed3, ConvergesForPairsOfAllKinds) {
  Random random(5);
  int facing = 0;
  for (int round = 0; round < 3000 / kFewer; ++round) {
    const auto [i, j] = random_pair(random, std::array{3L, 4L, 100L, 1'000'000'000'000'000'000L}[round % 4]);
    const UnobstructedMeasure3 loose = measure(i, j, 1e-9), tight = measure(i, j, 1e-13), best = measure(i, j, 1e-30);
    if (loose.measure == 0) continue;
    ++facing;
    EXPECT_TRUE(loose.has_converged);
    EXPECT_TRUE(tight.has_converged);
    EXPECT_FALSE(best.has_converged);
    EXPECT_LE(tight.error, 1e-13 * std::min(area(i), area(j)));
    EXPECT_LE(best.error, 1e-14 * std::min(area(i), area(j)));
    for (const UnobstructedMeasure3* result : {&loose, &tight}) {
      EXPECT_LE(result->bounds.lower, best.bounds.upper);
      EXPECT_GE(result->bounds.upper, best.bounds.lower);
      EXPECT_LE(std::fabs(result->measure - best.measure), result->error + best.error);
    }
  }
  EXPECT_GT(facing, 1000 / kFewer);
}

// The sum of measures, and how far it may be off.
struct Sum {
  double measure = 0, error = 0;
  void add(const UnobstructedMeasure3& part) {
    measure += part.measure;
    error += part.error + 1e-16 * measure;
  }
};

TEST(Unobstructed3, IsAdditiveWhenAPatchIsSplit) {
  Random random(6);
  for (int round = 0; round < 1000 / kFewer; ++round) {
    const auto [i, j] = random_pair(random, round % 2 ? 4 : 1000);
    const mpq_class t(random.integer(1, 9), 10);
    const SpacePoint side = j[1] - j[0], at{j[0].x + t * side.x, j[0].y + t * side.y, j[0].z + t * side.z};
    SpacePolygon rest = j;
    rest[0] = at;
    Sum parts;
    parts.add(measure(i, {j[0], at, j.back()}));
    parts.add(measure(i, rest));
    const UnobstructedMeasure3 whole = measure(i, j);
    EXPECT_NEAR(parts.measure, whole.measure, parts.error + whole.error);
  }
}

// What is behind the plane of the other one might as well not be there.
TEST(Unobstructed3, OnlyThePartsInFrontOfEachOtherCount) {
  Random random(7);
  int cut = 0;
  for (int round = 0; round < 1000 / kFewer; ++round) {
    const SpacePolygon i = random.polygon(round % 2 ? 4 : 1000), j = random.polygon(round % 2 ? 4 : 1000);
    const SpacePolygon front_i = oracle::part_in_front(i, j), front_j = oracle::part_in_front(j, i);
    const UnobstructedMeasure3 whole = measure(i, j);
    EXPECT_EQ(whole.measure > 0, !front_i.empty() && !front_j.empty());
    if (whole.measure == 0) continue;
    cut += front_i != i && front_j != j;
    for (const UnobstructedMeasure3& part : {measure(front_i, j), measure(i, front_j), measure(front_i, front_j)})
      EXPECT_NEAR(part.measure, whole.measure, part.error + whole.error);
  }
  EXPECT_GT(cut, 100 / kFewer);
}

// Row closure: what a face of a convex room sends out meets the others.
void expect_closure(const std::vector<SpacePolygon>& faces, double tolerance = 1e-13) {
  for (const SpacePolygon& i : faces) {
    Sum row;
    for (const SpacePolygon& j : faces) row.add(measure(i, j, tolerance));
    EXPECT_NEAR(row.measure, area(i), row.error + 1e-15 * area(i));
  }
}

TEST(Unobstructed3, RowsOfTetrahedraClose) {
  Random random(8);
  for (int round = 0; round < 300 / kFewer; ++round) {
    const long size = std::array{3L, 100L, 1'000'000'000L}[round % 3];
    const std::array<SpacePoint, 4> p{random.point(size), random.point(size), random.point(size), random.point(size)};
    if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) != 0) expect_closure(tetrahedron(p));
  }
}

// The hull of all corners of a lattice polyhedron: faces by trying all planes.
std::vector<SpacePolygon> hull(const std::vector<SpacePoint>& points) {
  std::vector<SpacePolygon> faces;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        SpacePoint n = cross(points[b] - points[a], points[c] - points[a]);
        std::vector<SpacePoint> on;
        int above = 0, below = 0;
        for (const SpacePoint& p : points) {
          const int side = sgn(dot(n, p - points[a]));
          above += side > 0;
          below += side < 0;
          if (side == 0) on.push_back(p);
        }
        const bool is_first = on[0] == points[a] && on[1] == points[b] && on[2] == points[c];
        if ((above > 0) == (below > 0) || !is_first) continue;
        if (below > 0) n = {-n.x, -n.y, -n.z};
        // Around the first of them, which is a corner, all others are in order.
        std::sort(on.begin() + 1, on.end(),
                  [&](const SpacePoint& p, const SpacePoint& q) { return dot(n, cross(p - on[0], q - on[0])) > 0; });
        faces.push_back(on);
      }
  return faces;
}

// A cube, a truncated tetrahedron (with hexagons) and an octahedron, distorted by random linear maps.
TEST(Unobstructed3, RowsOfPolyhedraClose) {
  std::vector<std::vector<SpacePoint>> shapes(3);
  for (int x = -1; x <= 1; x += 2)
    for (int y = -1; y <= 1; y += 2)
      for (int z = -1; z <= 1; z += 2) {
        shapes[0].push_back({x, y, z});
        if (x * y * z > 0)
          for (int k = 0; k < 3; ++k)
            shapes[1].push_back({x * (k == 0 ? 3 : 1), y * (k == 1 ? 3 : 1), z * (k == 2 ? 3 : 1)});
      }
  for (int sign = -1; sign <= 1; sign += 2)
    for (int k = 0; k < 3; ++k)
      shapes[2].push_back({sign * (k == 0 ? 1 : 0), sign * (k == 1 ? 1 : 0), sign * (k == 2 ? 1 : 0)});
  EXPECT_EQ(hull(shapes[0]).size(), 6u);
  EXPECT_EQ(hull(shapes[1]).size(), 8u);
  EXPECT_EQ(hull(shapes[2]).size(), 8u);

  Random random(9);
  for (int round = 0; round < 20 / std::min(kFewer, 10); ++round)
    for (const std::vector<SpacePoint>& shape : shapes) {
      const std::array<SpacePoint, 3> map{random.point(9), random.point(9), random.point(9)};
      if (dot(cross(map[0], map[1]), map[2]) == 0) continue;
      std::vector<SpacePoint> points;
      for (const SpacePoint& p : shape) points.push_back({dot(map[0], p), dot(map[1], p), dot(map[2], p)});
      expect_closure(hull(points));
    }
}

// A prism over a triangle with the angle 2^-k.
TEST(Unobstructed3, RowsOfAClosingWedgeClose) {
  for (int k = 0; k <= 40; ++k) {
    const Integer s = Integer(1) << k;
    const std::vector<SpacePolygon> faces = hull({{0, 0, 0}, {s, 0, 0}, {s, 0, 1}, {0, s, 0}, {s, s, 0}, {s, s, 1}});
    ASSERT_EQ(faces.size(), 5u);
    expect_closure(faces, 1e-9);
    // Both large faces see little else: all but the wall at the end and the sides.
    const UnobstructedMeasure3 large = measure(floor_of(s, s), rectangle({0, 0, 0}, {0, s, 0}, {s, 0, 1}));
    EXPECT_TRUE(large.has_converged) << k;
    EXPECT_NEAR(large.measure / (s.get_d() * s.get_d()), 1, 3.5 / s.get_d());
  }
}

TEST(Unobstructed3, RowsOfNeedlesClose) {
  for (int k = 0; k <= 30; ++k) {
    const Integer s = Integer(1) << k;
    for (const auto& corners : {std::array<SpacePoint, 4>{{{0, 0, 0}, {s, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                std::array<SpacePoint, 4>{{{0, 0, 0}, {s, 1, 0}, {s, 0, 1}, {s + 2, s, s}}},
                                std::array<SpacePoint, 4>{{{0, 0, 0}, {s, 0, 1}, {0, s, 1}, {s, s, 0}}}})
      if (k > 0 || corners[3].z != 0) expect_closure(tetrahedron(corners), 1e-9);
  }
}

// Howell's C-14: a rectangle of width w and length 1, and a square of side 1 upright on its long side.
WideReal upright_factor(const WideReal& w) {
  const WideReal w2 = w * w, d = sqrt(1 + w2);
  const WideReal part =
      log(2 * (1 + w2) / (2 + w2)) + w2 * log(w2 * (2 + w2) / ((1 + w2) * (1 + w2))) + log((2 + w2) / (2 * (1 + w2)));
  const WideReal pi = 4 * atan(WideReal(1));
  return (w * atan(1 / w) + atan(WideReal(1)) - d * atan(1 / d) + part / 4) / (pi * w);
}

TEST(Unobstructed3, NeedlesHaveAllDigits) {
  for (int k = 10; k <= 240; k += 23) {
    const Integer s = Integer(1) << k;
    const SpacePolygon needle = floor_of(s, 1), wall = rectangle({0, 0, 0}, {0, 0, s}, {s, 0, 0});
    const UnobstructedMeasure3 result = measure(needle, wall, 1e-13);
    EXPECT_TRUE(result.has_converged) << k;
    const double factor = static_cast<double>(upright_factor(WideReal(1) / WideReal(s.get_mpz_t())));
    EXPECT_NEAR(result.measure / s.get_d(), factor, 2e-13) << k;
    // Of the same needle the part that the wall's lower half sees, and the rest.
    const UnobstructedMeasure3 low = measure(needle, rectangle({0, 0, 0}, {0, 0, s / 2}, {s, 0, 0}), 1e-13),
                               high = measure(needle, rectangle({0, 0, s / 2}, {0, 0, s / 2}, {s, 0, 0}), 1e-13);
    EXPECT_NEAR((low.measure + high.measure) / result.measure, 1, 1e-12) << k;
  }
}

// Plates that almost touch, one turned by some angle: their edges cross at the distance of the gap.
TEST(Unobstructed3, NarrowGapsAreEnclosed) {
  for (int k = 4; k <= 40; k += 4) {
    const Integer s = Integer(1) << k;
    const SpacePolygon plate = floor_of(s, s);
    for (const Integer& tilt : {Integer(0), Integer(1), Integer(s / 16), Integer(s / 3)}) {
      const auto lid = [&](long height) { return rectangle({0, 0, height}, {tilt, s, 0}, {s, -tilt, 0}); };
      const UnobstructedMeasure3 near = measure(plate, lid(1), 1e-9), far = measure(plate, lid(2), 1e-9);
      EXPECT_TRUE(near.has_converged) << k << ' ' << tilt;
      EXPECT_GE(near.bounds.upper, far.bounds.lower);
      if (k <= 20) {
        EXPECT_GT(near.bounds.lower, far.bounds.upper);
      }
      // Straight above each other are all of a plate but a triangle at one side and one at the next.
      const mpq_class t(tilt, s), common = (1 - t / 2 - t * (1 - t) * (1 - t) / 2) * s * s;
      EXPECT_NEAR(near.measure / common.get_d(), 1, 20 / s.get_d());
    }
  }
}

TEST(Unobstructed3, IsZeroWhereOneHasNoPartInFrontOfTheOther) {
  const SpacePolygon square = floor_of(2, 2);
  for (const SpacePolygon& other :
       {square, reversed(square), moved(square, 1, {2, 0, 0}), moved(square, 1, {5, 0, 3}),
        reversed(ceiling_of(2, 2, 1)), reversed(rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 2})),
        rectangle({0, 0, -2}, {0, 2, 0}, {0, 0, 2}), rectangle({2, 2, 0}, {1, 0, 0}, {0, 0, -1})}) {
    const UnobstructedMeasure3 result = measure(square, other);
    EXPECT_EQ(result.measure, 0);
    EXPECT_EQ(result.error, 0);
    EXPECT_EQ(result.bounds, (Enclosure{0, 0}));
    EXPECT_TRUE(result.has_converged);
  }
}

// A corner that is in front by 1 of 2^60, where no double tells it from one in the plane.
TEST(Unobstructed3, IsNotZeroWhereTheLeastPartIsInFront) {
  const Integer s = Integer(1) << 60;
  const SpacePolygon wide{{0, 0, 0}, {s, 1, 0}, {1, s, 0}};
  for (int lift = -1; lift <= 1; ++lift) {
    const UnobstructedMeasure3 result = measure(wide, {{s, s, lift}, {s / 2, s + 1, -s}, {s + 3, s / 2, -s}});
    const UnobstructedMeasure3 back = measure(wide, {{s, s, lift}, {s + 3, s / 2, -s}, {s / 2, s + 1, -s}});
    EXPECT_EQ(std::max(result.measure, back.measure) > 0, lift > 0);
    EXPECT_EQ(std::max(result.bounds.upper, back.bounds.upper) > 0, lift > 0);
    EXPECT_EQ(std::min(result.measure, back.measure), 0);
  }
}

TEST(Unobstructed3, TolerancesBeyondRoundingAreToldNotMet) {
  const UnobstructedMeasure3 result = measure(floor_of(1, 1), ceiling_of(1, 1, 1), 1e-20);
  EXPECT_FALSE(result.has_converged);
  expect_encloses(result, parallel_factor(1, 1), 1e-18L);
  EXPECT_LE(result.error, 1e-15);
}

// A patch and one that is a thousand times smaller.
TEST(Unobstructed3, PairsOfUnequalSizeConverge) {
  Random random(10);
  int facing = 0, converged = 0;
  for (int round = 0; round < 300 / kFewer; ++round) {
    const SpacePolygon large = moved(random.triangle(100), 1000, {0, 0, 0});
    const SpacePolygon small =
        moved(random.triangle(100), 1, {random.integer(0, 100000), random.integer(0, 100000), 0});
    const UnobstructedMeasure3 result = measure(small, large, 1e-9), tight = measure(small, large, 1e-13);
    if (result.measure == 0) continue;
    ++facing;
    EXPECT_TRUE(result.has_converged);
    converged += tight.has_converged;
    EXPECT_NEAR(result.measure, tight.measure, result.error + tight.error);
  }
  EXPECT_GE(converged, facing - 1);
}

// The regular triangle of side 3, with the weight 7, has the area 9/4 sqrt(3) / 49.
TEST(PatchArea3, IsEnclosed) {
  Patch3 patch;
  patch.corners = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
  patch.weight = 7;
  const Enclosure area_of_triangle = patch_area(integer_scene(), patch);
  const long double truth = 9 * std::sqrt(3.0L) / 2 / 49;
  EXPECT_LE(static_cast<long double>(area_of_triangle.lower), truth);
  EXPECT_GE(static_cast<long double>(area_of_triangle.upper), truth);
  EXPECT_LE(area_of_triangle.width(), 2e-14 * area_of_triangle.lower);

  const Integer s = Integer(1) << 100;
  const Enclosure needle = patch_area(integer_scene(), patch_of({{0, 0, 0}, {s, 0, 0}, {s + 1, 1, 0}}));
  EXPECT_TRUE(needle.contains(std::ldexp(1, 99)));
  EXPECT_GT(needle.lower, 0);
}

}  // namespace
}  // namespace hottel::unobstructed_test
