// The tree of a scene as an eye sees it. Internal to geometry/space/visibility.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/visibility/view_cones.h"
#include "geometry/space/visibility/view_shells.h"

namespace hottel {

// The nodes of the tree of Occluders3 with the polygons that may be seen, and the shells that hide.
//
//   (1) the cone of a node is around its polygons, but for those that are buried, and around its shells
//   (2) a shell is in one leaf: that of one of its polygons
//
// One for each thread: it keeps working memory. COST: linear in the corners of polygons.
class ViewTree3 {
 public:
  // REQUIRES: what it is made of outlives this.
  ViewTree3(const EyePlanes3& planes, const ViewShells3& shells);

  const ViewCone3& node(std::size_t n) const { return nodes_[n]; }

  // Leaves a shell, or all in a node, out of what find_shells() finds: it hides nothing that others do not.
  void drop_shell(std::uint32_t shell) { is_dropped_[shell] = true; }
  void drop_node(std::size_t n) { nodes_[n] = {}; }

  // Sets `found` to the shells that may hide something in the target. COST: that of the nodes whose cones meet that
  // of the target.
  void find_shells(const ViewCone3& target, std::vector<std::uint32_t>& found);

 private:
  const std::vector<Occluders3::Node>& tree_;
  const ViewShells3& shells_;
  std::vector<ViewCone3> nodes_;
  std::vector<std::uint32_t> first_, in_leaves_;  // the shells of node n are in_leaves_[first_[n], first_[n + 1])
  std::vector<bool> is_dropped_;
  std::vector<std::uint32_t> waiting_;
};

}  // namespace hottel
