#include "geometry/space/exchange/pair_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/space/scene/division.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {
namespace {

// Lines between two elements that are tried, pairs that are drawn, and lines times polygons that are looked at, at
// most; points that are drawn to find one in a polygon.
constexpr std::size_t kLines = 8, kMostPairs = 4000, kLeastPairs = 200, kMostDrawn = 200;
constexpr double kMostLookedAt = 3e7;

struct FlatPoint {
  double u, v;
};

// A polygon in doubles, and seen along the axis that its normal is nearest to.
struct Flat {
  Direction3 normal;  // unit; zero where doubles do not tell it
  double offset = 0;  // of its plane
  int axis = 2;
  std::vector<std::vector<FlatPoint>> loops;
  FlatPoint least{}, most{};

  FlatPoint seen(const Direction3& p) const {
    return axis == 0 ? FlatPoint{p.y, p.z} : axis == 1 ? FlatPoint{p.z, p.x} : FlatPoint{p.x, p.y};
  }
  Direction3 lifted(const FlatPoint& p) const {
    const Direction3& n = normal;
    if (axis == 0) return {(offset - n.y * p.u - n.z * p.v) / n.x, p.u, p.v};
    if (axis == 1) return {p.v, (offset - n.z * p.u - n.x * p.v) / n.y, p.u};
    return {p.u, p.v, (offset - n.x * p.u - n.y * p.v) / n.z};
  }
  bool holds(const FlatPoint& p) const {
    if (!(least.u <= p.u && p.u <= most.u && least.v <= p.v && p.v <= most.v)) return false;
    bool is_in = false;
    for (const std::vector<FlatPoint>& loop : loops)
      for (std::size_t k = 0, before = loop.size() - 1; k < loop.size(); before = k++) {
        const FlatPoint &a = loop[before], &b = loop[k];
        if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u)) is_in = !is_in;
      }
    return is_in;
  }
};

Flat flat_of(const std::vector<std::vector<Direction3>>& loops) {
  Flat flat;
  Direction3 sum;
  const std::vector<Direction3>& outline = loops.front();
  for (std::size_t k = 0; k < outline.size(); ++k)
    sum = sum + cross(outline[k] - outline[0], outline[(k + 1) % outline.size()] - outline[0]);
  const double size = length(sum);
  if (!(size > 0) || !std::isfinite(size)) return flat;
  flat.normal = (1 / size) * sum;
  flat.offset = dot(flat.normal, outline[0]);
  const double x = std::fabs(sum.x), y = std::fabs(sum.y), z = std::fabs(sum.z);
  flat.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  flat.least = flat.most = flat.seen(outline[0]);
  for (const std::vector<Direction3>& loop : loops) {
    std::vector<FlatPoint>& seen = flat.loops.emplace_back();
    for (const Direction3& p : loop) {
      const FlatPoint& at = seen.emplace_back(flat.seen(p));
      flat.least = {std::min(flat.least.u, at.u), std::min(flat.least.v, at.v)};
      flat.most = {std::max(flat.most.u, at.u), std::max(flat.most.v, at.v)};
    }
  }
  return flat;
}

// The polygons in doubles, from 0 to 1 or so.
std::vector<Flat> flats_of(const Scene3& scene) {
  std::vector<std::vector<std::vector<Direction3>>> polygons;
  double most = std::numeric_limits<double>::min();
  const Point3 origin = scene.polygons.empty() ? Point3{} : scene.polygons.front().points.front();
  for (const Polygon3& polygon : scene.polygons) {
    auto& loops = polygons.emplace_back();
    for (const std::vector<Point3>& loop : loops_of(polygon)) {
      std::vector<Direction3>& points = loops.emplace_back();
      for (const Point3& point : loop) {
        const auto [x, y, z] = to_doubles(point - origin);
        points.push_back({x, y, z});
        most = std::max({most, std::fabs(x), std::fabs(y), std::fabs(z)});
      }
    }
  }
  std::vector<Flat> flats;
  for (auto& loops : polygons) {
    for (auto& loop : loops)
      for (Direction3& p : loop) p = {p.x / most, p.y / most, p.z / most};
    flats.push_back(flat_of(loops));
  }
  return flats;
}

class Looking {
 public:
  explicit Looking(const Scene3& scene) : flats_(flats_of(scene)) {}

  bool sees(const DrawnFace& a, const DrawnFace& b, SampleChance& chance) const {
    const auto first = drawn_point(a.face, chance), second = drawn_point(b.face, chance);
    if (!first || !second) return false;
    for (std::size_t k = 0; k < kLines; ++k) {
      const Direction3 p = point_near(*first, a.face, chance), q = point_near(*second, b.face, chance);
      if (is_before(q, a.face) && is_before(p, b.face) && is_free(p, q, a.face.surface, b.face.surface)) return true;
    }
    return false;
  }

 private:
  // A point of the polygon, as it is seen; nothing where none was found.
  std::optional<FlatPoint> drawn_point(const CountedFace& face, SampleChance& chance) const {
    const Flat& flat = flats_[face.surface];
    for (std::size_t k = 0; k < kMostDrawn && !flat.loops.empty(); ++k) {
      const double u = chance.share(), v = chance.share();
      const FlatPoint p{flat.least.u + u * (flat.most.u - flat.least.u),
                        flat.least.v + v * (flat.most.v - flat.least.v)};
      if (flat.holds(p)) return p;
    }
    return std::nullopt;
  }
  // A point of the polygon that is as near as points of one element are.
  Direction3 point_near(const FlatPoint& place, const CountedFace& face, SampleChance& chance) const {
    const Flat& flat = flats_[face.surface];
    const double size = 1 / std::sqrt(static_cast<double>(face.elements));
    const double u = (chance.share() - 0.5) * size, v = (chance.share() - 0.5) * size;
    const FlatPoint p{place.u + u * (flat.most.u - flat.least.u), place.v + v * (flat.most.v - flat.least.v)};
    return flat.lifted(flat.holds(p) ? p : place);
  }
  bool is_before(const Direction3& p, const CountedFace& face) const {
    const double height = dot(flats_[face.surface].normal, p) - flats_[face.surface].offset;
    return face.is_back ? height < 0 : height > 0;
  }
  bool is_free(const Direction3& p, const Direction3& q, std::uint32_t first, std::uint32_t second) const {
    for (std::uint32_t s = 0; s < flats_.size(); ++s) {
      const Flat& flat = flats_[s];
      const double from = dot(flat.normal, p) - flat.offset, to = dot(flat.normal, q) - flat.offset;
      if (!(from * to < 0) || s == first || s == second) continue;
      if (flat.holds(flat.seen(p + (from / (from - to)) * (q - p)))) return false;
    }
    return true;
  }

  const std::vector<Flat> flats_;
};

}  // namespace

std::vector<CountedFace> counted_faces_3(const Scene3& scene, Granularity granularity) {
  return counted_faces(scene, granularity, [&scene](std::uint32_t s) {
    return element_count(scene.polygons[s], scene.surfaces[s].elements);
  });
}

SampledPairs estimated_pairs_3(const Scene3& scene, std::span<const CountedFace> faces) {
  const Looking looking(scene);
  const double fits = kMostLookedAt / static_cast<double>(kLines * (scene.polygons.size() + 1));
  const auto samples = static_cast<std::size_t>(std::clamp<double>(fits, kLeastPairs, kMostPairs));
  return sampled_pairs(faces, samples, [&](const DrawnFace& a, const DrawnFace& b, SampleChance& chance) {
    return looking.sees(a, b, chance);
  });
}

}  // namespace hottel
