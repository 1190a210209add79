#include "geometry/space/exchange/vertex_graph.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/space/visibility/visibility_finder.h"
#include "kernel/root_sum.h"
#include "kernel/rounding.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {
namespace {

using Coordinates = std::tuple<Rational, Rational, Rational>;

Coordinates coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

Point3 middle_of(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

// The vertices that one sees, nearest ones alone of those in one direction.
class Sights {
 public:
  Sights(const PreparedScene3& prepared, const std::vector<GraphVertex3>& vertices)
      : prepared_(prepared), vertices_(vertices) {}

  std::vector<std::uint32_t> from(std::uint32_t v) const {
    const Point3& eye = vertices_[v].point;
    if (prepared_.arrangement().solids().around(eye)) return {};
    const ExactVisibilityMap3 map(prepared_.occluders(), eye);
    const VisibilityFinder3 finder(map);
    using Way = std::tuple<Integer, Integer, Integer>;
    std::map<Way, std::uint32_t> nearest;
    for (std::uint32_t w = 0; w < vertices_.size(); ++w) {
      if (w == v || !finder.sees(vertices_[w].point)) continue;
      const IntegerVector way = map.toward(vertices_[w].point);
      const auto [place, is_new] = nearest.try_emplace(Way(way.x, way.y, way.z), w);
      if (!is_new && distance(v, w) < distance(v, place->second)) place->second = w;
    }
    std::vector<std::uint32_t> seen;
    for (const auto& [way, w] : nearest) seen.push_back(w);
    std::ranges::sort(seen);
    return seen;
  }

 private:
  Rational distance(std::uint32_t v, std::uint32_t w) const {
    const Vector3 way = vertices_[w].point - vertices_[v].point;
    return dot(way, way);
  }

  const PreparedScene3& prepared_;
  const std::vector<GraphVertex3>& vertices_;
};

// The edges of polygons, for the first one on which a segment lies.
class Edges {
 public:
  explicit Edges(const Scene3& scene) {
    for (std::uint32_t s = 0; s < scene.polygons.size(); ++s) {
      add(s, scene.polygons[s].points);
      for (const std::vector<Point3>& hole : scene.polygons[s].holes) add(s, hole);
    }
  }

  std::optional<std::uint32_t> along(const Point3& a, const Point3& b) const {
    for (const Edge& edge : edges_)
      if (is_near(edge, to_doubles(a)) && is_near(edge, to_doubles(b)) && is_on(edge, a) && is_on(edge, b))
        return edge.surface;
    return std::nullopt;
  }

 private:
  struct Edge {
    std::uint32_t surface;
    Point3 from, to;
    std::array<double, 3> low, high;
  };

  void add(std::uint32_t surface, const std::vector<Point3>& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Edge edge{surface, loop[k], loop[(k + 1) % loop.size()], {}, {}};
      const std::array<double, 3> from = to_doubles(edge.from), to = to_doubles(edge.to);
      for (std::size_t c = 0; c < 3; ++c) std::tie(edge.low[c], edge.high[c]) = std::minmax(from[c], to[c]);
      edges_.push_back(std::move(edge));
    }
  }
  // Rounding keeps the order of numbers.
  static bool is_near(const Edge& edge, const std::array<double, 3>& p) {
    return p[0] >= edge.low[0] && p[0] <= edge.high[0] && p[1] >= edge.low[1] && p[1] <= edge.high[1] &&
           p[2] >= edge.low[2] && p[2] <= edge.high[2];
  }
  static bool is_on(const Edge& edge, const Point3& p) {
    const Vector3 way = edge.to - edge.from, place = p - edge.from;
    return cross(way, place).is_zero() && dot(way, place) >= 0 && dot(way, place) <= dot(way, way);
  }

  std::vector<Edge> edges_;
};

}  // namespace

std::vector<GraphVertex3> graph_vertices_3(const Scene3& scene) {
  std::vector<GraphVertex3> vertices;
  std::map<Coordinates, std::uint32_t> known;
  for (std::uint32_t s = 0; s < scene.polygons.size(); ++s)
    for (Point3& point : corners_of(scene.polygons[s]))
      if (known.try_emplace(coordinates(point), s).second) vertices.push_back({std::move(point), s});
  return vertices;
}

std::vector<VisiblePair3> visibility_graph_3(const PreparedScene3& prepared,
                                             const std::function<void(double)>& progress) {
  const std::vector<GraphVertex3> vertices = graph_vertices_3(prepared.scene);
  const Sights sights(prepared, vertices);
  std::vector<std::vector<std::uint32_t>> seen(vertices.size());
  ProgressCount count(progress, vertices.size());
  parallel_for(
      vertices.size(),
      [&](std::size_t v) {
        throw_if_interrupted();
        seen[v] = sights.from(static_cast<std::uint32_t>(v));
        count.add(1);
      },
      1);
  const Edges edges(prepared.scene);
  const Solids3& solids = prepared.arrangement().solids();
  std::vector<std::vector<VisiblePair3>> pairs(vertices.size());
  parallel_for(vertices.size(), [&](std::size_t k) {
    const auto v = static_cast<std::uint32_t>(k);
    for (const std::uint32_t w : seen[v]) {
      if (w < v || !std::ranges::binary_search(seen[w], v)) continue;
      const Point3 &a = vertices[v].point, &b = vertices[w].point;
      if (!solids.is_empty() && solids.around(middle_of(a, b))) continue;
      pairs[v].push_back({v, w, edges.along(a, b)});
    }
  });
  std::vector<VisiblePair3> result;
  for (const auto& some : pairs) result.insert(result.end(), some.begin(), some.end());
  return result;
}

double length_between(const Point3& a, const Point3& b) {
  const Vector3 way = b - a;
  RootSum root;
  root.add(1, dot(way, way));
  return round_quotient(root, RootSum(Rational(1))).number.value;
}

}  // namespace hottel
