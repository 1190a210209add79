// The elements of a scene in space as approximate methods see them: convex patches in doubles.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

using Vector3d = LocalVector3<double>;

// One convex patch of an element, what solids cover left out.
//
//   (1) corners run counter-clockwise seen from its front; the normal, of length 1, leads into the space that the front
//       looks into
struct ElementPatch3 {
  std::uint32_t piece = 0;  // of PreparedScene3::occluders()
  const Patch3* exact = nullptr;
  std::vector<Vector3d> corners;
  Vector3d normal, centre;  // centre: of its area
  double area = 0;          // > 0
  double share = 1;         // of the area of its element
};

// The elements of a prepared scene, Granularity::kElement, in the doubles of Vertices3 (integer form times
// 2^-shift). Factors do not depend on scale, so methods need no other.
//
// An element may be several patches: where surfaces overlap, where it is not convex, where solids stand on it. A method
// treats each as an element of its own; with shares w the factors of the elements are F_ij = sum_a w_a sum_b F_ab over
// the patches a of i and b of j. There is no such thing as the centre of an element, only of a patch.
//
//   (1) corners are those of the exact patches, rounded once
//   (2) everything is the same bit for bit when the scene is translated, or scaled by a power of two
// Patches whose area in doubles is 0 are left out: an element that has no other exchanges nothing.
class ElementGeometry3 {
 public:
  explicit ElementGeometry3(const PreparedScene3& prepared);
  ElementGeometry3(const ElementGeometry3&) = delete;  // patches point into the table
  ElementGeometry3& operator=(const ElementGeometry3&) = delete;

  const ElementTable3& table() const { return *table_; }
  std::uint32_t count() const { return table_->count(); }
  bool has_row(std::uint32_t element) const { return table_->has_row(element); }
  std::span<const ElementPatch3> patches(std::uint32_t element) const {
    return {patches_.data() + begin_[element], patches_.data() + begin_[element + 1]};
  }
  // The patches of all elements, one element after the other.
  std::span<const ElementPatch3> all_patches() const { return patches_; }
  // The place of a patch in all_patches(). REQUIRES a reference into it, not a copy.
  std::size_t number_of(const ElementPatch3& patch) const { return static_cast<std::size_t>(&patch - patches_.data()); }
  double area(std::uint32_t element) const { return table_->extent(element).value; }

  // What a mask and its base exchange, which follows from their areas, whatever the method: F(mask, base) = 1 and
  // F(base, mask) by reciprocity, where the mask lies on one element. By ascending `to`.
  struct Contact {
    std::uint32_t to;
    double factor;
  };
  std::span<const Contact> contacts(std::uint32_t element) const { return contacts_[element]; }
  // What of the row of an element is not that of contacts.
  double share_of_patches(std::uint32_t element) const;

 private:
  std::shared_ptr<const ElementTable3> table_;
  std::vector<ElementPatch3> patches_;
  std::vector<std::size_t> begin_;
  std::vector<std::vector<Contact>> contacts_;  // by element
};

// Which elements have a row, and a patch to see from or a contact. REQUIRES that the geometry outlives what is
// returned.
inline auto has_patches(const ElementGeometry3& geometry) {
  return [&geometry](std::uint32_t element) {
    return geometry.has_row(element) && (!geometry.patches(element).empty() || !geometry.contacts(element).empty());
  };
}

// Returns the corners of a patch in the doubles of Vertices3, each rounded once.
std::vector<Vector3d> rounded_corners(const Vertices3& vertices, const Patch3& patch);

}  // namespace hottel
