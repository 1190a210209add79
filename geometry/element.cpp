#include "geometry/element.h"

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr int kTopShift = 62;

// Passes over what lies under a node, from `next` on; false where that is not whole.
bool pass_over(std::span<const TreeNode> leaves, std::size_t& next, const TreeNode& node, int children) {
  if (next == leaves.size() || leaves[next].part != node.part || !node.path.holds(leaves[next].path)) return false;
  if (leaves[next] == node) {
    ++next;
    return true;
  }
  for (int digit = 0; digit < children; ++digit)
    if (!pass_over(leaves, next, {node.part, node.path.child(digit)}, children)) return false;
  return true;
}

void append(std::vector<TreeNode>& leaves, const TreeNode& node, int children, int depth) {
  if (depth == 0) {
    leaves.push_back(node);
    return;
  }
  for (int digit = 0; digit < children; ++digit)
    append(leaves, {node.part, node.path.child(digit)}, children, depth - 1);
}

}  // namespace

TreePath::TreePath(std::span<const int> digits) {
  for (const int digit : digits) *this = child(digit);
}

TreePath TreePath::child(int digit) const {
  HOTTEL_REQUIRE(depth_ < kMostLevels && digit >= 0 && digit <= 3);
  TreePath result = *this;
  result.digits_ |= static_cast<std::uint64_t>(digit) << (kTopShift - 2 * depth_);
  ++result.depth_;
  return result;
}

TreePath TreePath::parent() const {
  HOTTEL_REQUIRE(depth_ > 0);
  TreePath result = *this;
  --result.depth_;
  result.digits_ &= ~(std::uint64_t{3} << (kTopShift - 2 * result.depth_));
  return result;
}

bool TreePath::holds(const TreePath& other) const {
  if (other.depth_ < depth_) return false;
  return depth_ == 0 || (digits_ ^ other.digits_) >> (kTopShift - 2 * (depth_ - 1)) == 0;
}

std::string TreePath::text() const {
  if (depth_ == 0) return {};
  std::string text = "/";
  for (int level = 0; level < depth_; ++level) text += static_cast<char>('0' + digit(level));
  return text;
}

bool are_whole(std::span<const TreeNode> leaves, std::uint32_t parts, int children) {
  std::size_t next = 0;
  for (std::uint32_t part = 0; part < parts; ++part)
    if (!pass_over(leaves, next, {part, {}}, children)) return false;
  return next == leaves.size();
}

std::vector<TreeNode> uniform_leaves(std::uint32_t parts, int children, int depth) {
  std::vector<TreeNode> leaves;
  for (std::uint32_t part = 0; part < parts; ++part) append(leaves, {part, {}}, children, depth);
  return leaves;
}

std::string element_name(const std::string& face, std::uint32_t parts, const TreeNode& node) {
  if (parts == 1 && node.path.depth() == 0) return face;
  return face + "#" + node.text();
}

}  // namespace hottel
