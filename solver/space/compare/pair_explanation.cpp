#include "solver/space/compare/pair_explanation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/space/exchange/facing.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

const ElementPatch3* largest(std::span<const ElementPatch3> patches) {
  const auto found = std::max_element(patches.begin(), patches.end(),
                                      [](const ElementPatch3& a, const ElementPatch3& b) { return a.area < b.area; });
  return found == patches.end() ? nullptr : &*found;
}

bool touch(const ElementPatch3& a, const ElementPatch3& b) {
  const auto is_in_b = [&b](const Vector3d& p) {
    return std::ranges::any_of(b.corners, [&p](const Vector3d& q) { return p.x == q.x && p.y == q.y && p.z == q.z; });
  };
  return std::ranges::any_of(a.corners, is_in_b);
}

}  // namespace

PairExplainer3::PairExplainer3(const PreparedScene3& prepared, const ExchangeMatrix& exact)
    : prepared_(prepared), exact_(exact), geometry_(prepared) {
  const Vertices3& vertices = prepared.occluders().vertices();
  unit_ = to_double(scaled_by_power_of_two(vertices.scale(), vertices.shift()));
}

std::optional<double> PairExplainer3::visibility(std::uint32_t from, std::uint32_t to) const {
  for (const FactorEntry& entry : exact_.row(from))
    if (entry.to == to) return entry.visibility;
  if (to == exact_.sky()) return 0;
  for (const ElementTable3::Part& a : geometry_.table().parts(from))
    for (const ElementTable3::Part& b : geometry_.table().parts(to))
      if (face_each_other(prepared_.occluders(), a, b)) return 0;
  return std::nullopt;
}

PairExplanation PairExplainer3::explain(const PairError& pair) const {
  PairExplanation result;
  result.visibility = visibility(pair.from, pair.to);
  result.reason = sight_in_words(result.visibility);
  const ElementPatch3* const a = largest(geometry_.patches(pair.from));
  if (pair.to == exact_.sky()) {
    result.reason += " toward the sky";
  } else if (const ElementPatch3* const b = largest(geometry_.patches(pair.to)); a != nullptr && b != nullptr) {
    const double distance = length(b->centre - a->centre);
    result.distance = unit_ * distance;
    result.angle =
        same_bits::atan2(length(cross(a->normal, b->normal)), dot(a->normal, b->normal)) * 180 / std::numbers::pi;
    result.reason += touch(*a, *b)                                      ? ", touching"
                     : distance < std::sqrt(std::max(a->area, b->area)) ? ", near"
                                                                        : ", far";
  }
  result.reason += mistake_in_words(pair);
  return result;
}

}  // namespace hottel
