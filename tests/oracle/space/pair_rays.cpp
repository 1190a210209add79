#include "tests/oracle/space/pair_rays.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <random>

namespace hottel::oracle {
namespace {

constexpr int kBatches = 32;
constexpr std::uint64_t kFew = 1000;  // rays that arrive: the spread of batches with a few each says little
constexpr double kLeast = 4;

// What a ray is held against.
struct Target {
  Vector normal;
  double offset;
  std::vector<Vector> inward;  // of each side, in the plane
  std::vector<double> least;   // inside: inward . p > least

  explicit Target(const FlatPolygon& polygon) {
    const FlatPlane plane(polygon);
    normal = plane.normal;
    offset = plane.offset;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      inward.push_back(cross(normal, polygon[(k + 1) % polygon.size()] - polygon[k]));
      least.push_back(dot(inward.back(), polygon[k]));
    }
  }

  // How far along the ray it is met, in lengths of d; a negative number where it is not.
  double distance(const Vector& x, const Vector& d) const {
    const double slope = dot(normal, d);
    if (slope == 0) return -1;
    const double t = (offset - dot(normal, x)) / slope;
    if (!(t > 0)) return -1;
    const Vector p = x + t * d;
    for (std::size_t k = 0; k < inward.size(); ++k)
      if (dot(inward[k], p) <= least[k]) return -1;
    return t;
  }
};

// Points of a polygon: numbers in [0, 1) to points, areas to areas.
class Points {
 public:
  explicit Points(const FlatPolygon& polygon) : polygon_(polygon) {
    for (std::size_t k = 2; k < polygon.size(); ++k)
      sums_.push_back((sums_.empty() ? 0 : sums_.back()) + area({polygon[0], polygon[k - 1], polygon[k]}));
  }

  Vector operator()(double u, double v) const {
    double a = u * sums_.back();
    std::size_t k = 0;
    while (k + 1 < sums_.size() && a >= sums_[k]) ++k;
    const double before = k == 0 ? 0 : sums_[k - 1];
    a = std::sqrt((a - before) / (sums_[k] - before));
    const Vector &p = polygon_[0], &q = polygon_[k + 1], &r = polygon_[k + 2];
    return (1 - a) * p + (a * (1 - v)) * q + (a * v) * r;
  }

 private:
  const FlatPolygon& polygon_;
  std::vector<double> sums_;  // of the areas of the triangles at the first corner
};

class Rays {
 public:
  explicit Rays(const FlatPair& pair) : points_(pair.i), target_(pair.j), up_(FlatPlane(pair.i).normal) {
    for (const FlatPolygon& polygon : pair.between) between_.emplace_back(polygon);
    const Vector least = std::fabs(up_.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    east_ = cross(up_, least);
    east_ = (1 / length(east_)) * east_;
    north_ = cross(up_, east_);
  }

  bool arrives(const std::array<double, 4>& chance) const {
    const Vector x = points_(chance[0], chance[1]);
    const double r = std::sqrt(chance[2]), angle = 2 * std::numbers::pi * chance[3];
    const Vector d = (r * std::cos(angle)) * east_ + (r * std::sin(angle)) * north_ + std::sqrt(1 - chance[2]) * up_;
    if (dot(target_.normal, d) >= 0) return false;
    const double t = target_.distance(x, d);
    if (t < 0) return false;
    return std::none_of(between_.begin(), between_.end(), [&](const Target& other) {
      const double met = other.distance(x, d);
      return met > 0 && met < t;
    });
  }

 private:
  Points points_;
  Target target_;
  std::vector<Target> between_;
  Vector up_, east_, north_;
};

// The powers of 1/g for the g with g^5 = g + 1: their multiples fill the cube evenly.
constexpr std::array<double, 4> kSteps{0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101};

}  // namespace

RayEstimate exchange_by_rays(const FlatPair& pair, std::uint64_t seed, std::uint64_t rays) {
  const Rays caster(pair);
  std::mt19937_64 engine(seed);
  const auto each = static_cast<int>(rays / kBatches);
  double sum = 0, squares = 0;
  RayEstimate result;
  for (int batch = 0; batch < kBatches; ++batch) {
    std::array<double, 4> at{};
    for (double& x : at) x = static_cast<double>(engine() >> 11) * 0x1p-53;
    int seen = 0;
    for (int n = 0; n < each; ++n) {
      for (std::size_t k = 0; k < at.size(); ++k) at[k] = at[k] + kSteps[k] - std::floor(at[k] + kSteps[k]);
      seen += caster.arrives(at) ? 1 : 0;
    }
    const double share = static_cast<double>(seen) / each;
    sum += share;
    squares += share * share;
    result.seen += static_cast<std::uint64_t>(seen);
  }
  const double mean = sum / kBatches, spread = std::max(0.0, squares / kBatches - mean * mean) / (kBatches - 1);
  const double whole = area(pair.i), count = static_cast<double>(result.seen);
  result.measure = whole * mean;
  const double least =
      (result.seen < kFew ? std::sqrt(std::max(count, kLeast)) : 1) / (static_cast<double>(each) * kBatches);
  result.standard_error = whole * std::max(std::sqrt(spread), least);
  return result;
}

}  // namespace hottel::oracle
