#include "solver/space/methods/quadrature_claims.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "geometry/space/exchange/exchange.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
// Places are off by some units in the last place of the largest distance; this covers far more.
constexpr double kSlack = 1e-12;
constexpr double kRoundings = 1e-13;  // of a factor that is summed or taken from 1

double distance_to_edge(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from, d = point - from;
  const double at = std::clamp(dot(along, d) / square(along), 0.0, 1.0);
  return length(d - at * along);
}

double distance_to(const Vector3d& point, const ElementPatch3& patch) {
  double least = kNothing;
  bool is_over = true;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const Vector3d &a = patch.corners[k], &b = patch.corners[k + 1 == patch.corners.size() ? 0 : k + 1];
    least = std::min(least, distance_to_edge(point, a, b));
    is_over = is_over && dot(cross(b - a, point - a), patch.normal) >= 0;
  }
  return is_over ? std::fabs(dot(patch.normal, point - patch.centre)) : least;
}

// Two patches as seen from the first.
struct Facing {
  double radius = 0;                        // of a, around its centre
  double distance = 0;                      // of b from there
  double largest = 0;                       // between corners
  double low = kNothing, high = -kNothing;  // the heights of b above a

  Facing(const ElementPatch3& a, const ElementPatch3& b) : distance(distance_to(a.centre, b)) {
    for (const Vector3d& corner : a.corners) {
      radius = std::max(radius, length(corner - a.centre));
      for (const Vector3d& other : b.corners) largest = std::max(largest, length(other - corner));
    }
    for (const Vector3d& corner : b.corners) {
      low = std::min(low, dot(a.normal, corner - a.centre));
      high = std::max(high, dot(a.normal, corner - a.centre));
    }
  }
  bool is_before() const { return low >= -kSlack * largest; }
  bool is_behind() const { return high <= kSlack * largest; }
};

// Whether the kernel is 0 between all their points, but for roundings.
bool exchange_nothing(const ElementPatch3& a, const ElementPatch3& b) {
  return a.piece == b.piece || Facing(a, b).is_behind() || Facing(b, a).is_behind();
}

// The error of F(from, to) where these see each other wholly.
double error_of_whole_pair(const ElementGeometry3& geometry, const PatchRule3& rule, std::uint32_t from,
                           std::uint32_t to) {
  double error = kRoundings;
  for (const ElementPatch3& a : geometry.patches(from))
    for (const ElementPatch3& b : geometry.patches(to)) {
      if (exchange_nothing(a, b)) continue;
      double mean = rule_error_3(a, b, rule.degree);
      if (rule.over == RuleOver3::kBoth) mean += rule_error_3(b, a, rule.degree);
      error += a.area * b.area / geometry.area(from) * mean;
    }
  return error;
}

bool touch_as_masks(const ElementGeometry3& geometry, std::uint32_t from, std::uint32_t to) {
  const auto contacts = geometry.contacts(from);
  return std::any_of(contacts.begin(), contacts.end(), [to](const auto& contact) { return contact.to == to; });
}

}  // namespace

double rule_error_3(const ElementPatch3& a, const ElementPatch3& b, int degree) {
  const Facing facing(a, b);
  if (!facing.is_before() || !Facing(b, a).is_before()) return kNothing;
  const double slack = kSlack * facing.largest;
  const double radius = facing.radius + slack, distance = facing.distance - slack, height = facing.high + slack;
  if (!(distance > radius)) return kNothing;
  constexpr int kTries = 64;
  double best = kNothing;
  for (int k = 1; k < kTries; ++k) {
    const double s = 1 + (distance / radius - 1) * k / kTries, reach = s * radius;
    const double largest = height * (distance + reach) / (std::numbers::pi * same_bits::pow(distance - reach, 4));
    best = std::min(best, largest * same_bits::pow(s, -(degree + 1)) / (1 - 1 / s));
  }
  // Heights that are not quite above 0 are taken for 0, and the kernel is rounded.
  const double nearest = distance - radius;
  return 2 * best + kSlack * facing.largest * facing.largest / same_bits::pow(nearest, 4);
}

ExchangeMethod3::ClaimedErrors quadrature_claims_3(const PreparedScene3& prepared, const PatchRule3& rule) {
  struct Known {
    ElementGeometry3 geometry;
    ExchangeMatrix exact;
    explicit Known(const PreparedScene3& scene)
        : geometry(scene), exact(exact_exchange(scene, {.granularity = Granularity::kElement})) {}
  };
  const auto known = std::make_shared<const Known>(prepared);
  const auto of_pair = [known, rule](std::uint32_t from, std::uint32_t to) {
    if (touch_as_masks(known->geometry, from, to)) return kRoundings;
    const auto entry = known->exact.row(from).find(to);
    if (!entry) return 0.0;
    return entry->visibility < 1 ? kNothing : error_of_whole_pair(known->geometry, rule, from, to);
  };
  return [known, of_pair](std::uint32_t from, std::uint32_t to) {
    if (to != known->geometry.table().sky()) return of_pair(from, to);
    double error = kRoundings;
    for (std::uint32_t other = 0; other < known->geometry.count(); ++other) error += of_pair(from, other);
    return error;
  };
}

std::optional<double> quadrature_claim_3(const PreparedScene3& prepared, const PatchRule3& rule) {
  const ElementGeometry3 geometry(prepared);
  // Most scenes have walls that meet, of which nothing can be claimed: then no exact factors are needed.
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    for (std::uint32_t j = 0; j < geometry.count(); ++j)
      if (geometry.has_row(i) && !touch_as_masks(geometry, i, j) &&
          !std::isfinite(error_of_whole_pair(geometry, rule, i, j)))
        return std::nullopt;
  const ExchangeMethod3::ClaimedErrors claimed = quadrature_claims_3(prepared, rule);
  double largest = 0;
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    for (std::uint32_t j = 0; j <= geometry.table().sky(); ++j)
      if (geometry.has_row(i)) largest = std::max(largest, claimed(i, j));
  return std::isfinite(largest) ? std::optional(largest) : std::nullopt;
}

}  // namespace hottel
