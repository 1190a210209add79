#include "tests/comparison/space/map_comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/oracle/space/nearest_polygon.h"

namespace hottel::oracle {
namespace {

SpacePoint to_space(const Point3& p) { return {p.x, p.y, p.z}; }

// The distinct points in the order in which they first occur: vertices are numbered so.
std::vector<SpacePoint> vertices_of(const std::vector<SpacePolygon>& polygons) {
  std::vector<SpacePoint> vertices;
  for (const SpacePolygon& polygon : polygons)
    for (const SpacePoint& p : polygon)
      if (std::find(vertices.begin(), vertices.end(), p) == vertices.end()) vertices.push_back(p);
  return vertices;
}

// The normals of the planes of a map, from what defines them.
std::vector<SpacePoint> normals_of(const std::vector<SpacePolygon>& polygons, const Look3& look,
                                   const VisibilityMap3& map) {
  const SpacePoint eye = to_space(look.eye);
  const std::vector<SpacePoint> vertices = vertices_of(polygons);
  // The normal of a polygon towards the eye, and how far the eye is in front.
  const auto facing = [&](std::size_t s) {
    SpacePoint normal = normal_of(polygons[s]);
    mpq_class height = dot(normal, eye - polygons[s][0]);
    if (height < 0) {
      normal = {-normal.x, -normal.y, -normal.z};
      height = -height;
    }
    return std::pair(normal, height);
  };
  std::vector<SpacePoint> normals;
  for (const PlaneDefinition3& plane : map.planes) {
    if (plane.kind == PlaneDefinition3::Kind::kEdge) {
      normals.push_back(cross(vertices[plane.a] - eye, vertices[plane.b] - eye));
    } else if (plane.kind == PlaneDefinition3::Kind::kHorizon) {
      normals.push_back(to_space(*look.normal));
    } else {
      const auto [a, height_a] = facing(plane.a);
      const auto [b, height_b] = facing(plane.b);
      normals.push_back(
          {height_a * b.x - height_b * a.x, height_a * b.y - height_b * a.y, height_a * b.z - height_b * a.z});
    }
  }
  return normals;
}

class Darts {
 public:
  Darts(const VisibilityMap3& map, std::uint64_t seed) : map_(map), engine_(seed) {}

  SpacePoint throw_one() {
    SpacePoint d{number(), number(), number()};
    if (map_.corners.empty() || engine_() % 2 == 0) return d == SpacePoint{0, 0, 0} ? SpacePoint{1, 0, 0} : d;
    // Close to a corner: a fraction 2^-k of the way from it.
    const Direction3& corner = map_.corners[engine_() % map_.corners.size()].direction;
    const double size = std::ldexp(1.0, -static_cast<int>(engine_() % 40) - 20);
    return {mpq_class(corner.x) + d.x * mpq_class(size), mpq_class(corner.y) + d.y * mpq_class(size),
            mpq_class(corner.z) + d.z * mpq_class(size)};
  }

 private:
  mpq_class number() { return static_cast<long>(engine_() % 2000001) - 1000000; }
  const VisibilityMap3& map_;
  std::mt19937_64 engine_;
};

}  // namespace

std::vector<Polygon3> engine_polygons(const std::vector<SpacePolygon>& polygons) {
  std::vector<Polygon3> result;
  for (const SpacePolygon& polygon : polygons) {
    result.emplace_back();
    for (const SpacePoint& p : polygon) result.back().points.push_back({p.x, p.y, p.z});
  }
  return result;
}

std::string dart_disagreement(const std::vector<SpacePolygon>& polygons, const Look3& look, const VisibilityMap3& map,
                              std::uint64_t seed, int count, DartCounts& counts) {
  const SpacePoint eye = to_space(look.eye);
  const std::vector<SpacePoint> normals = normals_of(polygons, look, map);
  const RayCaster caster(polygons, eye);
  Darts darts(map, seed);
  for (int n = 0; n < count; ++n) {
    const SpacePoint d = darts.throw_one();
    NearestPolygon met = caster(d);
    if (look.normal) {
      const int above = sgn(dot(to_space(*look.normal), d));
      if (above == 0) met.is_plain = false;
      if (above < 0) met.polygon = NearestPolygon::kNoPolygon;
    }
    std::vector<int> signs;
    for (const SpacePoint& normal : normals) signs.push_back(sgn(dot(normal, d)));
    std::vector<Face> faces;
    bool is_on_edge = !met.is_plain;
    for (const VisibilityMap3::Fragment& fragment : map.fragments) {
      int least = 1;
      for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
        const PlaneSide3 side = map.corners[c].side;
        least = std::min(least, side.is_opposite ? -signs[side.plane.index()] : signs[side.plane.index()]);
      }
      if (least > 0) faces.push_back(fragment.face);
      is_on_edge |= least == 0;
    }
    if (is_on_edge) {
      ++counts.ambiguous;
      continue;
    }
    ++counts.darts;
    std::vector<Face> expected;
    if (met.polygon >= 0) {
      const SpacePolygon& polygon = polygons[static_cast<std::size_t>(met.polygon)];
      const bool is_back = sgn(dot(normal_of(polygon), eye - polygon[0])) < 0;
      expected.push_back({static_cast<std::uint32_t>(met.polygon), is_back});
    }
    if (faces != expected)
      return fmt::format("dart {}: in {} fragments, {} expected; polygon {} where {} is met", n, faces.size(),
                         expected.size(), faces.empty() ? -1 : static_cast<int>(faces[0].surface), met.polygon);
  }
  return "";
}

}  // namespace hottel::oracle
