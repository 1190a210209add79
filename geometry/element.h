// Elements, which carry one unknown each, and the trees by which they are divided further where it is worth it.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/face.h"
#include "kernel/enclosure.h"

namespace hottel {

// The way from an element down to a node of the tree under it: one digit a level, 0 or 1 in the plane (the half with
// the first or the second point), 0 to 3 in space: c is the quarter of a quad at its corner c, the part of a triangle
// at its corner c, and 3 the middle one of a triangle.
//
//   (1) ordered as the nodes are met from left to right, a node before those under it
//   (2) at most kMostLevels digits
class TreePath {
 public:
  static constexpr int kMostLevels = 24;

  TreePath() = default;  // the element itself
  // Throws ContractViolation for more than kMostLevels digits, or one above 3.
  explicit TreePath(std::span<const int> digits);

  int depth() const { return depth_; }
  int digit(int level) const { return static_cast<int>(digits_ >> (62 - 2 * level)) & 3; }  // REQUIRES level < depth()
  TreePath child(int digit) const;  // throws ContractViolation where that would be too deep
  TreePath parent() const;          // REQUIRES depth() > 0
  // True iff the node is this one or lies under it.
  bool holds(const TreePath& other) const;

  // "/01"; empty for the element itself.
  std::string text() const;

  friend bool operator==(const TreePath&, const TreePath&) = default;
  friend auto operator<=>(const TreePath&, const TreePath&) = default;

 private:
  std::uint64_t digits_ = 0;  // two bits each, the first one in the highest place
  int depth_ = 0;
};

// A node of a face: which of its equal parts, and where under it.
struct TreeNode {
  std::uint32_t part = 0;
  TreePath path{};

  std::string text() const { return std::to_string(part) + path.text(); }  // "2/01"
  friend bool operator==(const TreeNode&, const TreeNode&) = default;
  friend auto operator<=>(const TreeNode&, const TreeNode&) = default;
};

// What carries an unknown: a node of a face.
struct ElementId {
  Face face{};
  TreeNode node{};
  friend bool operator==(const ElementId&, const ElementId&) = default;
  friend auto operator<=>(const ElementId&, const ElementId&) = default;
};

// The leaves of both faces of a surface, ascending; of a face that has none every equal part is one.
//
//   (1) the leaves of a face that has any share nothing, and together they are the face: are_whole()
struct SurfaceTrees {
  std::vector<TreeNode> front{}, back{};

  const std::vector<TreeNode>& of(bool is_back) const { return is_back ? back : front; }
  bool is_empty() const { return front.empty() && back.empty(); }
  friend bool operator==(const SurfaceTrees&, const SurfaceTrees&) = default;
};

// True iff leaves ascend, share nothing and are together so many parts, each node of a tree having so many children.
bool are_whole(std::span<const TreeNode> leaves, std::uint32_t parts, int children);

// All nodes of so many parts at one depth, ascending. depth 0: the parts.
std::vector<TreeNode> uniform_leaves(std::uint32_t parts, int children, int depth);

// What one row and column of the exchange matrix stands for.
// kFace:    a face, whole
// kElement: one of the equal parts of a face with a material, or a leaf of the trees under them; a black back is never
//           divided
// kGroup:   all fronts, or all backs, of the surfaces of one group
enum class Granularity : unsigned char { kFace, kElement, kGroup };
inline constexpr std::size_t kGranularities = 3;

// One row or column of an exchange matrix: a face, a part of one, or a group of faces.
//
//   (1) part < parts, and parts == 1 for what is not divided into equal parts; the path leads on from the part
//   (2) an element without a material, or with area 0, has no row
struct Element {
  std::string name;                   // "wall", "wall:back", "wall#2", "wall#2/01"
  std::uint32_t surface = 0;          // index into the scene's surfaces (the first one of a group)
  std::uint32_t part = 0, parts = 1;  // which of how many equal parts
  bool is_back = false;
  // None: an opaque black back, which has a column but no row. Of a group with several materials that of the last
  // surface that has any: factors need no more.
  std::optional<std::uint32_t> material;
  // What of it is not owned by others: its area [m²], in the plane its length [m], also of a scene that is typed in
  // another unit; in the scene's unit where that is not known (SceneTable::unit). 0 where others own all of it.
  Rounded area;
  TreePath path{};  // under its part

  // True iff it is not the whole face.
  bool is_part() const { return parts > 1 || path.depth() > 0; }
  TreeNode node() const { return {part, path}; }
};

// What an element is called: its face's name, and where it is a part of it, "#2" or "#2/01".
std::string element_name(const std::string& face, std::uint32_t parts, const TreeNode& node);

// Two elements by number, or an element and the sky. The smaller is first unless who returns it says otherwise.
using ElementPair = std::pair<std::uint32_t, std::uint32_t>;

}  // namespace hottel
