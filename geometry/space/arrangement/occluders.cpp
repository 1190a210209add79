#include "geometry/space/arrangement/occluders.h"

#include <array>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint32_t kLeafSize = 4;

// The distinct points in the order in which they first occur, and the outlines made of their numbers.
std::vector<Point3> distinct_points(const std::vector<Polygon3>& polygons,
                                    std::vector<std::vector<VertexId3>>& outlines) {
  const auto precedes = [](const Point3* a, const Point3* b) {
    return std::tie(a->x, a->y, a->z) < std::tie(b->x, b->y, b->z);
  };
  std::map<const Point3*, VertexId3, decltype(precedes)> numbers(precedes);
  std::vector<Point3> points;
  for (const Polygon3& polygon : polygons) {
    std::vector<VertexId3>& outline = outlines.emplace_back();
    for (const Point3& point : polygon.points) {
      const auto [place, is_new] = numbers.try_emplace(&point, VertexId3(points.size()));
      if (is_new) points.push_back(point);
      outline.push_back(place->second);
    }
  }
  return points;
}

}  // namespace

Occluders3::Occluders3(const std::vector<Polygon3>& polygons) {
  std::vector<std::vector<VertexId3>> outlines;
  vertices_ = Vertices3(distinct_points(polygons, outlines));
  add_outlines(outlines);
  add_edges();
  add_tree();
}

Occluders3::Occluders3(Vertices3 vertices, const std::vector<std::vector<VertexId3>>& outlines)
    : vertices_(std::move(vertices)) {
  add_outlines(outlines);
  add_edges();
  add_tree();
}

void Occluders3::add_outlines(const std::vector<std::vector<VertexId3>>& outlines) {
  for (const std::vector<VertexId3>& outline : outlines) {
    IntegerVector normal;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const VertexId3 before = outline[(k + outline.size() - 1) % outline.size()];
      const IntegerVector turn = turn_at(vertices_, before, outline[k], outline[(k + 1) % outline.size()]);
      if (is_zero(turn)) continue;
      if (is_zero(normal)) normal = primitive(turn);
      corners_.push_back(outline[k]);
    }
    HOTTEL_REQUIRE(!is_zero(normal));
    normals_.push_back(rounded(normal, std::max(0L, bits(normal) - 53)));
    exact_normals_.push_back(std::move(normal));
    first_.push_back(corners_.size());
  }
}

void Occluders3::add_edges() {
  std::map<std::pair<VertexId3, VertexId3>, EdgeId3> numbers;
  for (std::size_t s = 0; s < size(); ++s) {
    const auto corners = outline(s);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [from, to] = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
      const auto [place, is_new] = numbers.try_emplace({from, to}, EdgeId3(edges_.size()));
      if (is_new) {
        const IntegerVector vector = difference(vertices_.exact(to), vertices_.exact(from));
        edges_.push_back({from, to, rounded(vector, std::max(0L, bits(vector) - 53))});
      }
      sides_.push_back({place->second, corners[k] != from});
    }
  }
}

void Occluders3::add_tree() {
  if (size() == 0) return;
  std::vector<std::array<double, 3>> middles(size());
  for (std::size_t s = 0; s < size(); ++s) {
    for (const VertexId3 v : outline(s)) {
      const BoundedVector& p = vertices_.approximate(v);
      middles[s] = {middles[s][0] + p.x, middles[s][1] + p.y, middles[s][2] + p.z};
    }
    for (double& value : middles[s]) value /= static_cast<double>(outline(s).size());
  }
  order_.resize(size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.push_back({0, static_cast<std::uint32_t>(size())});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node node = nodes_[n];
    if (node.end - node.begin <= kLeafSize) continue;
    const auto begin = order_.begin() + node.begin, end = order_.begin() + node.end;
    std::size_t axis = 0;
    double widest = -1;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax_element(
          begin, end, [&middles, a](std::uint32_t s, std::uint32_t t) { return middles[s][a] < middles[t][a]; });
      if (const double width = middles[*high][a] - middles[*low][a]; width > widest) {
        widest = width;
        axis = a;
      }
    }
    const std::uint32_t half = node.begin + (node.end - node.begin) / 2;
    std::nth_element(begin, order_.begin() + half, end, [&middles, axis](std::uint32_t s, std::uint32_t t) {
      return std::pair(middles[s][axis], s) < std::pair(middles[t][axis], t);
    });
    nodes_[n].left = static_cast<std::uint32_t>(nodes_.size());
    nodes_[n].right = nodes_[n].left + 1;
    nodes_.push_back({node.begin, half});
    nodes_.push_back({half, node.end});
  }
}

IntegerVector Occluders3::exact_vector(EdgeId3 e) const {
  return difference(vertices_.exact(edge(e).to), vertices_.exact(edge(e).from));
}

int Occluders3::side_of(VertexId3 v, std::size_t s, SignTier& tier) const {
  const VertexId3 anchor = outline(s).front();
  tier = SignTier::kFilter;
  const int sign = filtered_sign(normal(s), vertices_.approximate_difference(anchor, v));
  if (sign != kUndecided) return sign;
  tier = SignTier::kCombinatorial;
  for (const VertexId3 corner : outline(s))
    if (corner == v) return 0;
  tier = SignTier::kExact;
  return sgn(dot(exact_normal(s), difference(vertices_.exact(v), vertices_.exact(anchor))));
}

Vector3 normal_of_side_3(const Occluders3& occluders, const Face& side) {
  const IntegerVector& n = occluders.exact_normal(side.surface);
  const int sign = side.is_back ? -1 : 1;
  return {Rational(sign * n.x), Rational(sign * n.y), Rational(sign * n.z)};
}

}  // namespace hottel
