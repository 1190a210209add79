#include "geometry/space/stretches/solid_cover.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/stretches/stretch_parts.h"

namespace hottel {
namespace {

// Deeper in a solid than this part of the largest coordinate is deep: places on lines to corners are told within 2^-46
// of it, heights over planes within 2^-45.
constexpr double kDeep = 0x1p-34;

}  // namespace

SolidCover3::SolidCover3(const PairGeometry3& bodies) : bodies_(bodies) {
  if (bodies.solids.empty()) return;
  double largest = 0;
  for (std::uint32_t point = 0; point < bodies.points.size(); ++point) {
    const Direction3& p = places_.emplace_back(bodies.place(point));
    if (!bodies.points[point].is_far()) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  deep_ = kDeep * largest;
  items_.resize(bodies.count() + bodies.solids.size());
  within_lids_.assign(bodies.solids.size() * items_.size(), 0);
}

const SolidCover3::Item& SolidCover3::item(std::uint32_t number) {
  Item& item = items_[number];
  if (!item.corners.empty()) return item;
  const auto plane_of = [&](const BoundedVector& n, double sign, const Direction3& at) {
    const Direction3 outward = sign * unit(Direction3{n.x, n.y, n.z});
    return OutwardPlane3{outward, dot(outward, at)};
  };
  if (number < bodies_.count()) {
    item.corners = bodies_.bodies[number].corners;
  } else {
    const PairGeometry3::Solid& solid = bodies_.solids[number - bodies_.count()];
    for (std::size_t k = 0; k < solid.faces.size(); ++k) {
      const PairGeometry3::Body& face = bodies_.bodies[solid.faces[k]];
      item.planes.push_back(plane_of(face.normal, solid.outward[k], places_[face.corners.front()]));
      item.corners.insert(item.corners.end(), face.corners.begin(), face.corners.end());
    }
    std::ranges::sort(item.corners);
    item.corners.erase(std::unique(item.corners.begin(), item.corners.end()), item.corners.end());
    if (const auto& lid = solid.exact->lid) {
      const IntegerVector &n = lid->outward, &at = bodies_.vertices().exact(lid->at);
      const BoundedVector place = rounded(at, bodies_.shift());
      item.lid.push_back(plane_of(rounded(n, std::max(0L, bits(n) - 53)), 1, {place.x, place.y, place.z}));
    }
  }
  for (const std::uint32_t corner : item.corners) item.middle = item.middle + places_[corner];
  item.middle = (1 / static_cast<double>(item.corners.size())) * item.middle;
  for (const std::uint32_t corner : item.corners)
    item.radius = std::max(item.radius, length(places_[corner] - item.middle));
  return item;
}

void SolidCover3::narrow(const Stretch3& stretch, double low, double high, std::vector<std::uint32_t>& list) {
  if (bodies_.solids.empty() || list.size() < 2) return;
  const std::array<Direction3, 2> ends = ends_in_doubles(stretch, low, high, bodies_.shift());
  const Direction3 middle = 0.5 * (ends[0] + ends[1]);
  looks_.clear();
  for (const std::uint32_t number : list) {
    const Item& one = item(number);
    const Direction3 to = one.middle - middle;
    const double square = dot(to, to);
    looks_.push_back({number, one.radius * one.radius / square, to});
  }
  std::ranges::sort(
      looks_, [](const Look& a, const Look& b) { return a.size != b.size ? a.size > b.size : a.number < b.number; });
  kept_.clear();
  for (const Look& look : looks_) {
    const bool is_covered = std::ranges::any_of(kept_, [&](const Look& other) {
      if (other.number < bodies_.count()) return false;
      // The middle of what is covered is within the ball around what covers it.
      const double along = dot(look.way, other.way), squares = dot(look.way, look.way) * dot(other.way, other.way);
      if (other.size < 1 && (along < 0 || along * along < (1 - other.size) * squares)) return false;
      return covers(other.number, look.number, ends);
    });
    if (!is_covered) kept_.push_back(look);
  }
  list.clear();
  for (const Look& look : kept_) list.push_back(look.number);
}

bool SolidCover3::covers(std::uint32_t number, std::uint32_t other, const std::array<Direction3, 2>& ends) {
  const Item &solid = item(number), &covered = item(other);
  // From within, its faces hide one by one, and not all of them may be there.
  const bool is_outside = std::ranges::any_of(solid.planes, [&](const OutwardPlane3& plane) {
    return plane.height(ends[0]) > deep_ && plane.height(ends[1]) > deep_;
  });
  if (!is_outside) return false;
  const bool has_lid = !solid.lid.empty();
  bool needs_lid = false;
  for (const std::uint32_t corner : covered.corners) {
    const Direction3& c = places_[corner];
    // Where the line from an end (0) through the corner (1) is in the solid.
    bool is_before = true, is_beyond = true;
    for (const Direction3& end : ends) {
      double enters = 0, leaves = HUGE_VAL;
      bool meets = true;
      double enters_within_lid = 0, leaves_within_lid = HUGE_VAL;
      const auto clip = [&](const OutwardPlane3& plane, double& low, double& high) {
        const double at_end = plane.height(end) + deep_, slope = plane.height(c) + deep_ - at_end;
        if (slope > 0)
          high = std::min(high, -at_end / slope);
        else if (slope < 0)
          low = std::max(low, -at_end / slope);
        else
          meets = meets && at_end < 0;
      };
      for (const OutwardPlane3& plane : solid.planes) {
        clip(plane, enters, leaves);
        if (!meets || !(enters < leaves)) return false;
      }
      enters_within_lid = enters;
      leaves_within_lid = leaves;
      is_before = is_before && enters < std::min(leaves, 1.0);
      if (!is_beyond) continue;
      for (const OutwardPlane3& lid : solid.lid) clip(lid, enters_within_lid, leaves_within_lid);
      is_beyond = meets && std::max(enters_within_lid, 1.0) < leaves_within_lid;
    }
    if (!is_before && !is_beyond) return false;
    needs_lid |= has_lid && !is_beyond;
  }
  return !needs_lid || is_within_lid(number - bodies_.count(), other);
}

// What stands between the stretch and corners within the lid is within it too. Exact.
bool SolidCover3::is_within_lid(std::uint32_t solid, std::uint32_t other) {
  signed char& known = within_lids_[solid * items_.size() + other];
  if (known != 0) return known == 2;
  const BodyPlane3& lid = *bodies_.solids[solid].exact->lid;
  const IntegerVector& at = bodies_.vertices().exact(lid.at);
  const bool is_within = std::ranges::all_of(item(other).corners, [&](std::uint32_t corner) {
    const PairGeometry3::Point& p = bodies_.points[corner];
    return dot_sign(lid.outward, difference(p.exact(), multiple(p.weight(), at))) <= 0;
  });
  known = is_within ? 2 : 1;
  return is_within;
}

}  // namespace hottel
