// Segments laid over each other: crossings, T-junctions and overlaps resolved, with history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/segment.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Pieces with pairwise disjoint interiors, and for each piece the input segments that cover it.
//
//   (1) every input segment is the union of the pieces that name it as a source
//   (2) two pieces meet in common end points only; every vertex on a piece is one of its ends
//   (3) the first points of `vertices` are the input points, in their order; points constructed by crossings follow
//   (4) a piece that has one source points the same way as it
struct Overlay2 {
  Vertices2 vertices;
  std::vector<Segment2> pieces;

  std::span<const std::uint32_t> sources(std::size_t piece) const {
    return {source_list.data() + source_begin[piece], source_list.data() + source_begin[piece + 1]};
  }

  // Makes room for the sum of the lengths of all pieces in fixed point (Vertices2::set_total_length). To be called
  // before any length is measured.
  void set_total_length();

  std::vector<std::uint32_t> source_begin;  // one more than pieces
  std::vector<std::uint32_t> source_list;   // ascending within a piece
};

// Returns the pieces of the segments, which are given by the numbers of their end points.
//
//   (1) segments that equal each other in their two ends make pieces together, with all of them as sources
//   (2) exact, whatever the coordinates: no point is moved or merged
//
// REQUIRES: distinct points, and segments that are not points.
// COST: O(n log n) for segments that equal others, or touch them in end points only; the others go through CGAL's
// arrangement over exact rationals: O((n + k) log n) with a larger constant, for k crossings and sources of pieces.
Overlay2 overlay(const std::vector<Point2>& points, const std::vector<Segment2>& segments);

}  // namespace hottel
