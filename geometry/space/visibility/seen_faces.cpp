#include "geometry/space/visibility/seen_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/space/scene/polygon.h"
#include "geometry/space/visibility/convex_cut.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

class SolidsTakenOut {
 public:
  SolidsTakenOut(VisibilityMap3 map, const Arrangement3& arrangement, const Point3& eye,
                 const std::vector<std::uint32_t>& meshes)
      : map_(std::move(map)), arrangement_(arrangement), eye_(eye), meshes_(meshes) {
    for (const std::uint32_t mesh : meshes) map_.solids.push_back({mesh, 0});
  }

  VisibilityMap3 result() {
    std::vector<VisibilityMap3::Fragment> fragments = std::move(map_.fragments);
    map_.fragments.clear();
    map_.shares.clear();
    for (const VisibilityMap3::Fragment& fragment : fragments) {
      const Piece3::Side& side = arrangement_.pieces()[fragment.face.surface].side(fragment.face.is_back);
      if (side.cover == Piece3::Cover::kFree)
        map_.fragments.push_back(fragment);
      else
        divide(fragment, side);
    }
    for (const VisibilityMap3::Fragment& fragment : map_.fragments) {
      if (map_.shares.empty() || map_.shares.back().face != fragment.face) map_.shares.push_back({fragment.face, 0, 0});
      map_.shares.back().fraction += fragment.fraction;
    }
    std::erase_if(map_.solids, [](const VisibilityMap3::InSolid& solid) { return solid.fraction == 0; });
    return with_owners(std::move(map_), arrangement_);
  }

 private:
  static Direction3 rounded(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }

  // A fragment on a side that looks into solids, where it is not free.
  void divide(const VisibilityMap3::Fragment& fragment, const Piece3::Side& side) {
    std::vector<Direction3> cone;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) cone.push_back(map_.corners[c].direction);
    double in_solids = fragment.fraction;
    Direction3 within = cone[0] + cone[1] + cone[2];
    for (const Polygon3& free : side.free) {
      std::vector<Direction3> ways;
      for (const Point3& corner : free.points) ways.push_back(unit(rounded(corner - eye_)));
      if (fragment.face.is_back) std::reverse(ways.begin(), ways.end());
      const std::vector<Direction3> part = common_cone_3(cone, ways);
      const double fraction = part.size() >= 3 ? solid_angle_fraction_3(part) : 0;
      if (!(fraction > kNothing)) continue;
      in_solids -= fraction;
      add(fragment, part, fraction);
    }
    if (!(in_solids > kNothing)) return;
    if (side.cover == Piece3::Cover::kPartly) within = way_into_solid(fragment, side);
    const std::uint32_t mesh = mesh_along(within, fragment);
    for (VisibilityMap3::InSolid& solid : map_.solids)
      if (solid.mesh == mesh) solid.fraction += in_solids;
    map_.solid_fragments.push_back(fragment);
  }

  void add(const VisibilityMap3::Fragment& of, const std::vector<Direction3>& cone, double fraction) {
    VisibilityMap3::Fragment part = of;
    part.fraction = fraction;
    part.begin = static_cast<std::uint32_t>(map_.corners.size());
    const Polygon3& polygon = arrangement_.pieces()[of.face.surface].polygon;
    const Direction3 normal = unit(rounded(doubled_area(polygon)));
    const double height = dot(normal, rounded(polygon.points.front() - eye_));
    const Direction3 eye{to_double(eye_.x), to_double(eye_.y), to_double(eye_.z)};
    for (const Direction3& direction : cone) {
      VisibilityMap3::Corner corner = map_.corners[of.begin];
      corner.direction = direction;
      const Direction3 met = eye + height / dot(normal, direction) * direction;
      corner.x = met.x;
      corner.y = met.y;
      corner.z = met.z;
      map_.corners.push_back(corner);
    }
    part.end = static_cast<std::uint32_t>(map_.corners.size());
    map_.fragments.push_back(part);
  }

  // A corner of the fragment that no free part holds, else its middle.
  Direction3 way_into_solid(const VisibilityMap3::Fragment& fragment, const Piece3::Side& side) const {
    Direction3 middle{};
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) middle = middle + map_.corners[c].direction;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const Direction3 way = 0.999 * map_.corners[c].direction + 1e-3 * unit(middle);
      const bool is_free = std::any_of(side.free.begin(), side.free.end(), [&](const Polygon3& free) {
        for (std::size_t k = 0; k < free.points.size(); ++k) {
          const Direction3 a = rounded(free.points[k] - eye_),
                           b = rounded(free.points[(k + 1) % free.points.size()] - eye_);
          const double inside = dot(way, fragment.face.is_back ? cross(a, b) : cross(b, a));
          if (inside < 0) return false;
        }
        return true;
      });
      if (!is_free) return way;
    }
    return middle;
  }

  // The solid that a way leads into: of several the one around the middle of the way to what is met.
  std::uint32_t mesh_along(const Direction3& way, const VisibilityMap3::Fragment& fragment) const {
    if (meshes_.size() == 1) return meshes_.front();
    const Polygon3& polygon = arrangement_.pieces()[fragment.face.surface].polygon;
    const Direction3 normal = unit(rounded(doubled_area(polygon)));
    const double half = dot(normal, rounded(polygon.points.front() - eye_)) / dot(normal, way) / 2;
    if (!std::isfinite(half)) return meshes_.front();
    const Direction3 step = half * way;
    const Point3 middle{eye_.x + exact_value(step.x), eye_.y + exact_value(step.y), eye_.z + exact_value(step.z)};
    const auto around = arrangement_.solids().around(middle);
    return around && std::find(meshes_.begin(), meshes_.end(), *around) != meshes_.end() ? *around : meshes_.front();
  }

  // What rounding makes of nothing.
  static constexpr double kNothing = 1e-15;

  VisibilityMap3 map_;
  const Arrangement3& arrangement_;
  const Point3& eye_;
  const std::vector<std::uint32_t>& meshes_;
};

}  // namespace

VisibilityMap3 with_owners(VisibilityMap3 map, const Arrangement3& arrangement) {
  const auto rename = [&arrangement](Face& face) { face = arrangement.owner(face.surface, face.is_back); };
  for (VisibilityMap3::Fragment& fragment : map.fragments) rename(fragment.face);
  for (VisibilityMap3::Share& share : map.shares) rename(share.face);
  std::stable_sort(map.fragments.begin(), map.fragments.end(),
                   [](const auto& a, const auto& b) { return a.face < b.face; });
  std::stable_sort(map.shares.begin(), map.shares.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
  std::vector<VisibilityMap3::Share> shares;
  for (const VisibilityMap3::Share& share : map.shares) {
    if (shares.empty() || shares.back().face != share.face) {
      shares.push_back(share);
      continue;
    }
    shares.back().fraction += share.fraction;
    shares.back().factor += share.factor;
  }
  map.shares = std::move(shares);
  return map;
}

std::vector<std::uint32_t> solids_at(const Solids3& solids, const Point3& point) {
  std::vector<std::uint32_t> result;
  ClosedMesh3::Box here;
  here.include(point);
  for (std::uint32_t m = 0; m < solids.meshes().size(); ++m) {
    const ClosedMesh3& mesh = solids.meshes()[m];
    if (mesh.kind != ClosedMesh3::Kind::kSolid || !mesh.box.meets(here)) continue;
    const bool is_on_it = std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const ClosedMesh3::Face& face) {
      return face.box.meets(here) && face.frame.height(point) == 0 &&
             std::any_of(face.pieces.begin(), face.pieces.end(),
                         [&](const std::vector<Point3>& corners) { return contains(Polygon3{corners}, point); });
    });
    if (is_on_it) result.push_back(m);
  }
  return result;
}

VisibilityMap3 outside_solids(VisibilityMap3 map, const Arrangement3& arrangement, const Point3& eye,
                              const std::vector<std::uint32_t>& meshes) {
  return SolidsTakenOut(std::move(map), arrangement, eye, meshes).result();
}

VisibilityMap3 faces_seen_from(const Point3& eye, const Occluders3& occluders, const Arrangement3& arrangement) {
  return faces_seen_from(eye, map_from(occluders, {.eye = eye, .normal = {}}), arrangement);
}

VisibilityMap3 faces_seen_from(const Point3& eye, VisibilityMap3 map, const Arrangement3& arrangement) {
  const std::vector<std::uint32_t> on_border = solids_at(arrangement.solids(), eye);
  return on_border.empty() ? with_owners(std::move(map), arrangement)
                           : outside_solids(std::move(map), arrangement, eye, on_border);
}

}  // namespace hottel
