#include "solver/space/light/seen_elements.h"

#include <algorithm>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/convex_cut.h"
#include "geometry/space/visibility/seen_faces.h"

namespace hottel {

namespace {

constexpr double kNothing = 1e-15;  // what rounding makes of it

std::vector<Direction3> cone_of(const VisibilityMap3& map, const VisibilityMap3::Fragment& fragment) {
  std::vector<Direction3> cone;
  for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) cone.push_back(map.corners[c].direction);
  return cone;
}

// What of a cone meets a polygon that is convex, as seen from a point; fewer than three directions: nothing.
std::vector<Direction3> part_toward(const std::vector<Direction3>& cone, const std::vector<Direction3>& polygon,
                                    const Direction3& eye) {
  std::vector<Direction3> ways;
  for (const Direction3& corner : polygon) ways.push_back(unit(corner - eye));
  return common_cone_3(cone, ways);
}

}  // namespace

SeenElements3::SeenElements3(const PreparedScene3& prepared, const ElementTable3& table, Blacks3 blacks)
    : prepared_(prepared), blacks_(blacks), parts_(2 * prepared.occluders().size()) {
  add_parts(table, blacks);
  add_covers();
}

void SeenElements3::add_parts(const ElementTable3& table, Blacks3 blacks) {
  for (const ElementTable3::Part& part : table.parts()) {
    if (part.patch.is_sky() || (blacks == Blacks3::kLeftOut && !table.has_row(part.label))) continue;
    Side& side = parts_[Face{part.patch.surface, part.is_back}.number()];
    side.is_divided = side.is_divided || (!side.parts.empty() && side.parts[0].label != part.label);
    side.parts.push_back({part.label, {}});
    for (const Point3& corner : corners_of(prepared_.occluders().vertices(), part.patch))
      side.parts.back().corners.push_back({to_double(corner.x), to_double(corner.y), to_double(corner.z)});
  }
}

void SeenElements3::add_covers() {
  const auto& pieces = prepared_.arrangement().pieces();
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece)
    for (const bool is_back : {false, true}) {
      const Piece3::Side& side = pieces[piece].side(is_back);
      Side& own = parts_[Face{piece, is_back}.number()];
      own.is_covered = side.cover != Piece3::Cover::kFree;
      for (const Polygon3& free : side.free) {
        std::vector<Direction3>& corners = own.free.emplace_back();
        for (const Point3& corner : free.points)
          corners.push_back({to_double(corner.x), to_double(corner.y), to_double(corner.z)});
        if (is_back) std::ranges::reverse(corners);
      }
    }
}

std::optional<double> SeenElements3::around(const Point3& eye, const Take& take) const {
  const VisibilityMap3 map = map_from(prepared_.occluders(), {.eye = eye, .normal = {}});
  const auto is_black = [this](const VisibilityMap3::Fragment& fragment) {
    return parts_[fragment.face.number()].parts.empty();
  };
  if (blacks_ == Blacks3::kLeftOut && prepared_.scene.closed && std::ranges::all_of(map.fragments, is_black))
    return std::nullopt;
  if (map.sky_fraction < kNothing && is_in_solids(map, eye)) return std::nullopt;
  tell(
      map, eye, [](const VisibilityMap3::Fragment& fragment) { return fragment.fraction; },
      [](std::span<const Direction3> cone) { return solid_angle_fraction_3(cone); }, take);
  return map.sky_fraction;
}

double SeenElements3::toward(const Point3& eye, const Vector3& normal, const Take& take) const {
  const VisibilityMap3 map =
      map_from(prepared_.occluders(), {.eye = eye, .normal = Point3{normal.x, normal.y, normal.z}});
  const Direction3 up = unit_of_3(normal);
  tell(
      map, eye, [](const VisibilityMap3::Fragment& fragment) { return fragment.factor; },
      [&up](std::span<const Direction3> cone) { return view_factor_3(cone, up); }, take);
  return map.sky_factor;
}

template <class FractionOf, class Measure>
void SeenElements3::tell(const VisibilityMap3& map, const Point3& eye, const FractionOf& fraction_of,
                         const Measure& measure, const Take& take) const {
  const auto side_of = [this](const VisibilityMap3::Fragment& fragment) -> const Side& {
    return parts_[fragment.face.number()];
  };
  const auto may_be_covered = [&](const VisibilityMap3::Fragment& fragment) { return side_of(fragment).is_covered; };
  const bool is_on_solid =
      std::ranges::any_of(map.fragments, may_be_covered) && !solids_at(prepared_.arrangement().solids(), eye).empty();
  const Direction3 from{to_double(eye.x), to_double(eye.y), to_double(eye.z)};
  for (const VisibilityMap3::Fragment& fragment : map.fragments) {
    const Side& side = side_of(fragment);
    if (side.parts.empty()) continue;
    if (is_on_solid && side.is_covered) {
      tell_free(cone_of(map, fragment), side, from, measure, take);
      continue;
    }
    if (!side.is_divided) {
      take(side.parts[0].label, fraction_of(fragment));
      continue;
    }
    tell_divided(cone_of(map, fragment), fraction_of(fragment), side, from, measure, take);
  }
}

// What is seen through a solid that begins at the eye is not there.
template <class Measure>
void SeenElements3::tell_free(const std::vector<Direction3>& cone, const Side& side, const Direction3& eye,
                              const Measure& measure, const Take& take) const {
  for (const std::vector<Direction3>& free : side.free) {
    const std::vector<Direction3> seen = part_toward(cone, free, eye);
    const double fraction = seen.size() > 2 ? measure(seen) : 0;
    if (!(fraction > kNothing)) continue;
    if (side.is_divided)
      tell_divided(seen, fraction, side, eye, measure, take);
    else
      take(side.parts[0].label, fraction);
  }
}

// Whether all that a point would see looks into solids: so it is within a wall between several.
bool SeenElements3::is_in_solids(const VisibilityMap3& map, const Point3& eye) const {
  const Direction3 from{to_double(eye.x), to_double(eye.y), to_double(eye.z)};
  return !map.fragments.empty() && std::ranges::all_of(map.fragments, [&](const VisibilityMap3::Fragment& fragment) {
    const Side& side = parts_[fragment.face.number()];
    return side.is_covered && std::ranges::none_of(side.free, [&](const std::vector<Direction3>& free) {
             const std::vector<Direction3> seen = part_toward(cone_of(map, fragment), free, from);
             return seen.size() > 2 && solid_angle_fraction_3(seen) > kNothing;
           });
  });
}

// The cone by the elements in it, in the proportion of their angles.
template <class Measure>
void SeenElements3::tell_divided(const std::vector<Direction3>& cone, double fraction, const Side& side,
                                 const Direction3& eye, const Measure& measure, const Take& take) const {
  std::vector<double> fractions;
  double sum = 0;
  for (const Part& part : side.parts) {
    const std::vector<Direction3> common = part_toward(cone, part.corners, eye);
    fractions.push_back(common.size() > 2 ? std::max(0.0, measure(common)) : 0);
    sum += fractions.back();
  }
  if (!(sum > 0)) return take(side.parts[0].label, fraction);
  for (std::size_t k = 0; k < side.parts.size(); ++k)
    if (fractions[k] > 0) take(side.parts[k].label, fraction * (fractions[k] / sum));
}

}  // namespace hottel
