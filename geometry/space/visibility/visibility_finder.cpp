#include "geometry/space/visibility/visibility_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/view_cones.h"

namespace hottel {
namespace {

// Fewer cells would have too many fragments, more would take longer to fill.
constexpr double kMostCells = 24;

// The direction to a place of a face of the cube: faces are +x, -x, +y, -y, +z, -z; u and v from -1 to 1.
Direction3 of_cube(std::size_t face, double u, double v) {
  const double w = face % 2 == 0 ? 1 : -1;
  switch (face / 2) {
    case 0:
      return {w, u, v};
    case 1:
      return {v, w, u};
    default:
      return {u, v, w};
  }
}

ViewCone3 around(std::span<const Direction3> corners) {
  Direction3 axis;
  for (const Direction3& corner : corners) axis = axis + corner;
  ViewCone3 result;
  const double size = length(axis);
  if (!(size > 1e-3)) return result;  // wide
  axis = 1 / size * axis;
  double cosine = 1;
  for (const Direction3& corner : corners) cosine = std::min(cosine, dot(axis, corner));
  result.x = axis.x;
  result.y = axis.y;
  result.z = axis.z;
  result.cosine = cosine;
  result.sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return result;
}

// Two half planes that begin at the line of a direction: what is around it, of a cone, is counter-clockwise from one
// to the other. Each by a vector orthogonal to the direction.
struct Sector {
  IntegerVector from, to;
};

bool is_same_way(const IntegerVector& a, const IntegerVector& b) { return is_zero(cross(a, b)) && dot_sign(a, b) > 0; }

// Sectors without a common inner direction are all around iff each ends where one begins.
bool are_all_around(const std::vector<Sector>& sectors) {
  return !sectors.empty() && std::all_of(sectors.begin(), sectors.end(), [&](const Sector& one) {
    return std::any_of(sectors.begin(), sectors.end(),
                       [&](const Sector& other) { return is_same_way(one.to, other.from); });
  });
}

}  // namespace

VisibilityFinder3::VisibilityFinder3(const ExactVisibilityMap3& map) : map_(map) {
  const VisibilityMap3& drawn = map.map();
  cells_ =
      static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(drawn.fragments.size())), 1.0, kMostCells));
  std::vector<ViewCone3> fragments;
  std::vector<Direction3> corners;
  for (const VisibilityMap3::Fragment& fragment : drawn.fragments) {
    corners.clear();
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) corners.push_back(drawn.corners[c].direction);
    fragments.push_back(around(corners));
  }
  const double step = 2 / static_cast<double>(cells_);
  for (std::size_t face = 0; face < 6; ++face)
    for (std::size_t row = 0; row < cells_; ++row)
      for (std::size_t column = 0; column < cells_; ++column) {
        const double u = -1 + step * static_cast<double>(column), v = -1 + step * static_cast<double>(row);
        const std::array<Direction3, 4> cell{unit(of_cube(face, u, v)), unit(of_cube(face, u + step, v)),
                                             unit(of_cube(face, u + step, v + step)), unit(of_cube(face, u, v + step))};
        const ViewCone3 cone = around(cell);
        first_.push_back(static_cast<std::uint32_t>(fragments_.size()));
        for (std::uint32_t f = 0; f < fragments.size(); ++f)
          if (may_overlap(fragments[f], cone)) fragments_.push_back(f);
      }
  first_.push_back(static_cast<std::uint32_t>(fragments_.size()));
}

std::span<const std::uint32_t> VisibilityFinder3::near(const IntegerVector& direction) const {
  const BoundedVector w = rounded(direction, bits(direction) - 53);
  const double x = std::fabs(w.x), y = std::fabs(w.y), z = std::fabs(w.z);
  const std::size_t axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const double along = axis == 0 ? w.x : axis == 1 ? w.y : w.z;
  const double u = (axis == 0   ? w.y
                    : axis == 1 ? w.z
                                : w.x) /
                   std::fabs(along),
               v = (axis == 0   ? w.z
                    : axis == 1 ? w.x
                                : w.y) /
                   std::fabs(along);
  const auto cell = [this](double place) {
    return std::min(cells_ - 1, static_cast<std::size_t>(std::max(0.0, (place + 1) / 2 * static_cast<double>(cells_))));
  };
  const std::size_t number = ((2 * axis + (along < 0 ? 1 : 0)) * cells_ + cell(v)) * cells_ + cell(u);
  return {fragments_.data() + first_[number], fragments_.data() + first_[number + 1]};
}

bool VisibilityFinder3::sees(const Point3& point) const {
  const IntegerVector direction = map_.toward(point);
  if (is_zero(direction)) return true;
  std::vector<Sector> hiding;
  for (const std::uint32_t f : near(direction)) {
    const ExactCone3& cone = map_.cone(f);
    const ExactCone3::Located located = cone.locate(direction);
    if (located.place == ExactCone3::Place::kOutside) continue;
    const bool is_hidden = map_.nearness(point, map_.map().fragments[f].face.surface) < 0;
    if (located.place == ExactCone3::Place::kInside) return !is_hidden;
    if (!is_hidden) return true;
    const std::size_t before = located.place == ExactCone3::Place::kOnEdge
                                   ? located.side
                                   : (located.side + cone.inward.size() - 1) % cone.inward.size();
    hiding.push_back({cross(cone.inward[located.side], direction), opposite(cross(cone.inward[before], direction))});
  }
  return !are_all_around(hiding);
}

}  // namespace hottel
