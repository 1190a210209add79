// Maps of what points of space see against CGAL's lower envelopes of triangles over the exact kernel.
//
// The directions from an eye fall into six pyramids, one behind each face of a cube around it. In one of them let d be
// the depth along its axis, and u, v the other two coordinates. (u, v, d) -> (u/d, v/d, -1/d) keeps planes, and what is
// met first becomes what is lowest: the lower envelope of the triangles, cut to the pyramid, is the map.
#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <list>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/space/arrangement/coplanar_clusters.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel::visibility_map_against_cgal_test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Env_surface_data_traits_3<CGAL::Env_triangle_traits_3<Kernel>, std::size_t>;
using Diagram = CGAL::Envelope_diagram_2<Traits>;

constexpr double kTolerance = 1e-12;

// A vector, and a convex polygon of them.
using Local = std::array<Rational, 3>;
using Cone = std::vector<Local>;

Rational dot(const Local& a, const Local& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// What is on the side of a plane through the eye where inward . w >= 0.
Cone clipped(const Cone& cone, const Local& inward) {
  Cone result;
  for (std::size_t k = 0; k < cone.size(); ++k) {
    const Local &a = cone[k], &b = cone[(k + 1) % cone.size()];
    const Rational at_a = dot(inward, a), at_b = dot(inward, b);
    if (at_a >= 0) result.push_back(a);
    if (sgn(at_a) * sgn(at_b) >= 0) continue;
    const Rational t = at_a / (at_a - at_b);
    result.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
  }
  return result;
}

// One of the six pyramids, and vectors in its coordinates u, v, d.
struct Pyramid {
  int axis;
  bool is_backward;

  Local local(const Rational& x, const Rational& y, const Rational& z) const {
    const Local w{x, y, z};
    return {w[(axis + 1) % 3], w[(axis + 2) % 3], is_backward ? Rational(-w[axis]) : w[axis]};
  }
};

Kernel::Point_3 projected(const Local& w) {
  return {Kernel::FT(Rational(w[0] / w[2])), Kernel::FT(Rational(w[1] / w[2])), Kernel::FT(Rational(-1 / w[2]))};
}

// What is seen of each polygon: its part of the full sphere, and the view factor.
struct Seen {
  std::vector<double> fractions, factors;
};

class Envelopes {
 public:
  Envelopes(const std::vector<Polygon3>& polygons, const Look3& look) : polygons_(polygons), look_(look) {
    seen_.fractions.assign(polygons.size(), 0);
    seen_.factors.assign(polygons.size(), 0);
  }

  Seen make() {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool is_backward : {false, true}) add(Pyramid{axis, is_backward});
    return seen_;
  }

 private:
  void add(const Pyramid& pyramid) {
    normal_.reset();
    if (look_.normal) {
      const Local n = pyramid.local(look_.normal->x, look_.normal->y, look_.normal->z);
      const double x = to_double(n[0]), y = to_double(n[1]), z = to_double(n[2]);
      const double length = std::sqrt(x * x + y * y + z * z);
      normal_ = Direction3{x / length, y / length, z / length};
    }
    std::vector<Traits::Surface_3> triangles;
    for (std::size_t s = 0; s < polygons_.size(); ++s) add_triangles(pyramid, s, triangles);
    Diagram diagram;
    CGAL::lower_envelope_3(triangles.begin(), triangles.end(), diagram);
    for (auto face = diagram.faces_begin(); face != diagram.faces_end(); ++face) {
      if (face->number_of_surfaces() == 0) continue;
      ASSERT_EQ(face->number_of_surfaces(), 1u);
      const std::size_t s = face->surface().data();
      for (auto border = face->outer_ccbs_begin(); border != face->outer_ccbs_end(); ++border) add_border(*border, s);
      for (auto border = face->inner_ccbs_begin(); border != face->inner_ccbs_end(); ++border) add_border(*border, s);
    }
  }

  // A polygon in whose plane the eye lies has no solid angle.
  void add_triangles(const Pyramid& pyramid, std::size_t s, std::vector<Traits::Surface_3>& triangles) const {
    const std::vector<Point3>& points = polygons_[s].points;
    const Vector3 area = doubled_area(polygons_[s]), away = points[0] - look_.eye;
    if (dot(Local{area.x, area.y, area.z}, Local{away.x, away.y, away.z}) == 0) return;
    Cone cone;
    for (const Point3& p : points)
      cone.push_back(pyramid.local(p.x - look_.eye.x, p.y - look_.eye.y, p.z - look_.eye.z));
    for (const Local& side : {Local{1, 0, 1}, Local{-1, 0, 1}, Local{0, 1, 1}, Local{0, -1, 1}})
      cone = clipped(cone, side);
    if (look_.normal) cone = clipped(cone, pyramid.local(look_.normal->x, look_.normal->y, look_.normal->z));
    for (std::size_t k = 1; k + 1 < cone.size(); ++k) {
      const Kernel::Triangle_3 triangle(projected(cone[0]), projected(cone[k]), projected(cone[k + 1]));
      if (!triangle.is_degenerate()) triangles.emplace_back(triangle, s);
    }
  }

  // The border runs with the face on its left.
  void add_border(Diagram::Ccb_halfedge_circulator edge, std::size_t s) {
    const auto first = edge;
    do {
      const auto &p = edge->source()->point(), &q = edge->target()->point();
      const Rational px = CGAL::exact(p.x()), py = CGAL::exact(p.y()), qx = CGAL::exact(q.x()), qy = CGAL::exact(q.y());
      add_edge({to_double(px), to_double(py), 1}, {to_double(qx), to_double(qy), 1}, to_double(px * qy - py * qx), s);
    } while (++edge != first);
  }

  // The triangle of the axis and an edge, with sign; turn: the determinant of all three.
  // SEE: Van Oosterom, Strackee, The solid angle of a plane triangle, 1983; Lambert, Photometria, 1760.
  void add_edge(const Direction3& a, const Direction3& b, double turn, std::size_t s) {
    const double la = length(a), lb = length(b);
    seen_.fractions[s] += 2 * std::atan2(turn, la * lb + hottel::dot(a, b) + la + lb) / (4 * std::numbers::pi);
    if (!normal_) return;
    const Direction3 m{a.y - b.y, b.x - a.x, turn};  // a x b
    const double size = length(m);
    if (size > 0)
      seen_.factors[s] +=
          std::atan2(size, hottel::dot(a, b)) * hottel::dot(m, *normal_) / size / (2 * std::numbers::pi);
  }

  const std::vector<Polygon3>& polygons_;
  const Look3& look_;
  std::optional<Direction3> normal_;  // in the coordinates of the pyramid
  Seen seen_;
};

// What is most off of all polygons.
double difference(const std::vector<Polygon3>& polygons, const Look3& look, const VisibilityMap3& map) {
  Seen rest = Envelopes(polygons, look).make();
  for (const VisibilityMap3::Share& share : map.shares) {
    rest.fractions[share.face.surface] -= share.fraction;
    if (look.normal) rest.factors[share.face.surface] -= share.factor;
  }
  double most = 0;
  for (const auto* list : {&rest.fractions, &rest.factors})
    for (const double value : *list) most = std::max(most, std::fabs(value));
  return most;
}

// ---- scenes

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  long below(long n) { return static_cast<long>(engine_() % static_cast<std::uint64_t>(n)); }
  // On the lattice, close to it, or anywhere within it.
  Point3 eye(long size) {
    const long parts = std::array{1L, 2L, 7L, 1'000'003L}[static_cast<std::size_t>(below(4))];
    const auto coordinate = [&]() -> Rational {
      Rational value(below(size * parts + 1), parts);
      value.canonicalize();
      return value;
    };
    return {coordinate(), coordinate(), coordinate()};
  }
  Point3 direction() {
    const Point3 n{below(7) - 3, below(7) - 3, below(7) - 3};
    return n == Point3{} ? Point3{0, 0, 1} : n;
  }

 private:
  std::mt19937_64 engine_;
};

bool is_scene(const std::vector<Polygon3>& polygons) { return coplanar_clusters(polygons).size() == polygons.size(); }

// Corners on a lattice of (size + 1)^3 points; no two triangles share an area.
std::vector<Polygon3> piercing_triangles(std::uint64_t seed, std::size_t count, long size) {
  Random random(seed);
  const auto corner = [&]() -> Point3 {
    return {random.below(size + 1), random.below(size + 1), random.below(size + 1)};
  };
  std::vector<Polygon3> polygons;
  while (polygons.size() < count) {
    polygons.push_back({{corner(), corner(), corner()}});
    if (!polygon_problem(polygons.back()).text.empty() || !is_scene(polygons)) polygons.pop_back();
  }
  return polygons;
}

// The faces of a box, their fronts outward, or inward; those in the planes of the walls of a room are left out.
void add_box(const std::array<long, 3>& low, const std::array<long, 3>& high, bool is_inward, long room,
             std::vector<Polygon3>& polygons) {
  for (std::size_t a = 0; a < 3; ++a)
    for (const bool is_high : {false, true}) {
      const long at = is_high ? high[a] : low[a];
      if (!is_inward && (at == 0 || at == room)) continue;
      Polygon3 face;
      for (const auto& [u, v] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
        std::array<long, 3> p{};
        p[a] = at;
        p[(a + 1) % 3] = u ? high[(a + 1) % 3] : low[(a + 1) % 3];
        p[(a + 2) % 3] = v ? high[(a + 2) % 3] : low[(a + 2) % 3];
        face.points.push_back({p[0], p[1], p[2]});
      }
      if (is_high == is_inward) std::reverse(face.points.begin(), face.points.end());
      polygons.push_back(std::move(face));
    }
}

// A room with boxes in cells of a chessboard: they stand on walls, and meet along edges and in corners.
std::vector<Polygon3> room_with_boxes(std::uint64_t seed, long cells, int boxes) {
  Random random(seed);
  std::vector<Polygon3> polygons;
  const long room = 2 * cells;
  add_box({0, 0, 0}, {room, room, room}, true, room, polygons);
  std::vector<std::array<long, 3>> taken;
  while (boxes > 0) {
    const std::array<long, 3> cell{random.below(cells), random.below(cells), random.below(cells)};
    if ((cell[0] + cell[1] + cell[2]) % 2 != 0 || std::ranges::count(taken, cell) > 0) continue;
    taken.push_back(cell);
    const std::array<long, 3> low{2 * cell[0], 2 * cell[1], 2 * cell[2]};
    add_box(low, {low[0] + 2, low[1] + 2, low[2] + 2}, false, room, polygons);
    --boxes;
  }
  return polygons;
}

void expect_equal_maps(const std::vector<Polygon3>& polygons, std::uint64_t seed, long size, int eyes) {
  const Occluders3 occluders(polygons);
  Random random(seed);
  for (int e = 0; e < eyes; ++e) {
    Look3 look{.eye = random.eye(size), .normal = {}};
    if (e % 3 == 2) look.normal = random.direction();
    const VisibilityMap3 map = map_from(occluders, look);
    EXPECT_LE(difference(polygons, look, map), kTolerance) << "seed " << seed << ", eye " << e;
  }
}

TEST(VisibilityMapAgainstCgal, TheEnvelopeSeesAMapThatIsWrong) {
  const std::vector<Polygon3> polygons = room_with_boxes(1, 3, 4);
  const Look3 look{.eye = {Rational(1, 3), Rational(7, 2), 3}, .normal = Point3{1, 0, 0}};
  VisibilityMap3 map = map_from(Occluders3(polygons), look);
  EXPECT_LE(difference(polygons, look, map), 1e-15);
  map.shares.back().factor += 1e-9;
  EXPECT_GT(difference(polygons, look, map), kTolerance);
  map = map_from(Occluders3(polygons), look);
  map.shares.pop_back();
  EXPECT_GT(difference(polygons, look, map), kTolerance);
}

TEST(VisibilityMapAgainstCgal, AnEmptyRoomIsSixEqualParts) {
  const std::vector<Polygon3> polygons = room_with_boxes(1, 2, 0);
  const Look3 look{.eye = {2, 2, 2}, .normal = {}};
  for (const double fraction : Envelopes(polygons, look).make().fractions) EXPECT_NEAR(fraction, 1.0 / 6, 1e-16);
}

TEST(VisibilityMapAgainstCgal, OfTrianglesThatPierceEachOther) {
  for (std::uint64_t seed = 0; seed < 24; ++seed)
    expect_equal_maps(piercing_triangles(seed, 6 + seed % 4 * 4, 3 + static_cast<long>(seed % 5)), seed,
                      3 + static_cast<long>(seed % 5), 6);
}

TEST(VisibilityMapAgainstCgal, OfRoomsWithBoxesThatTouch) {
  for (std::uint64_t seed = 0; seed < 16; ++seed)
    expect_equal_maps(room_with_boxes(seed, 2 + static_cast<long>(seed % 3), 1 + static_cast<int>(seed % 4)), seed,
                      4 + 2 * static_cast<long>(seed % 3), 6);
}

}  // namespace
}  // namespace hottel::visibility_map_against_cgal_test
