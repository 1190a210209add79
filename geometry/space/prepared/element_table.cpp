#include "geometry/space/prepared/element_table.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "geometry/face.h"
#include "geometry/scene_names.h"
#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/prepared/area_sum.h"
#include "geometry/space/scene/division.h"
#include "geometry/space/scene/plane_frame.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint64_t kMostElements = std::numeric_limits<std::uint32_t>::max() - 8;

// Whether a face is made of several elements, or may be.
bool is_divided(const Surface& surface, bool is_back, Granularity granularity) {
  return granularity == Granularity::kElement && surface.material_of(is_back) &&
         (surface.elements > 1 || !surface.trees.of(is_back).empty());
}

// A polygon divided into elements.
class Divided {
 public:
  Divided(const Polygon3& polygon, const Surface& surface, const Vertices3& vertices) : vertices_(vertices) {
    const auto add = [&](std::span<const Point3> points) {
      auto [integers, weight] = integer_points(vertices, points);
      divisions_.emplace_back(std::move(integers), surface.elements, HasTrees3{!surface.trees.is_empty()});
      weights_.push_back(std::move(weight));
    };
    if (is_convex(polygon)) {
      add(polygon.points);
    } else {
      for (const auto& triangle : triangles_of(polygon)) add(triangle);
    }
    for (const PolygonDivision3& division : divisions_) count_ += division.count();
  }

  // How many trees there are, each of which may be one element.
  std::uint32_t count() const { return static_cast<std::uint32_t>(count_); }

  // A node as a patch of a piece that holds it, its front as that of the polygon.
  Patch3 patch(const TreeNode& node, std::uint32_t piece) const {
    std::uint64_t k = node.part;
    std::size_t d = 0;
    for (; k >= divisions_[d].count(); ++d) k -= divisions_[d].count();
    return {.surface = piece,
            .corners = divisions_[d].corners(k, node.path),
            .weight = divisions_[d].weight(node.path.depth()) * weights_[d]};
  }
  std::vector<Point3> corners(const TreeNode& node) const { return corners_of(vertices_, patch(node, 0)); }

 private:
  const Vertices3& vertices_;
  std::vector<PolygonDivision3> divisions_;
  std::vector<Integer> weights_;
  std::uint64_t count_ = 0;
};

// The piece of a face that has all of its place and of which nothing is covered, or nothing.
std::optional<std::uint32_t> whole_piece(const Arrangement3& arrangement, const Face& face) {
  const auto sides = arrangement.sides(face);
  if (sides.size() != 1 || sides.front().is_back != face.is_back) return std::nullopt;
  const Piece3& piece = arrangement.pieces()[sides.front().piece];
  const bool is_free = piece.side(face.is_back).cover == Piece3::Cover::kFree;
  return piece.is_whole && piece.surface == face.surface && is_free ? std::optional(sides.front().piece) : std::nullopt;
}

// An element in the plane of its polygon: convex parts that share no area, each counter-clockwise.
using FlatElement = std::vector<std::vector<FlatPoint3>>;

// The elements of the front of a polygon, in their order.
std::vector<FlatElement> flat_elements(const Polygon3& polygon, const Surface& surface, bool is_divided,
                                       const Vertices3& vertices, const PlaneFrame3& frame) {
  std::vector<FlatElement> elements;
  if (is_divided) {
    const Divided divided(polygon, surface, vertices);
    const std::vector<TreeNode>& leaves = surface.trees.front;
    for (const TreeNode& leaf : leaves.empty() ? uniform_leaves(divided.count(), 4, 0) : leaves)
      elements.push_back({frame.outline(divided.corners(leaf))});
  } else if (is_convex(polygon)) {
    elements.push_back({frame.outline(polygon.points)});
  } else {
    FlatElement& element = elements.emplace_back();
    for (const auto& [a, b, c] : triangles_of(polygon)) element.push_back(frame.outline({a, b, c}));
  }
  return elements;
}

// Twice the area that two elements of one plane have in common, in its coordinates.
Rational doubled_common_area(const FlatElement& a, const FlatElement& b) {
  Rational area;
  for (const auto& part : a)
    for (const auto& other : b) {
      const std::vector<FlatPoint3> common = common_part(part, other);
      if (!common.empty()) area += doubled_area(common);
    }
  return area;
}

// The vector area of a patch is half of this multiple of its surface's primitive normal.
Rational doubled_share(const Patch3& patch, const IntegerVector& normal) {
  IntegerVector sum;
  for (std::size_t k = 1; k + 1 < patch.corners.size(); ++k) {
    const IntegerVector turn =
        cross(difference(patch.corners[k], patch.corners[0]), difference(patch.corners[k + 1], patch.corners[0]));
    sum = {sum.x + turn.x, sum.y + turn.y, sum.z + turn.z};
  }
  const Integer share = normal.x != 0   ? Integer(sum.x / normal.x)
                        : normal.y != 0 ? Integer(sum.y / normal.y)
                                        : Integer(sum.z / normal.z);
  return Rational(abs(share)) / (patch.weight * patch.weight);
}

}  // namespace

ElementCounts3 element_counts(const Scene3& scene, Granularity granularity) {
  ElementCounts3 counts;
  const auto add = [&counts](std::uint64_t parts, bool has_material) {
    counts.all += parts;
    if (has_material) counts.with_material += parts;
  };
  if (granularity == Granularity::kGroup) {
    std::vector<char> is_there(scene.groups.size(), 0), has_front(is_there), has_back(is_there);
    for (const Surface& surface : scene.surfaces) {
      is_there[surface.group] = 1;
      if (surface.material_of(false)) has_front[surface.group] = 1;
      if (surface.material_of(true)) has_back[surface.group] = 1;
    }
    for (std::size_t group = 0; group < is_there.size(); ++group) {
      if (is_there[group] == 0) continue;
      add(1, has_front[group] != 0);
      add(1, has_back[group] != 0);
    }
    return counts;
  }
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    for (const bool is_back : {false, true}) {
      const std::uint64_t leaves = surface.trees.of(is_back).size();
      const std::uint64_t parts = !is_divided(surface, is_back, granularity) ? 1
                                  : leaves > 0                               ? leaves
                                               : element_count(scene.polygons[s], surface.elements);
      add(parts, surface.material_of(is_back).has_value());
    }
  }
  return counts;
}

ElementTable3::ElementTable3(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders,
                             Granularity granularity)
    : is_by_group_(granularity == Granularity::kGroup) {
  HOTTEL_REQUIRE(arrangement.pieces().size() == occluders.size());
  if (const std::uint64_t count = element_counts(scene, granularity).all; count > kMostElements)
    throw RequestError("the scene would have " + std::to_string(count) + " elements; there may be " +
                       std::to_string(kMostElements));
  if (is_by_group_)
    add_groups(scene, arrangement, occluders);
  else
    add_faces(scene, arrangement, occluders, granularity);
  holders_ = is_by_group_ ? 2 * static_cast<std::uint32_t>(scene.surfaces.size()) : count();
  if (occluders.size() > 0) parts_.push_back({Patch3::all_of_the_sky(), sky(), holders_, false});
  for (const Part& part : parts_) {
    while (begin_.size() <= part.label) begin_.push_back(static_cast<std::size_t>(&part - parts_.data()));
  }
  begin_.resize(std::size_t{sky()} + 2, parts_.size());
  measure(occluders, add_contacts(scene, occluders.vertices()), square_metres_per_unit(scene));
}

bool ElementTable3::has_contact(std::uint32_t label) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [label](const Contact& contact) { return contact.mask == label || contact.base == label; });
}

void ElementTable3::add_parts(FacePatches3 patches, std::uint32_t label, std::uint32_t holder) {
  const auto known = free_.find(label);
  if (!patches.is_free || known != free_.end()) {
    std::vector<Part>& free = free_[label];
    if (known == free_.end())
      for (const Part& part : parts_)
        if (part.label == label) free.push_back(part);
    for (const SidePatch3& some : patches.uncovered()) free.push_back({some.patch, label, holder, some.is_back});
  }
  for (SidePatch3& some : patches.patches) parts_.push_back({std::move(some.patch), label, holder, some.is_back});
}

void ElementTable3::add_faces(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders,
                              Granularity granularity) {
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    std::optional<Divided> divided;
    if (is_divided(surface, false, granularity) || is_divided(surface, true, granularity))
      divided.emplace(scene.polygons[s], surface, occluders.vertices());
    for (const bool is_back : {false, true}) {
      const Face face{s, is_back};
      const std::optional<std::uint32_t> material = surface.material_of(is_back);
      const std::string name = face_name(scene, face);
      const std::uint32_t parts = is_divided(surface, is_back, granularity) ? divided->count() : 1;
      const std::vector<TreeNode>& trees = surface.trees.of(is_back);
      const std::vector<TreeNode> leaves =
          trees.empty() || !is_divided(surface, is_back, granularity) ? uniform_leaves(parts, 4, 0) : trees;
      HOTTEL_REQUIRE(are_whole(leaves, parts, 4));
      const std::optional<std::uint32_t> whole = whole_piece(arrangement, face);
      for (const TreeNode& leaf : leaves) {
        elements_.push_back({element_name(name, parts, leaf), s, leaf.part, parts, is_back, material, {}, leaf.path});
        const std::uint32_t label = count() - 1;
        if (!elements_.back().is_part()) {
          add_parts(face_patches(arrangement, occluders, face), label, label);
        } else if (whole) {
          Patch3 patch = divided->patch(leaf, *whole);
          if (is_back) turn_round(patch);
          parts_.push_back({std::move(patch), label, label, is_back});
        } else {
          const std::vector<Point3> corners = divided->corners(leaf);
          add_parts(face_patches(arrangement, occluders, face, &corners), label, label);
        }
      }
    }
  }
}

void ElementTable3::add_groups(const Scene3& scene, const Arrangement3& arrangement, const Occluders3& occluders) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  // The label of the fronts of each group; that of its backs is the next one.
  std::vector<std::uint32_t> first(scene.groups.size(), kNone);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    std::uint32_t& label = first[surface.group];
    const bool is_new = label == kNone;
    if (is_new) label = count();
    for (const bool is_back : {false, true}) {
      const std::optional<std::uint32_t> material = surface.material_of(is_back);
      if (is_new)
        elements_.push_back({side_text({scene.groups[surface.group].name, is_back}), s, 0, 1, is_back, material, {}});
      else if (material)
        elements_[label + is_back].material = material;
      const Face face{s, is_back};
      add_parts(face_patches(arrangement, occluders, face), label + is_back, face.number());
    }
  }
  std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.label < b.label; });
}

std::vector<ElementTable3::Share> ElementTable3::add_contacts(const Scene3& scene, const Vertices3& vertices) {
  std::vector<Share> shares;
  if (scene.masks.empty()) return shares;
  const Rational square = vertices.scale() * vertices.scale();
  // The elements of the front of a surface, in order.
  const auto fronts = [&](std::uint32_t s) {
    std::vector<std::uint32_t> labels;
    for (std::uint32_t label = 0; label < count(); ++label) {
      const Element& element = elements_[label];
      const bool is_own =
          is_by_group_ ? scene.surfaces[element.surface].group == scene.surfaces[s].group : element.surface == s;
      if (!element.is_back && is_own) labels.push_back(label);
    }
    return labels;
  };
  for (const Mask3& mask : scene.masks) {
    const PlaneFrame3 frame(scene.polygons[mask.surface].points);
    const IntegerVector normal = primitive({frame.key()[0], frame.key()[1], frame.key()[2]});
    // The coordinates of the frame leave out the first component that is not 0.
    const Integer& across = normal.x != 0 ? normal.x : normal.y != 0 ? normal.y : normal.z;
    const std::vector<std::uint32_t> masks = fronts(mask.surface), bases = fronts(mask.base);
    const auto flat = [&](std::uint32_t s, const std::vector<std::uint32_t>& labels) {
      const bool has_parts = !is_by_group_ && elements_[labels.front()].is_part();
      return flat_elements(scene.polygons[s], scene.surfaces[s], has_parts, vertices, frame);
    };
    const std::vector<FlatElement> of_mask = flat(mask.surface, masks), of_base = flat(mask.base, bases);
    HOTTEL_REQUIRE(of_mask.size() == masks.size() && of_base.size() == bases.size());
    for (std::size_t k = 0; k < masks.size(); ++k)
      for (std::size_t l = 0; l < bases.size(); ++l) {
        const Rational doubled = doubled_common_area(of_mask[k], of_base[l]);
        if (doubled == 0) continue;
        contacts_.push_back({masks[k], bases[l], {}});
        shares.emplace_back(doubled / (2 * square * abs(across)), dot(normal, normal));
      }
  }
  return shares;
}

void ElementTable3::measure(const Occluders3& occluders, const std::vector<Share>& of_contacts,
                            const Rational& square_metres) {
  const Vertices3& vertices = occluders.vertices();
  const Rational told = vertices.scale() * vertices.scale() * square_metres;
  const Rational of_doubles = scaled_by_power_of_two(1, -2 * vertices.shift());
  std::multimap<std::uint32_t, Share> touched;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    AreaSum3 area;
    area.add(of_contacts[k].first, of_contacts[k].second);
    contacts_[k].extent = area.rounded(of_doubles);
    for (const std::uint32_t label : {contacts_[k].mask, contacts_[k].base}) touched.emplace(label, of_contacts[k]);
  }
  AreaSum3 before;
  for (std::uint32_t label = 0; label < count(); ++label) {
    AreaSum3 area;
    for (const Part& part : free_parts(label)) {
      const IntegerVector& normal = occluders.exact_normal(part.patch.surface);
      area.add(doubled_share(part.patch, normal) / 2, dot(normal, normal));
    }
    const auto [touch, last] = touched.equal_range(label);
    for (auto contact = touch; contact != last; ++contact) area.add(contact->second.first, contact->second.second);
    if (parts(label).empty() && touch == last) {
      elements_[label].area = {};
      extents_.push_back({});
      before = {};
      continue;
    }
    // Equal parts follow each other.
    if (area == before) {
      elements_[label].area = elements_[label - 1].area;
      extents_.push_back(extents_.back());
      continue;
    }
    elements_[label].area = area.rounded(told);
    extents_.push_back(area.rounded(of_doubles));
    before = std::move(area);
  }
}

std::vector<std::vector<std::array<double, 3>>> element_corners(const ElementTable3& table, const Vertices3& vertices) {
  std::vector<std::vector<std::array<double, 3>>> result(table.count());
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const auto parts = table.parts(label);
    if (parts.size() != 1) continue;
    for (const Point3& p : corners_of(vertices, parts.front().patch))
      result[label].push_back({to_double(p.x), to_double(p.y), to_double(p.z)});
  }
  return result;
}

}  // namespace hottel
