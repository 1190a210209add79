#include "geometry/plane/visibility/point_view.h"

#include <algorithm>
#include <map>

#include "geometry/scene_names.h"

namespace hottel {
namespace {

// Faces and the sky, in the order of first sight.
std::vector<SeenFrom2> seen_faces(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  std::vector<SeenFrom2> faces;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k) {
    const auto& part = polygon.parts[k];
    if (part.solid != Solids2::kNone) continue;
    const std::string name = face_name(prepared.scene, prepared.arrangement, part.side);
    auto place = std::find_if(faces.begin(), faces.end(), [&](const SeenFrom2& face) { return face.name == name; });
    if (place == faces.end()) place = faces.insert(place, {name, {}, {}});
    place->parts.push_back(k);
  }
  return faces;
}

std::vector<SeenFrom2> met_solids(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  std::map<std::uint32_t, std::vector<std::size_t>> parts_of;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k)
    if (polygon.parts[k].solid != Solids2::kNone) parts_of[polygon.parts[k].solid].push_back(k);
  std::vector<SeenFrom2> solids;
  for (auto& [solid, parts] : parts_of) solids.push_back({prepared.scene.groups[solid].name, std::move(parts), {}});
  return solids;
}

}  // namespace

std::string face_name(const Scene2& scene, const Arrangement2& arrangement, PieceSideId side) {
  if (side == kSky) return "sky";
  return face_name(scene, arrangement.owner(side));
}

PointView2 point_view(const PreparedScene2& prepared, const Point2& eye) {
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  PointView2 sight{visibility_polygon(arrangement, location, eye), {}, {}};
  if (sight.polygon.solid != Solids2::kNone) return sight;
  sight.faces = seen_faces(prepared, sight.polygon);
  sight.solids = met_solids(prepared, sight.polygon);
  for (std::vector<SeenFrom2>* list : {&sight.faces, &sight.solids})
    for (SeenFrom2& seen : *list) seen.fraction = rounded_angle_fraction(sight.polygon, seen.parts);
  return sight;
}

std::vector<FaceFactor2> point_factors_by_face(const PreparedScene2& prepared, const Face& face, const Rational& t) {
  const Arrangement2& arrangement = prepared.arrangement;
  const Edge2& edge = prepared.scene.edges[face.surface];
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  std::vector<FaceFactor2> factors;
  for (const PointFactor2& factor : point_factors(arrangement, location, edge.from, edge.to, face.is_back, t)) {
    const std::string to = face_name(prepared.scene, arrangement, factor.side);
    const auto same =
        std::find_if(factors.begin(), factors.end(), [&](const FaceFactor2& entry) { return entry.to == to; });
    if (same == factors.end())
      factors.push_back({to, factor.factor});
    else
      same->factor += factor.factor;
  }
  return factors;
}

}  // namespace hottel
