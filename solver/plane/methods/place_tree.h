// The vertices of a scene in a tree of boxes: those before a line, or near one, without looking at all others.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solver/plane/methods/element_geometry.h"

namespace hottel {

// An upright box in local units.
struct LocalBox2 {
  LocalVector2 middle, half;  // half its width and height

  // The reach of the box along a direction, to both sides of its middle.
  double reach(const LocalVector2& along) const;
};

// The places of the vertices of an ElementGeometry2, in boxes that are halved along their longer side.
//
// A box is left out only if it is farther off than kSlack, which is more than its numbers are rounded by: what is
// visited are all vertices that are asked for and some others, which the caller tells apart.
//
//   (1) a vertex is visited at most once; visiting stops at the first false
//   (2) without vertices nothing is visited, and the answer is true
class PlaceTree2 {
 public:
  static constexpr double kSlack = 0x1p-40;  // coordinates are below 1
  using Visit = std::function<bool(VertexId)>;

  // The first `vertices` vertices of the geometry, which need not outlive this. COST: O(n log n); 32 bytes a
  // box, 4 a vertex.
  PlaceTree2(const ElementGeometry2& geometry, std::size_t vertices);

  // Visits the vertices that do not lie behind the line of a run, until visit returns false. Returns false if it did.
  // COST: that of the boxes that the line cuts, O(sqrt n) or so, and of what is visited.
  bool visit_before(const ElementRun2& run, const Visit& visit) const;

  // The same for the vertices within a distance of a segment; for all of them where the segment is a point.
  bool visit_near(const LocalPoint2& from, const LocalVector2& along, double distance, const Visit& visit) const;

 private:
  using Enters = std::function<bool(const LocalBox2&)>;
  static constexpr std::size_t kLeaf = 8;  // vertices, at most

  void build(const ElementGeometry2& geometry, std::size_t node, std::size_t begin, std::size_t end);
  bool visit(std::size_t node, std::size_t begin, std::size_t end, const Enters& enters, const Visit& visit) const;

  std::vector<VertexId> order_;
  std::vector<LocalBox2> boxes_;  // by node: the halves of node k are 2 k + 1 and 2 k + 2
};

}  // namespace hottel
