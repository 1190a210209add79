#include "solver/space/methods/element_geometry.h"

#include <algorithm>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {
namespace {

// Sets what follows from the corners; the area is 0 where doubles tell none.
void measure(ElementPatch3& patch) {
  const Vector3d& first = patch.corners.front();
  Vector3d twice, moment;
  for (std::size_t k = 1; k + 1 < patch.corners.size(); ++k)
    twice = twice + cross(patch.corners[k] - first, patch.corners[k + 1] - first);
  const double doubled = length(twice);
  if (!(doubled > 0)) return;
  patch.normal = 1 / doubled * twice;
  for (std::size_t k = 1; k + 1 < patch.corners.size(); ++k) {
    const Vector3d a = patch.corners[k] - first, b = patch.corners[k + 1] - first;
    moment = moment + dot(cross(a, b), patch.normal) / 3 * (a + b);
  }
  patch.centre = first + 1 / doubled * moment;
  patch.area = doubled / 2;
}

}  // namespace

std::vector<Vector3d> rounded_corners(const Vertices3& vertices, const Patch3& patch) {
  const auto number = [&](const Integer& value) {
    return to_double(scaled_by_power_of_two(Rational(value) / Rational(patch.weight), -vertices.shift()));
  };
  std::vector<Vector3d> corners;
  for (const IntegerVector& corner : patch.corners)
    corners.push_back({number(corner.x), number(corner.y), number(corner.z)});
  return corners;
}

ElementGeometry3::ElementGeometry3(const PreparedScene3& prepared) : table_(prepared.elements(Granularity::kElement)) {
  const Vertices3& vertices = prepared.occluders().vertices();
  for (std::uint32_t element = 0; element < table_->count(); ++element) {
    begin_.push_back(patches_.size());
    for (const ElementTable3::Part& part : table_->free_parts(element)) {
      ElementPatch3 patch;
      patch.piece = part.patch.surface;
      patch.exact = &part.patch;
      patch.corners = rounded_corners(vertices, part.patch);
      measure(patch);
      if (!(patch.area > 0)) continue;
      patch.share = patch.area / table_->extent(element).value;
      patches_.push_back(std::move(patch));
    }
  }
  begin_.push_back(patches_.size());
  contacts_.resize(table_->count());
  for (const ElementTable3::Contact& contact : table_->contacts()) {
    const double extent = contact.extent.value;
    contacts_[contact.mask].push_back({contact.base, extent / area(contact.mask)});
    contacts_[contact.base].push_back({contact.mask, extent / area(contact.base)});
  }
  for (std::vector<Contact>& of_element : contacts_)
    std::sort(of_element.begin(), of_element.end(), [](const Contact& a, const Contact& b) { return a.to < b.to; });
}

double ElementGeometry3::share_of_patches(std::uint32_t element) const {
  double share = 1;
  for (const Contact& contact : contacts_[element]) share -= contact.factor;
  return std::max(0.0, share);
}

}  // namespace hottel
