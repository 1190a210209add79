#include "geometry/space/visibility/view_tree.h"

namespace hottel {

ViewTree3::ViewTree3(const EyePlanes3& planes, const ViewShells3& shells)
    : tree_(planes.occluders().nodes()), shells_(shells) {
  const Occluders3& occluders = planes.occluders();
  std::vector<bool> is_placed(shells.size(), false);
  std::vector<ViewBox3> boxes(tree_.size());
  const auto include = [&](std::size_t n, std::span<const VertexId3> corners) {
    for (const VertexId3 v : corners) boxes[n].include(planes.eye().toward(v));
  };
  in_leaves_.reserve(shells.size());
  first_.reserve(tree_.size() + 1);
  for (std::size_t n = 0; n < tree_.size(); ++n) {
    first_.push_back(static_cast<std::uint32_t>(in_leaves_.size()));
    if (tree_[n].left != 0) continue;
    for (std::uint32_t k = tree_[n].begin; k < tree_[n].end; ++k) {
      const std::uint32_t s = occluders.order()[k];
      if (planes.facing(s) == 0 || shells.is_buried(s)) continue;
      const std::uint32_t shell = shells.shell_of(s);
      if (!is_placed[shell]) {
        is_placed[shell] = true;
        in_leaves_.push_back(shell);
        include(n, shells[shell].cone.corners);
      } else {
        include(n, occluders.outline(s));
      }
    }
  }
  first_.push_back(static_cast<std::uint32_t>(in_leaves_.size()));
  nodes_.resize(tree_.size());
  // Children stand behind their parents.
  for (std::size_t n = tree_.size(); n-- > 0;) {
    if (tree_[n].left != 0) {
      boxes[n].include(boxes[tree_[n].left]);
      boxes[n].include(boxes[tree_[n].right]);
    }
    nodes_[n] = ViewCones3::around(boxes[n]);
  }
  is_dropped_.resize(shells.size());
}

void ViewTree3::find_shells(const ViewCone3& target, std::vector<std::uint32_t>& found) {
  found.clear();
  if (nodes_.empty()) return;
  waiting_.assign(1, 0);
  while (!waiting_.empty()) {
    const std::uint32_t n = waiting_.back();
    waiting_.pop_back();
    if (!may_hide(nodes_[n], target)) continue;
    if (tree_[n].left != 0) {
      waiting_.push_back(tree_[n].right);
      waiting_.push_back(tree_[n].left);
      continue;
    }
    for (std::uint32_t k = first_[n]; k < first_[n + 1]; ++k)
      if (!is_dropped_[in_leaves_[k]] && may_hide(shells_[in_leaves_[k]].around, target))
        found.push_back(in_leaves_[k]);
  }
}

}  // namespace hottel
