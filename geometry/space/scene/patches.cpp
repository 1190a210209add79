#include "geometry/space/scene/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/plane_triangulation.h"

namespace hottel {
namespace {

// A plane polygon that patches may lie on: a surface, or a facet of one.
struct BaseFacet {
  PlaneFrame3 frame;
  FlatRegion3 region;
  Polygon3 polygon;

  explicit BaseFacet(Polygon3 p) : frame(p.points), region(frame.region(p.points, p.holes)), polygon(std::move(p)) {}
};

// The parts of a facet of which a region has nothing.
void append_beside(const BaseFacet& facet, const std::vector<FlatRegion3>& taken, std::vector<Polygon3>& pieces) {
  std::vector<FlatSegment3> segments;
  facet.region.append_sides(segments);
  for (const FlatRegion3& region : taken) region.append_sides(segments);
  const PlaneTriangulation3 triangulation(segments);
  std::vector<char> is_left(triangulation.triangles().size(), 0);
  for (std::uint32_t t = 0; t < is_left.size(); ++t) {
    const FlatPoint3 at = triangulation.centre(t);
    is_left[t] = facet.region.contains(at) &&
                 std::ranges::none_of(taken, [&](const FlatRegion3& region) { return region.contains(at); });
  }
  const bool is_up = facet.frame.is_front_up(facet.polygon.points);
  for (const auto& flat : convex_pieces(region_of(triangulation, is_left))) {
    Polygon3& piece = pieces.emplace_back();
    for (const FlatPoint3& p : flat) piece.points.push_back(facet.frame.point(p));
    if (!is_up) std::ranges::reverse(piece.points);
  }
}

}  // namespace

std::vector<Polygon3> beside_patches(const PatchCarriers3& carriers, const Face& face) {
  const Scene3& scene = carriers.scene();
  const std::vector<std::uint32_t> patches = carriers.on(face);
  if (patches.empty()) return {scene.polygons[face.surface]};
  std::vector<Polygon3> pieces;
  for (Polygon3& polygon : facets_of(scene.polygons[face.surface])) {
    const BaseFacet facet(std::move(polygon));
    std::vector<FlatRegion3> taken;
    for (const std::uint32_t s : patches) {
      for (const Polygon3& part : facets_of(scene.polygons[s]))
        if (PlaneFrame3(part.points).key() == facet.frame.key())
          taken.push_back(facet.frame.region(part.points, part.holes));
    }
    std::erase_if(taken, [&](const FlatRegion3& region) { return !region.may_meet(facet.region); });
    if (taken.empty())
      pieces.push_back(facet.polygon);
    else
      append_beside(facet, taken, pieces);
  }
  return pieces;
}

PatchCarriers3::Box::Box(const std::vector<Point3>& points) {
  constexpr double kPart = 2e-4;  // twice what the tolerance lets pass
  constexpr double kAll = std::numeric_limits<double>::infinity();
  low.fill(kAll);
  high.fill(-kAll);
  for (const Point3& point : points) {
    const std::array<double, 3> at = to_doubles(point);
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], at[a]);
      high[a] = std::max(high[a], at[a]);
    }
  }
  const double more = kPart * (high[0] - low[0] + high[1] - low[1] + high[2] - low[2]);
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::isfinite(more) ? std::nextafter(low[a] - more, -kAll) : -kAll;
    high[a] = std::isfinite(more) ? std::nextafter(high[a] + more, kAll) : kAll;
  }
}

bool PatchCarriers3::Box::meets(const Box& other) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (low[a] > other.high[a] || other.low[a] > high[a]) return false;
  return true;
}

PatchCarriers3::PatchCarriers3(const Scene3& scene) : scene_(&scene), bases_(scene) {
  if (bases_.is_empty()) return;
  for (const Polygon3& polygon : scene.polygons) boxes_.emplace_back(polygon.points);
}

std::vector<std::uint32_t> PatchCarriers3::of(std::uint32_t patch) const {
  std::vector<BaseFacet> own;
  for (Polygon3& polygon : facets_of(scene_->polygons[patch])) own.emplace_back(std::move(polygon));
  std::vector<std::uint32_t> carriers;
  for (const std::uint32_t s : bases_.under(patch)) {
    if (!boxes_[patch].meets(boxes_[s])) continue;
    const std::vector<Polygon3> facets = facets_of(scene_->polygons[s]);
    if (std::ranges::any_of(facets, [&](const Polygon3& polygon) {
          const PlaneFrame3 frame(polygon.points);
          return std::ranges::any_of(own, [&](const BaseFacet& part) {
            return frame.key() == part.frame.key() && frame.region(polygon.points, polygon.holes).may_meet(part.region);
          });
        }))
      carriers.push_back(s);
  }
  return carriers;
}

std::vector<std::uint32_t> PatchCarriers3::on(const Face& face) const {
  std::vector<std::uint32_t> patches;
  for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
    const std::optional<Face> front = bases_.face_under(s, face.surface);
    if (!front || !boxes_[s].meets(boxes_[face.surface])) continue;
    if (front->is_back == face.is_back ? bases_.lies_on(s, face.surface) : scene_->surfaces[s].back.has_value())
      patches.push_back(s);
  }
  return patches;
}

std::vector<std::uint32_t> patches_on(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  const PatchCarriers3 carriers(scene);
  return carriers.bases().resting_on(surfaces, [&](std::uint32_t patch) { return carriers.of(patch); });
}

std::optional<BareScene3> without_patches(const Scene3& scene) {
  if (PatchBases(scene).is_empty()) return std::nullopt;
  BareScene3 bare{scene, {}};
  bare.scene.surfaces.clear();
  bare.scene.polygons.clear();
  std::vector<std::uint32_t> place;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    place.push_back(static_cast<std::uint32_t>(bare.surface_of.size()));
    if (scene.surfaces[s].on) continue;
    bare.scene.add(scene.surfaces[s], scene.polygons[s]);
    bare.surface_of.push_back(s);
  }
  for (Mask3& mask : bare.scene.masks) mask = {place[mask.surface], place[mask.base]};  // neither is a patch
  return bare;
}

}  // namespace hottel
