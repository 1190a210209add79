#include "geometry/space/contacts/corner_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace hottel {
namespace {

double length(const BoundedVector& v) { return std::hypot(v.x, v.y, v.z); }

VertexId3 id(std::uint32_t c) { return VertexId3(c); }

double quotient_below(const BoundedValue& product, const BoundedVector& normal) {
  const double above = std::fabs(product.value) - product.error;
  return above > 0 ? 0.999 * above / (length(normal) + 2 * normal.error) : 0;
}

// Of the triangle with the first side whose product is the largest: corners may be straight.
BoundedVector normal_of(const Vertices3& vertices, const std::vector<std::uint32_t>& corners) {
  const VertexId3 origin = id(corners[0]);
  const BoundedVector side = vertices.approximate_difference(origin, id(corners[1]));
  BoundedVector normal;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const BoundedVector here = cross(side, vertices.approximate_difference(origin, id(corners[k])));
    if (here.size >= normal.size) normal = here;
  }
  return normal;
}

}  // namespace

CornerTable3::CornerTable3(const std::vector<Polygon3>& polygons) {
  std::vector<const Point3*> all;
  for (const Polygon3& polygon : polygons) {
    for (const Point3& point : polygon.points) all.push_back(&point);
    for (const auto& hole : polygon.holes)
      for (const Point3& point : hole) all.push_back(&point);
  }
  std::vector<std::uint32_t> order(all.size()), first(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return precedes(*all[a], *all[b]); });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && *all[order[k]] == *all[order[k - 1]] ? first[order[k - 1]] : order[k];

  std::vector<std::uint32_t> number(all.size());
  std::uint32_t next = 0;
  for (std::uint32_t s = 0; s < polygons.size(); ++s) {
    of_polygon.emplace_back();
    sides.emplace_back();
    const std::uint32_t end = next + static_cast<std::uint32_t>(corners_of(polygons[s]).size());
    for (; next < end; ++next) {
      if (first[next] == next) {
        number[next] = static_cast<std::uint32_t>(points.size());
        points.push_back(*all[next]);
        at.emplace_back();
      }
      const std::uint32_t c = number[first[next]];
      of_polygon.back().push_back(c);
      if (at[c].empty() || at[c].back() != s) at[c].push_back(s);
    }
    add_sides(polygons[s]);
  }
  vertices = Vertices3(points);
  for (const auto& corners : of_polygon) normals.push_back(normal_of(vertices, corners));
}

// Its corners are the last ones of of_polygon, ring by ring.
void CornerTable3::add_sides(const Polygon3& polygon) {
  const std::vector<std::uint32_t>& corners = of_polygon.back();
  std::size_t begin = 0;
  const auto add = [&](std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      sides.back().emplace_back(corners[begin + k], corners[begin + (k + 1) % count]);
    begin += count;
  };
  add(polygon.points.size());
  for (const auto& hole : polygon.holes) add(hole.size());
}

Box3 CornerTable3::box_of_corner(std::uint32_t c) const {
  Box3 box;
  box.include(vertices.approximate(id(c)));
  return box;
}

Box3 CornerTable3::box_of_polygon(std::uint32_t s) const {
  Box3 box;
  for (const std::uint32_t c : of_polygon[s]) box.include(vertices.approximate(id(c)));
  return box;
}

std::vector<CornerTable3::Edge> CornerTable3::edges() const {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> number;
  std::vector<Edge> result;
  for (std::uint32_t s = 0; s < sides.size(); ++s)
    for (const auto& [from, to] : sides[s]) {
      const auto [a, b] = std::minmax(from, to);
      const auto [place, is_new] = number.try_emplace({a, b}, result.size());
      if (is_new) result.push_back({a, b, {}});
      std::vector<std::uint32_t>& its = result[place->second].polygons;
      if (its.empty() || its.back() != s) its.push_back(s);
    }
  return result;
}

bool CornerTable3::lies_on(std::uint32_t c, std::uint32_t from, std::uint32_t to) const {
  return closest_point(Side3{points[from], points[to]}, points[c]).squared == 0;
}

double width_above(const CornerTable3& corners, std::uint32_t s) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : corners.sides[s]) {
    const BoundedVector along = corners.vertices.approximate_difference(id(from), id(to));
    const double whole = along.x * along.x + along.y * along.y + along.z * along.z;
    for (const std::uint32_t c : corners.of_polygon[s]) {
      if (c == from || c == to) continue;
      const BoundedVector way = corners.vertices.approximate_difference(id(from), id(c));
      // Any point of the side gives a distance that is not below the least one.
      const double t =
          whole > 0 ? std::clamp((along.x * way.x + along.y * way.y + along.z * way.z) / whole, 0.0, 1.0) : 0;
      const double distance = std::hypot(way.x - t * along.x, way.y - t * along.y, way.z - t * along.z);
      const double above = distance + 4 * (way.error + along.error) + 0x1p-50 * (way.size + along.size);
      if (above < least && !corners.lies_on(c, from, to)) least = above;
    }
  }
  return least;
}

BoundedValue height(const CornerTable3& corners, std::uint32_t s, std::uint32_t c) {
  return dot(corners.normals[s], corners.vertices.approximate_difference(id(corners.of_polygon[s][0]), id(c)));
}

double distance_below(const CornerTable3& corners, std::uint32_t s, std::uint32_t c) {
  return quotient_below(height(corners, s, c), corners.normals[s]);
}

double distance_below(const CornerTable3& corners, const CornerTable3::Edge& e, const CornerTable3::Edge& f) {
  const Vertices3& vertices = corners.vertices;
  const BoundedVector normal =
      cross(vertices.approximate_difference(id(e.a), id(e.b)), vertices.approximate_difference(id(f.a), id(f.b)));
  return quotient_below(dot(normal, vertices.approximate_difference(id(e.a), id(f.a))), normal);
}

}  // namespace hottel
