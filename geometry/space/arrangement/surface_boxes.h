// Boxes around the polygons of a scene, in their tree. Internal to geometry/space.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "kernel/doubles.h"

namespace hottel {

// A box of the doubles of Vertices3. It begins around nothing.
struct Box3 {
  std::array<double, 3> low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

  void include(const BoundedVector& p) {
    const double values[] = {p.x, p.y, p.z};
    for (int a = 0; a < 3; ++a) {
      if (values[a] - p.error < low[a]) low[a] = values[a] - p.error;
      if (values[a] + p.error > high[a]) high[a] = values[a] + p.error;
    }
  }
  void include(const Box3& other) {
    for (int a = 0; a < 3; ++a) {
      if (other.low[a] < low[a]) low[a] = other.low[a];
      if (other.high[a] > high[a]) high[a] = other.high[a];
    }
  }
  // True iff the closed boxes meet.
  bool meets(const Box3& other) const {
    for (int a = 0; a < 3; ++a)
      if (low[a] > other.high[a] || other.low[a] > high[a]) return false;
    return true;
  }
};

// The boxes of all polygons and of the nodes of their tree: they contain what they are around, rounding included.
// For several threads at once.
class SurfaceBoxes3 {
 public:
  // REQUIRES that the occluders outlive this.
  explicit SurfaceBoxes3(const Occluders3& occluders) : occluders_(&occluders) {
    surfaces_.resize(occluders.size());
    for (std::size_t s = 0; s < occluders.size(); ++s)
      for (const VertexId3 v : occluders.outline(s)) surfaces_[s].include(occluders.vertices().approximate(v));
    nodes_.resize(occluders.nodes().size());
    // Children stand behind their parents.
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      const Occluders3::Node& node = occluders.nodes()[n];
      if (node.left != 0) {
        nodes_[n] = nodes_[node.left];
        nodes_[n].include(nodes_[node.right]);
      } else {
        for (std::uint32_t k = node.begin; k < node.end; ++k) nodes_[n].include(surfaces_[occluders.order()[k]]);
      }
    }
  }

  const Box3& of(std::size_t s) const { return surfaces_[s]; }
  // The largest coordinate of a polygon; 0 where there is none.
  double reach() const {
    double most = 0;
    if (!nodes_.empty())
      for (int a = 0; a < 3; ++a) most = std::max({most, -nodes_[0].low[a], nodes_[0].high[a]});
    return most;
  }

  // Appends the polygons whose boxes meet this one.
  void find(const Box3& box, std::vector<std::uint32_t>& found) const {
    find_where([&box](const Box3& other) { return other.meets(box); }, found);
  }
  // Whether the box of some polygon but two meets this one.
  bool is_any_but(std::uint32_t first, std::uint32_t second, const Box3& box) const {
    return !nodes_.empty() && is_any_but(0, first, second, box);
  }
  // Appends the polygons whose boxes are so; a box in another one must be so only if that one is.
  template <class IsSo>
  void find_where(const IsSo& is_so, std::vector<std::uint32_t>& found) const {
    if (!nodes_.empty()) find_where(0, is_so, found);
  }

 private:
  template <class IsSo>
  void find_where(std::uint32_t n, const IsSo& is_so, std::vector<std::uint32_t>& found) const {
    if (!is_so(nodes_[n])) return;
    const Occluders3::Node& node = occluders_->nodes()[n];
    if (node.left != 0) {
      find_where(node.left, is_so, found);
      find_where(node.right, is_so, found);
      return;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      if (const std::uint32_t s = occluders_->order()[k]; is_so(surfaces_[s])) found.push_back(s);
  }

  bool is_any_but(std::uint32_t n, std::uint32_t first, std::uint32_t second, const Box3& box) const {
    if (!nodes_[n].meets(box)) return false;
    const Occluders3::Node& node = occluders_->nodes()[n];
    if (node.left != 0) return is_any_but(node.left, first, second, box) || is_any_but(node.right, first, second, box);
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      if (const std::uint32_t s = occluders_->order()[k]; s != first && s != second && surfaces_[s].meets(box))
        return true;
    return false;
  }

  const Occluders3* occluders_;
  std::vector<Box3> surfaces_, nodes_;
};

}  // namespace hottel
