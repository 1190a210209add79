#include "geometry/space/exchange/exact_form.h"

#include <algorithm>
#include <vector>

#include "geometry/space/exchange/face_sight.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {
namespace {

// The corners of a face as its side has them; nothing where it is not a whole convex polygon.
std::optional<std::vector<Point3>> corners_of_whole(const PreparedScene3& prepared, const Face& face) {
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  const Polygon3& polygon = prepared.scene.polygons[face.surface];
  if (!table.is_one_patch(face.number()) || table.has_contact(face.number()) || !is_convex(polygon))
    return std::nullopt;
  std::vector<Point3> corners = polygon.points;
  if (face.is_back) std::ranges::reverse(corners);
  return corners;
}

}  // namespace

ExactForm3 exact_form_3(const PreparedScene3& prepared, const Face& from, const Face& to) {
  const SeenFace3 sight = sight_between(prepared, from, to);
  if (!sight.is_seen) return {ArcSum3(), {}};
  if (!sight.is_whole) return {std::nullopt, "something hides a part of one from the other"};
  const auto a = corners_of_whole(prepared, from), b = corners_of_whole(prepared, to);
  if (!a || !b) return {std::nullopt, "one of them is not a whole rectangle: it is cut, covered, or bent"};
  if (auto form = rectangle_exchange(*a, *b)) return {std::move(form), {}};
  return {std::nullopt,
          "they are not two rectangles with sides of rational length that lie parallel or at right angles, with sides "
          "along each other"};
}

std::optional<Rational> rational_area(const PreparedScene3& prepared, const Face& face) {
  const auto corners = corners_of_whole(prepared, face);
  return corners ? rectangle_area(*corners) : std::nullopt;
}

}  // namespace hottel
