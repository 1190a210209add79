// The polygons of a scene, prepared for looking at them from many points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/predicates/vertices.h"
#include "geometry/space/scene/polygon.h"

namespace hottel {

using EdgeId3 = Id<struct EdgeTag3>;

// An edge with a direction: forward from the vertex with the smaller number to the other one.
struct DirectedEdge3 {
  EdgeId3 edge;
  bool is_backward = false;
};

// Polygons that hide each other, whole and as listed; polygon s is surface s.
//
//   (1) points with equal coordinates are one vertex, and two polygons that share two neighbouring vertices share
//       the edge; both are numbered in the order in which they first occur
//   (2) corners at which an outline is straight are left out
//   (3) side_of() and the exact vectors are exact, whatever the coordinates
//   (4) a tree of boxes has every polygon in one leaf; its shape depends on the polygons alone
//
// REQUIRES: every polygon is plane, convex, of at least three points in order (counter-clockwise seen from its front)
// that are not all on one line.
// Throws ContractViolation where a polygon has no three points that span a plane.
// COST: O(n log n); 5 to 15 microseconds a polygon.
class Occluders3 {
 public:
  explicit Occluders3(const std::vector<Polygon3>& polygons);
  // The same of polygons whose corners are vertices that are known.
  Occluders3(Vertices3 vertices, const std::vector<std::vector<VertexId3>>& outlines);

  std::size_t size() const { return normals_.size(); }
  const Vertices3& vertices() const { return vertices_; }

  // The corners of a polygon in order, and the edges that begin there.
  std::span<const VertexId3> outline(std::size_t s) const { return part(corners_, s); }
  std::span<const DirectedEdge3> edges(std::size_t s) const { return part(sides_, s); }

  struct Edge {
    VertexId3 from, to;    // from < to
    BoundedVector vector;  // to - from in integer form, times a power of two
  };
  std::size_t edge_count() const { return edges_.size(); }
  const Edge& edge(EdgeId3 e) const { return edges_[e.index()]; }
  IntegerVector exact_vector(EdgeId3 e) const;

  // Normals point to the side that the front faces.
  const BoundedVector& normal(std::size_t s) const { return normals_[s]; }
  const IntegerVector& exact_normal(std::size_t s) const { return exact_normals_[s]; }

  // Where a vertex lies of the plane of a polygon: +1 before its front, -1 behind, 0 on it; `tier` says how it was
  // settled.
  int side_of(VertexId3 v, std::size_t s, SignTier& tier) const;

  // A node of the tree. Its polygons are order()[begin, end); children stand behind their parent, none where left is 0.
  struct Node {
    std::uint32_t begin, end;
    std::uint32_t left = 0, right = 0;
  };
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  template <class T>
  std::span<const T> part(const std::vector<T>& all, std::size_t s) const {
    return {all.data() + first_[s], first_[s + 1] - first_[s]};
  }
  void add_outlines(const std::vector<std::vector<VertexId3>>& outlines);
  void add_edges();
  void add_tree();

  Vertices3 vertices_;
  std::vector<std::size_t> first_{0};  // of polygon s in corners_ and sides_
  std::vector<VertexId3> corners_;
  std::vector<DirectedEdge3> sides_;
  std::vector<Edge> edges_;
  std::vector<BoundedVector> normals_;
  std::vector<IntegerVector> exact_normals_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

// Returns the normal of a side of one of the polygons, of any length.
Vector3 normal_of_side_3(const Occluders3& occluders, const Face& side);

}  // namespace hottel
