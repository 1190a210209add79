#include "tests/oracle/space/random_polygons.h"

#include <algorithm>
#include <array>
#include <random>

namespace hottel::oracle {
namespace {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  // A number in [low, high]; the library's distributions differ between platforms.
  long number(long low, long high) {
    return low + static_cast<long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

mpq_class& coordinate(SpacePoint& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

// One face of a box in parts x parts rectangles: across `axis`, at its high or low end, seen from outside.
void add_face(const SpacePoint& low, const SpacePoint& high, int axis, bool is_high, int parts,
              std::vector<SpacePolygon>& polygons) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  SpacePoint from = low, to = high;
  const auto at = [&](int i, int j) {
    SpacePoint p = is_high ? high : low;
    coordinate(p, u) = coordinate(from, u) + (coordinate(to, u) - coordinate(from, u)) * i / parts;
    coordinate(p, v) = coordinate(from, v) + (coordinate(to, v) - coordinate(from, v)) * j / parts;
    return p;
  };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      SpacePolygon polygon{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (!is_high) std::reverse(polygon.begin(), polygon.end());
      polygons.push_back(std::move(polygon));
    }
}

void add_box(const SpacePoint& low, const SpacePoint& high, int parts, bool has_bottom,
             std::vector<SpacePolygon>& polygons) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_high : {false, true})
      if (has_bottom || is_high || axis != 2) add_face(low, high, axis, is_high, parts, polygons);
}

}  // namespace

std::vector<SpacePolygon> room_of_walls(const SpacePoint& low, const SpacePoint& high, int parts) {
  std::vector<SpacePolygon> polygons;
  add_box(low, high, parts, true, polygons);
  for (SpacePolygon& polygon : polygons) std::reverse(polygon.begin(), polygon.end());
  return polygons;
}

std::vector<SpacePolygon> box(const SpacePoint& low, const SpacePoint& high) {
  std::vector<SpacePolygon> polygons;
  add_box(low, high, 1, true, polygons);
  return polygons;
}

std::vector<SpacePolygon> lattice_room(std::uint64_t seed, int cells, int sparsity, int parts, int wall_parts) {
  Chance chance(seed);
  const int end = 4 * cells + 1;
  std::vector<SpacePolygon> polygons = room_of_walls({-1, -1, 0}, {end, end, end}, wall_parts);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k) {
        if ((i + j + k) % 2 != 0 || chance.number(1, sparsity) != 1) continue;
        const auto low = [&chance](int cell) { return mpq_class(4 * cell + chance.number(0, 1)); };
        const auto high = [&chance](int cell) { return mpq_class(4 * cell + chance.number(3, 4)); };
        const SpacePoint from{low(i), low(j), low(k)}, to{high(i), high(j), high(k)};
        add_box(from, to, parts, from.z != 0, polygons);
      }
  return polygons;
}

std::vector<SpacePolygon> piercing_triangles(std::uint64_t seed, int n, long size, long extent) {
  Chance chance(seed);
  std::vector<SpacePolygon> polygons;
  while (static_cast<int>(polygons.size()) < n) {
    SpacePolygon triangle;
    const std::array<long, 3> corner{chance.number(0, size - extent), chance.number(0, size - extent),
                                     chance.number(0, size - extent)};
    for (int k = 0; k < 3; ++k)
      triangle.push_back({corner[0] + chance.number(0, extent), corner[1] + chance.number(0, extent),
                          corner[2] + chance.number(0, extent)});
    const SpacePoint normal = normal_of(triangle);
    if (normal == SpacePoint{0, 0, 0}) continue;
    const bool is_alone = std::none_of(polygons.begin(), polygons.end(), [&](const SpacePolygon& other) {
      return cross(normal, normal_of(other)) == SpacePoint{0, 0, 0} && dot(normal, other[0] - triangle[0]) == 0;
    });
    if (is_alone) polygons.push_back(std::move(triangle));
  }
  return polygons;
}

std::vector<SpacePolygon> moved(std::vector<SpacePolygon> polygons, const mpq_class& scale, const SpacePoint& offset) {
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon) p = {scale * p.x + offset.x, scale * p.y + offset.y, scale * p.z + offset.z};
  return polygons;
}

}  // namespace hottel::oracle
