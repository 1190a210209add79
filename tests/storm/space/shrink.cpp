#include "tests/storm/space/shrink.h"

#include <optional>
#include <utility>

namespace hottel::storm {

using oracle::SpacePoint;
using oracle::SpacePolygon;

namespace {

using Fails = std::function<bool(const Polygons3&)>;

template <class List>
List without(List list, std::size_t k) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
  return list;
}

std::vector<Polygons3> with_fewer(const Polygons3& polygons) {
  std::vector<Polygons3> result;
  for (std::size_t k = 2; k < polygons.size(); ++k) result.push_back(without(polygons, k));
  for (std::size_t k = polygons.size(); k-- > 0;)
    for (std::size_t c = 0; polygons[k].size() > 3 && c < polygons[k].size(); ++c) {
      result.push_back(polygons);
      result.back()[k] = without(polygons[k], c);
    }
  return result;
}

mpq_class& coordinate(SpacePoint& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

// What to try for a coordinate: each is simpler.
std::vector<mpq_class> simpler(const mpq_class& x) {
  std::vector<mpq_class> result;
  if (x == 0) return result;
  result.emplace_back(0);
  if (x.get_den() != 1) {
    result.emplace_back(x.get_num() / x.get_den());
    return result;
  }
  if (abs(x) > 2) result.emplace_back(x.get_num() / 2);
  if (abs(x) > 1) result.push_back(x - sgn(x));
  if (x < 0) result.push_back(-x);
  return result;
}

// All corners at a point, or only one of them, with another coordinate.
Polygons3 with_moved(Polygons3 polygons, std::size_t k, std::size_t c, int axis, const mpq_class& to, bool all) {
  const SpacePoint from = polygons[k][c];
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon)
      if (&p == &polygons[k][c] || (all && p == from)) coordinate(p, axis) = to;
  return polygons;
}

std::vector<Polygons3> with_smaller_numbers(const Polygons3& polygons) {
  std::vector<Polygons3> result;
  for (std::size_t k = 0; k < polygons.size(); ++k)
    for (std::size_t c = 0; c < polygons[k].size(); ++c)
      for (int axis = 0; axis < 3; ++axis) {
        SpacePoint p = polygons[k][c];
        for (const mpq_class& to : simpler(coordinate(p, axis)))
          for (const bool all : {true, false}) result.push_back(with_moved(polygons, k, c, axis, to, all));
      }
  return result;
}

std::optional<Polygons3> first_that_fails(const std::vector<Polygons3>& candidates, const Fails& fails) {
  for (const Polygons3& some : candidates)
    if (is_valid_3(some) && fails(some)) return some;
  return std::nullopt;
}

}  // namespace

Polygons3 shrunk_3(Polygons3 polygons, const Fails& fails) {
  for (;;) {
    std::optional<Polygons3> less = first_that_fails(with_fewer(polygons), fails);
    if (!less) less = first_that_fails(with_smaller_numbers(polygons), fails);
    if (!less) return polygons;
    polygons = std::move(*less);
  }
}

}  // namespace hottel::storm
