#include "geometry/plane/arrangement/overlay.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/plane/arrangement/entangled.h"
#include "geometry/plane/arrangement/line_overlaps.h"
#include "geometry/plane/arrangement/point_index.h"
#include "kernel/kernels.h"

namespace hottel {
namespace {

// CGAL 5.5 does not survive intervals that leave the range of doubles. Constructions multiply at most six coordinates.
constexpr int kMostBitsForIntervals = 1020 / 6;

const Rational& to_rational(const Rational& value) { return value; }
const Rational& to_rational(const ExactKernel::FT& value) { return value.exact(); }

// Those that begin at one point on the left from the uppermost down: CGAL takes each into a list that it reads from
// below.
std::vector<std::uint32_t> top_down_at_left_ends(const Vertices2& vertices,
                                                 const std::vector<CoveredSegment2>& segments) {
  std::vector<Segment2> from_left;
  for (const CoveredSegment2& s : segments)
    from_left.push_back(vertices.precedes(s.segment.a, s.segment.b) ? s.segment : Segment2{s.segment.b, s.segment.a});
  std::vector<std::uint32_t> order(segments.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Segment2 &s = from_left[i], &t = from_left[j];
    return s.a != t.a ? s.a < t.a : vertices.orientation(s.a, s.b, t.b) < 0;
  });
  return order;
}

// The edges of the arrangement of segments that do not cover each other, by CGAL on the integer form of their ends;
// each with the sources of the segment it lies on.
template <class Kernel, class IdOf>
std::vector<CoveredSegment2> arrange(const Vertices2& vertices, const std::vector<CoveredSegment2>& segments,
                                     const IdOf& id_of) {
  using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
  using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, std::uint32_t>;
  using Arrangement = CGAL::Arrangement_2<Traits>;
  const auto to_point = [&vertices](VertexId i) {
    const Point2 p = vertices.exact(i);
    return typename Kernel::Point_2(typename Kernel::FT(p.x), typename Kernel::FT(p.y));
  };
  std::vector<typename Traits::Curve_2> curves;
  for (const std::uint32_t i : top_down_at_left_ends(vertices, segments)) {
    const Segment2& s = segments[i].segment;
    curves.emplace_back(typename SegmentTraits::Curve_2(to_point(s.a), to_point(s.b)), i);
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());

  const auto id_of_vertex = [&id_of](const typename Arrangement::Vertex_handle& v) {
    return id_of(Point2{to_rational(v->point().x()), to_rational(v->point().y())});
  };
  std::vector<CoveredSegment2> edges;
  for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge)
    edges.push_back({Segment2{id_of_vertex(edge->source()), id_of_vertex(edge->target())},
                     segments[*edge->curve().data().begin()].sources});
  return edges;
}

}  // namespace

void Overlay2::set_total_length() {
  double total = 0, extent = 0;
  for (const Segment2& piece : pieces) {
    const auto &p = vertices.approximate(piece.a), &q = vertices.approximate(piece.b);
    total += std::hypot(q.x - p.x, q.y - p.y);
    extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y)});
  }
  vertices.set_total_length(extent > 0 ? 1.01 * total / extent : 1);
}

Overlay2 overlay(const std::vector<Point2>& points, const std::vector<Segment2>& segments) {
  Overlay2 result;
  result.vertices = Vertices2(points, points.size());
  const EqualSegments2 equal(segments);
  std::vector<Segment2> distinct;
  for (std::size_t g = 0; g < equal.size(); ++g) distinct.push_back(segments[equal.members(g).front()]);
  const std::vector<char> entangled = find_entangled(result.vertices, distinct);

  result.source_begin.push_back(0);
  const auto add_piece = [&result](Segment2 piece, std::span<const std::uint32_t> sources) {
    result.pieces.push_back(piece);
    result.source_list.insert(result.source_list.end(), sources.begin(), sources.end());
    result.source_begin.push_back(static_cast<std::uint32_t>(result.source_list.size()));
  };
  std::vector<CoveredSegment2> found;  // the pieces that are no whole segment, or several
  std::vector<std::span<const std::uint32_t>> rest;
  for (std::size_t g = 0; g < equal.size(); ++g) {
    const auto sources = equal.members(g);
    if (entangled[g])
      rest.push_back(sources);
    else if (sources.size() == 1)
      add_piece(distinct[g], sources);
    else
      found.push_back({distinct[g], {sources.begin(), sources.end()}});
  }
  if (result.pieces.size() == segments.size()) return result;

  PointIndex2 index(points);
  if (!rest.empty()) {
    const std::vector<CoveredSegment2> uncovered = cut_along_lines(result.vertices, segments, rest);
    const auto id_of = [&](const Point2& p) { return index.insert(result.vertices.to_scene(p)); };
    std::vector<CoveredSegment2> arranged = result.vertices.exponent() <= kMostBitsForIntervals
                                                ? arrange<ExactKernel>(result.vertices, uncovered, id_of)
                                                : arrange<RationalKernel>(result.vertices, uncovered, id_of);
    std::move(arranged.begin(), arranged.end(), std::back_inserter(found));
  }
  if (index.points().size() > points.size()) result.vertices = Vertices2(index.points(), points.size());
  // One order for the pieces whatever CGAL's: by first source, then along it.
  const Vertices2& v = result.vertices;
  for (CoveredSegment2& f : found) {
    const Segment2& source = segments[f.sources.front()];
    if (v.precedes(f.segment.a, f.segment.b) != v.precedes(source.a, source.b)) std::swap(f.segment.a, f.segment.b);
  }
  std::sort(found.begin(), found.end(), [&](const CoveredSegment2& a, const CoveredSegment2& b) {
    if (a.sources.front() != b.sources.front()) return a.sources.front() < b.sources.front();
    if (a.segment.a == b.segment.a) return false;
    const Segment2& source = segments[a.sources.front()];
    return v.precedes(a.segment.a, b.segment.a) == v.precedes(source.a, source.b);
  });
  for (const CoveredSegment2& f : found) add_piece(f.segment, f.sources);
  return result;
}

}  // namespace hottel
