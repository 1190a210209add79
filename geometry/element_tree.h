// Elements divided further where it is worth it: paths in the tree under an element, and the leaves of a face.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/face.h"

namespace hottel {

// The way from an element down to a node of the tree under it: one digit a level, 0 or 1 in the plane (the half with
// the first or the second point), 0 to 3 in space.
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
//   (1) the leaves of a face that has any share nothing, and together they are the face: is_whole()
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

}  // namespace hottel
