#include "solver/space/light/light_shares.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr long kPrecision = 192;

// How wide a ball around 0 is may depend on what a thread has computed before: nodes of rules are kept.
constexpr double kNextToNothing = 0x1p-90;

LightShare3 share_of(const Ball& ball) {
  const Enclosure ends = ball.nearest_of_ends(), bounds = ball.bounds();
  if (!(bounds.lower > 0)) return {0, {0, bounds.upper > 0 ? std::max(kNextToNothing, bounds.upper) : 0}};
  return {ends.lower + (ends.upper - ends.lower) / 2, {bounds.lower, std::min(1.0, bounds.upper)}};
}

// The patches on each side of a piece that light can fall on.
class SideParts {
 public:
  SideParts(const ElementTable3& table, std::size_t pieces) : sides_(2 * pieces) {
    for (const ElementTable3::Part& part : table.parts())
      if (!part.patch.is_sky()) sides_[Face{part.patch.surface, part.is_back}.number()].push_back(&part);
  }

  const std::vector<const ElementTable3::Part*>& operator[](const Face& side) const { return sides_[side.number()]; }

 private:
  std::vector<std::vector<const ElementTable3::Part*>> sides_;
};

using Shares = std::vector<std::pair<std::uint32_t, Ball>>;  // by label

// What of each fragment of a map goes to which element, by a measure of cones. Of sides that no element has: the sky.
template <class Measure>
std::vector<Shares> shares_of_fragments(const PreparedScene3& prepared, const ElementTable3& table,
                                        const ExactVisibilityMap3& map, const Measure& measure) {
  const SideParts sides(table, prepared.occluders().size());
  const std::vector<VisibilityMap3::Fragment>& fragments = map.map().fragments;
  std::vector<Shares> shares(fragments.size());
  parallel_for(
      fragments.size(),
      [&](std::size_t f) {
        const auto& parts = sides[fragments[f].face];
        const auto is_other = [&parts](const ElementTable3::Part* part) { return part->label != parts[0]->label; };
        if (std::none_of(parts.begin(), parts.end(), is_other)) {
          shares[f].emplace_back(parts.empty() ? table.sky() : parts[0]->label, measure(map.cone(f)));
          return;
        }
        for (const ElementTable3::Part* part : parts)
          if (const std::optional<ExactCone3> common = common_cone(map.cone(f), map.cone_of(part->patch)))
            shares[f].emplace_back(part->label, measure(*common));
      },
      1);
  return shares;
}

}  // namespace

LightShares3 light_shares(const PreparedScene3& prepared, const ElementTable3& table, const Point3& position,
                          const Beam3& beam) {
  return light_shares(prepared, table, ExactVisibilityMap3(prepared.occluders(), position), BeamPower3(beam));
}

LightShares3 light_shares(const PreparedScene3& prepared, const ElementTable3& table, const ExactVisibilityMap3& map,
                          const BeamPower3& beam) {
  LightShares3 result;
  result.elements.resize(table.count());
  if (prepared.arrangement().solids().around(map.eye())) {
    result.lost = {1, {1, 1}};
    result.is_in_solid = true;
    return result;
  }
  const std::vector<Shares> shares =
      shares_of_fragments(prepared, table, map, [&beam](const ExactCone3& cone) { return beam.share(cone); });
  std::vector<Ball> sums(std::size_t{table.count()} + 1);
  Ball rest = Ball::of(1, kPrecision);
  for (const Shares& of_fragment : shares)
    for (const auto& [label, share] : of_fragment) {
      sums[label] = sums[label].plus(share, kPrecision);
      rest = rest.minus(share, kPrecision);
    }
  for (std::uint32_t label = 0; label < table.count(); ++label) result.elements[label] = share_of(sums[label]);
  result.lost = share_of(sums[table.sky()]);
  result.sky = share_of(rest);
  return result;
}

std::vector<Enclosure> sunlit_areas(const PreparedScene3& prepared, const ElementTable3& table,
                                    const ExactVisibilityMap3& map) {
  const auto area = [sun = map.sun()](const ExactCone3& cone) {
    Ball sum;
    for (std::size_t k = 1; k + 1 < cone.corners.size(); ++k)
      sum = sum.plus(sun->area(cone.corners[0], cone.corners[k], cone.corners[k + 1], kPrecision), kPrecision);
    return sum;
  };
  std::vector<Ball> sums(std::size_t{table.count()} + 1);
  std::vector<char> is_lit(sums.size(), 0);
  for (const Shares& of_fragment : shares_of_fragments(prepared, table, map, area))
    for (const auto& [label, share] : of_fragment) {
      sums[label] = sums[label].plus(share, kPrecision);
      is_lit[label] = 1;
    }
  const Rational square_metres = square_metres_per_unit(prepared.scene);
  const Ball told = Ball::of(square_metres, kPrecision);
  std::vector<Enclosure> result(table.count(), Enclosure{0, 0});
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (is_lit[label] != 0)
      result[label] = (square_metres == 1 ? sums[label] : sums[label].times(told, kPrecision)).bounds();
  return result;
}

}  // namespace hottel
