#include "geometry/plane/exchange/pair_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hottel {
namespace {

// Lines between two elements that are tried, pairs that are drawn, and lines times edges that are looked at, at most.
constexpr std::size_t kLines = 8, kMostPairs = 4000, kLeastPairs = 200;
constexpr double kMostLookedAt = 4e7;

struct Place {
  double x, y;
};

double side(const Place& a, const Place& b, const Place& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

struct Line {
  Place from, to;
};

// The edges in doubles, from 0 to 1 or so.
std::vector<Line> edges_of(const Scene2& scene) {
  std::vector<Line> edges;
  if (scene.edges.empty()) return edges;
  const Point2 origin = scene.edges.front().from;
  const auto place = [&](const Point2& point) {
    return Place{to_double(point.x - origin.x), to_double(point.y - origin.y)};
  };
  double most = std::numeric_limits<double>::min();
  for (const Edge2& edge : scene.edges) {
    edges.push_back({place(edge.from), place(edge.to)});
    const auto& [from, to] = edges.back();
    most = std::max({most, std::fabs(from.x), std::fabs(from.y), std::fabs(to.x), std::fabs(to.y)});
  }
  const auto scaled = [most](Place& p) { p = {p.x / most, p.y / most}; };
  for (Line& edge : edges) {
    scaled(edge.from);
    scaled(edge.to);
  }
  return edges;
}

class Looking {
 public:
  explicit Looking(const Scene2& scene) : edges_(edges_of(scene)) {}

  bool sees(const DrawnFace& a, const DrawnFace& b, SampleChance& chance) const {
    for (std::size_t k = 0; k < kLines; ++k) {
      const Place p = place_on(a, chance), q = place_on(b, chance);
      if (is_before(q, a.face) && is_before(p, b.face) && is_free(p, q, a.face.surface, b.face.surface)) return true;
    }
    return false;
  }

 private:
  // A point of the element.
  Place place_on(const DrawnFace& drawn, SampleChance& chance) const {
    const auto n = static_cast<double>(drawn.face.elements);
    const double t = (std::floor(drawn.place * n) + chance.share()) / n;
    const auto& [from, to] = edges_[drawn.face.surface];
    return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
  }
  // Fronts are on the right.
  bool is_before(const Place& p, const CountedFace& face) const {
    const double s = side(edges_[face.surface].from, edges_[face.surface].to, p);
    return face.is_back ? s > 0 : s < 0;
  }
  bool is_free(const Place& p, const Place& q, std::uint32_t first, std::uint32_t second) const {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto& [a, b] = edges_[e];
      if (e == first || e == second) continue;
      if (side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0) return false;
    }
    return true;
  }

  const std::vector<Line> edges_;
};

}  // namespace

std::vector<CountedFace> counted_faces_2(const Scene2& scene, Granularity granularity) {
  return counted_faces(scene, granularity,
                       [&scene](std::uint32_t s) { return std::uint64_t{scene.surfaces[s].elements}; });
}

SampledPairs estimated_pairs_2(const Scene2& scene, std::span<const CountedFace> faces) {
  const Looking looking(scene);
  const double fits = kMostLookedAt / static_cast<double>(kLines * (scene.edges.size() + 1));
  const auto samples = static_cast<std::size_t>(std::clamp<double>(fits, kLeastPairs, kMostPairs));
  return sampled_pairs(faces, samples, [&](const DrawnFace& a, const DrawnFace& b, SampleChance& chance) {
    return looking.sees(a, b, chance);
  });
}

}  // namespace hottel
