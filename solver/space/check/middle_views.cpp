#include "solver/space/check/middle_views.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/scene_names.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {
namespace {

// A point of a face, and the normal of the front of the surface there.
struct Place {
  Point3 at;
  Vector3 front;
};

// A place of the face that looks into no solid; nothing where there is none.
std::optional<Place> place_on(const Arrangement3& arrangement, const Face& face) {
  for (const PieceSide3& side : arrangement.sides(face)) {
    const Piece3& piece = arrangement.pieces()[side.piece];
    const Piece3::Side& here = piece.side(side.is_back);
    if (here.cover == Piece3::Cover::kFree) return Place{middle(piece.polygon), doubled_area(piece.polygon)};
    if (here.cover == Piece3::Cover::kPartly && !here.free.empty())
      return Place{middle(here.free.front()), doubled_area(piece.polygon)};
  }
  return std::nullopt;
}

Element element_of(const Scene3& scene, const Face& face, bool has_area) {
  Element element;
  element.name = face_name(scene, face);
  element.surface = face.surface;
  element.is_back = face.is_back;
  element.material = scene.surfaces[face.surface].material_of(face.is_back);
  const Vector3 twice = doubled_area(scene.polygons[face.surface]);
  const double x = to_double(twice.x), y = to_double(twice.y), z = to_double(twice.z);
  if (has_area) element.area.value = std::hypot(x, y, z) / 2;
  return element;
}

std::vector<FactorEntry> entries_of(const PreparedScene3& prepared, const Face& face, const Place& place,
                                    std::uint32_t sky) {
  const Vector3& normal = place.front;
  const int sign = face.is_back ? -1 : 1;
  Look3 look;
  look.eye = place.at;
  look.normal = Point3{sign * normal.x, sign * normal.y, sign * normal.z};
  const VisibilityMap3 map = map_from(prepared.occluders(), look);
  std::vector<double> seen(2 * prepared.scene.surfaces.size(), 0);
  for (const VisibilityMap3::Share& share : map.shares) {
    const Face& owner = prepared.arrangement().owner(share.face.surface, share.face.is_back);
    seen[owner.number()] += share.factor;
  }
  std::vector<FactorEntry> entries;
  for (std::uint32_t to = 0; to < seen.size(); ++to)
    if (seen[to] > 0) entries.push_back({to, {seen[to]}});
  if (map.sky_factor > kCertainSky3) entries.push_back({sky, {map.sky_factor}});
  return entries;
}

}  // namespace

ExchangeMatrix middle_views(const PreparedScene3& prepared, std::size_t most) {
  const Scene3& scene = prepared.scene;
  const auto count = static_cast<std::uint32_t>(2 * scene.surfaces.size());
  std::vector<std::optional<Place>> places;
  std::vector<Element> elements;
  std::size_t with_row = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    places.push_back(place_on(prepared.arrangement(), Face::of(k)));
    elements.push_back(element_of(scene, Face::of(k), places.back().has_value()));
    with_row += places.back() && elements.back().material;
  }
  const std::size_t step = (with_row + most - 1) / std::max<std::size_t>(most, 1);
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  std::vector<std::size_t> begin{0};
  FactorEntries entries;
  std::size_t row = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (places[k] && elements[k].material && row++ % std::max<std::size_t>(step, 1) == 0) {
      entries.append(entries_of(prepared, Face::of(k), *places[k], count));
    }
    begin.push_back(entries.size());
  }
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

}  // namespace hottel
