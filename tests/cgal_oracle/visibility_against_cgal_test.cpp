// Visibility polygons against CGAL's triangular expansion over the exact kernel: areas and corners equal as rationals.
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <CGAL/version.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/visibility_polygon.h"

namespace hottel::visibility_against_cgal_test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
using Visibility = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;

using Corners = std::vector<Point2>;

Kernel::Point_2 to_cgal(const Point2& p) { return {Kernel::FT(p.x), Kernel::FT(p.y)}; }
Point2 from_cgal(const Kernel::Point_2& p) { return {CGAL::exact(p.x()), CGAL::exact(p.y())}; }

Rational twice_area(const Corners& corners) {
  Rational sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point2 &p = corners[k], &q = corners[(k + 1) % corners.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

// Counter-clockwise, without corners that are none, from the lexicographically smallest on.
Corners canonical(Corners corners) {
  if (twice_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  for (std::size_t k = 0; k < corners.size() && corners.size() > 2;) {
    const std::size_t n = corners.size();
    const Point2 &p = corners[(k + n - 1) % n], &q = corners[k], &r = corners[(k + 1) % n];
    if ((q.x - p.x) * (r.y - p.y) == (q.y - p.y) * (r.x - p.x)) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
      k = k == 0 ? 0 : k - 1;
    } else {
      ++k;
    }
  }
  const auto precedes = [](const Point2& p, const Point2& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), precedes), corners.end());
  return corners;
}

Corners corners_of(const Arrangement::Face_const_handle& face) {
  Corners corners;
  auto edge = face->outer_ccb();
  const auto first = edge;
  do corners.push_back(from_cgal(edge->target()->point()));
  while (++edge != first);
  return corners;
}

// CGAL 6 locates into a std::variant, CGAL 5 into boost's.
template <class Place>
const Arrangement::Face_const_handle* face_in(const Place& place) {
#if CGAL_VERSION_MAJOR >= 6
  return std::get_if<Arrangement::Face_const_handle>(&place);
#else
  return boost::get<Arrangement::Face_const_handle>(&place);
#endif
}

Scene2 scene(const std::string& kind, std::uint64_t n, std::uint64_t seed) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  request.seed = seed;
  return generate_2(request);
}

// A room around the scene: of edges on a lattice all are inside, and everything is bounded. CGAL knows no solids.
Scene2 in_a_room(Scene2 scene) {
  for (Group& group : scene.groups) group.behind = Behind::kOpen;
  Rational low = scene.edges[0].from.x, high = low;
  for (const Edge2& s : scene.edges)
    for (const Rational* v : {&s.from.x, &s.from.y, &s.to.x, &s.to.y}) {
      low = std::min(low, *v);
      high = std::max(high, *v);
    }
  low -= 1;
  high += 1;
  const Point2 corner[] = {{low, low}, {low, high}, {high, high}, {high, low}};
  for (int k = 0; k < 4; ++k) {
    Surface wall;
    wall.name = "outer wall " + std::to_string(k);
    scene.add(wall, {corner[k], corner[(k + 1) % 4]});
  }
  return scene;
}

class VisibilityAgainstCgal : public testing::TestWithParam<std::string> {
 protected:
  struct Both {
    explicit Both(const Scene2& scene)
        : arrangement(scene, Division2(scene.surfaces.size(), 1)),
          location(arrangement.vertices(), arrangement.triangulation()) {
      std::vector<Kernel::Segment_2> segments;
      for (const Edge2& s : scene.edges) segments.emplace_back(to_cgal(s.from), to_cgal(s.to));
      CGAL::insert(cgal, segments.begin(), segments.end());
      visibility.attach(cgal);
    }

    Arrangement2 arrangement;
    PointLocation2 location;
    Arrangement cgal;
    Visibility visibility;
  };

  static void compare(const VisibilityPolygon2& polygon, const Corners& expected) {
    ASSERT_TRUE(polygon.area.has_value()) << "closed: no sky is seen";
    EXPECT_EQ(*polygon.area * 2, abs(twice_area(expected)));
    EXPECT_EQ(canonical(polygon.corners()), canonical(expected));
  }
};

// Points inside a cell: anywhere, on lines through two vertices, and on the rays of bitangents.
TEST_P(VisibilityAgainstCgal, AgreesFromPointsInTheOpen) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Both both(in_a_room(scene(GetParam(), 20 + 30 * seed, seed)));
    const CGAL::Arr_naive_point_location<Arrangement> locate(both.cgal);
    const Vertices2& vertices = both.arrangement.vertices();
    std::mt19937_64 random(seed);
    for (int k = 0; k < 200; ++k) {
      const auto any = [&] {
        return vertices.to_scene(vertices.exact(static_cast<VertexId>(random() % vertices.size())));
      };
      const auto share = [&] {
        Rational value(static_cast<long>(random() % 97), 96);
        value.canonicalize();
        return value;
      };
      const Point2 p = any(), q = any(), r = any();
      const Rational s = share(), t = k % 4 == 0 ? Rational(0) : Rational(share() / 2);
      const Point2 eye{p.x + s * (q.x - p.x) + t * (r.x - p.x), p.y + s * (q.y - p.y) + t * (r.y - p.y)};
      const auto place = locate.locate(to_cgal(eye));
      const auto* face = face_in(place);
      if (face == nullptr || (*face)->is_unbounded()) continue;
      Arrangement seen;
      const auto found = both.visibility.compute_visibility(to_cgal(eye), *face, seen);
      SCOPED_TRACE(eye.x.get_str() + " " + eye.y.get_str());
      compare(visibility_polygon(both.arrangement, both.location, eye), corners_of(found));
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

// On an edge both sides are seen at once: CGAL's two halves have the same area together.
TEST_P(VisibilityAgainstCgal, AgreesFromPointsOnEdges) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Both both(in_a_room(scene(GetParam(), 20 + 30 * seed, seed)));
    int number = 0;
    for (auto edge = both.cgal.edges_begin(); edge != both.cgal.edges_end(); ++edge, ++number) {
      if (number % 3 != 0 || edge->face()->is_unbounded() || edge->twin()->face()->is_unbounded()) continue;
      const Point2 a = from_cgal(edge->source()->point()), b = from_cgal(edge->target()->point());
      const Point2 eye{(a.x + 2 * b.x) / 3, (a.y + 2 * b.y) / 3};
      Rational expected = 0;
      for (const Arrangement::Halfedge_const_handle side :
           {Arrangement::Halfedge_const_handle(edge), Arrangement::Halfedge_const_handle(edge->twin())}) {
        Arrangement seen;
        expected += abs(twice_area(corners_of(both.visibility.compute_visibility(to_cgal(eye), side, seen))));
      }
      const VisibilityPolygon2 polygon = visibility_polygon(both.arrangement, both.location, eye);
      ASSERT_TRUE(polygon.area.has_value());
      EXPECT_EQ(*polygon.area * 2, expected) << eye.x << " " << eye.y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, VisibilityAgainstCgal,
                         testing::Values("room", "clutter", "lattice", "maze", "comb", "star", "pillars"),
                         [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace hottel::visibility_against_cgal_test
