// The elements of a scene in space, and the patches that they are made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/prepared/face_patches.h"
#include "geometry/space/scene/scene.h"
#include "kernel/enclosure.h"

namespace hottel {

// How many elements the table of a scene will have, and how many of them have a row. COST: linear in the corners of
// polygons.
struct ElementCounts3 {
  std::uint64_t all = 0, with_material = 0;
  friend bool operator==(const ElementCounts3&, const ElementCounts3&) = default;
};
ElementCounts3 element_counts(const Scene3& scene, Granularity granularity);

// The elements of a scene in the order of the contract: surfaces in the order of the scene, front before back, parts
// ascending as PolygonDivision3 numbers them.
//
//   (1) every front and every back is an element, divided at Granularity::kElement where it has a material; a black
//       back is one element and has no row
//   (2) Granularity::kGroup: all fronts of a group are one element, and all its backs another
//   (3) an element is made of patches: a convex face that keeps all its place, or a part of one, of a single one;
//       others of one for each piece of the arrangement (FacePatches3), a group of those of its members; the sky is
//       one, all of it. Patches are in the order of their elements; corners of backs run the other way round, from the
//       same first one
//   (4) areas are of what is not covered, correctly rounded, in m² where the unit of the scene is known, else in its
//       squares; extent() encloses them in the unit of PairIntegrator3. An
//       element that other faces or solids leave nothing of has no patch, the area 0 and no row
//   (5) where a mask lies on its base, elements of both see each other across no distance: contacts(). They have no
//       patch there, but the area
//
// Throws RequestError for more elements than can be numbered.
// REQUIRES: the arrangement is that of the scene, and the occluders are its pieces. COST: some 5 microseconds and 500
// bytes an element.
class ElementTable3 {
 public:
  ElementTable3(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders,
                Granularity granularity);

  std::uint32_t count() const { return static_cast<std::uint32_t>(elements_.size()); }
  std::uint32_t sky() const { return count(); }
  const std::vector<Element>& elements() const { return elements_; }
  // True iff the element has a material and an area: only then are factors from it computed. The sky has none.
  bool has_row(std::uint32_t label) const {
    return label < count() && elements_[label].material.has_value() && (!parts(label).empty() || has_contact(label));
  }

  struct Part {
    Patch3 patch;
    std::uint32_t label;
    std::uint32_t holder;  // the element; of groups the number of the face, 2 for each surface; next to all, the sky
    bool is_back;          // of the piece
  };
  // All patches by label, those of the sky last.
  const std::vector<Part>& parts() const { return parts_; }
  std::span<const Part> parts(std::uint32_t label) const {
    return {parts_.data() + begin_[label], parts_.data() + begin_[label + 1]};
  }
  // True iff it is one patch, of which nothing is covered.
  bool is_one_patch(std::uint32_t label) const {
    return begin_[label + 1] - begin_[label] == 1 && !free_.contains(label);
  }
  // True iff some of it is covered, and some is not. Two such elements may see each other within a solid: of one of
  // them what is free is to be measured.
  bool is_partly_covered(std::uint32_t label) const { return free_.contains(label); }
  // What is not covered of the patches.
  std::span<const Part> free_parts(std::uint32_t label) const {
    const auto place = free_.find(label);
    return place == free_.end() ? parts(label) : std::span<const Part>(place->second);
  }
  bool is_by_group() const { return is_by_group_; }
  // Holders are what the tolerance is told of: elements, or faces where a group is one.
  std::uint32_t holders() const { return holders_; }

  // An element of a mask and one of its base, with the area that they share: S of both, as extents are.
  struct Contact {
    std::uint32_t mask, base;
    Rounded extent;
  };
  // In the order of masks. Where both are in one group they are the same.
  const std::vector<Contact>& contacts() const { return contacts_; }
  bool has_contact(std::uint32_t label) const;

  // The area in squares of the doubles of Vertices3, as a correctly rounded double. REQUIRES label < count().
  const Rounded& extent(std::uint32_t label) const { return extents_[label]; }

 private:
  void add_faces(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders,
                 Granularity granularity);
  void add_groups(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders);
  void add_parts(FacePatches3 patches, std::uint32_t label, std::uint32_t holder);
  // Returns the area of each contact as an AreaSum3 takes it: a multiple of a length that is given by its square.
  using Share = std::pair<Rational, Integer>;
  std::vector<Share> add_contacts(const Scene3& scene, const Vertices3& vertices);
  void measure(const Occluders3& occluders, const std::vector<Share>& of_contacts, const Rational& square_metres);

  std::vector<Element> elements_;
  std::vector<Part> parts_;
  std::unordered_map<std::uint32_t, std::vector<Part>> free_;  // of labels of which some is covered
  std::vector<std::size_t> begin_;                             // of the patches of a label
  std::vector<Contact> contacts_;
  bool is_by_group_ = false;
  std::uint32_t holders_ = 0;  // without the sky
  std::vector<Rounded> extents_;
};

// Returns the corners of each element in scene coordinates, each rounded to the nearest double, in the order of the
// elements; none of groups.
std::vector<std::vector<std::array<double, 3>>> element_corners(const ElementTable3& table, const Vertices3& vertices);

}  // namespace hottel
