#include "geometry/arrangement/overlay_2.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/arrangement/point_index_2.h"
#include "kernel/kernels.h"

namespace hottel {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Segment2*>;

// CGAL 5.5 does not survive intervals that leave the range of doubles. Constructions multiply at most six coordinates.
constexpr int kMostBitsForIntervals = 1020 / 6;

// Do the two segments meet in more than common end points?
bool are_entangled(const Vertices2& v, const Segment2& s, const Segment2& t) {
  const int ta = v.orientation(s.a, s.b, t.a), tb = v.orientation(s.a, s.b, t.b);
  if (ta * tb > 0) return false;
  const int sa = v.orientation(t.a, t.b, s.a), sb = v.orientation(t.a, t.b, s.b);
  if (sa * sb > 0) return false;
  if (ta * tb < 0 && sa * sb < 0) return true;
  if ((s.a == t.a && s.b == t.b) || (s.a == t.b && s.b == t.a)) return true;
  return (ta == 0 && v.is_between(s.a, s.b, t.a)) || (tb == 0 && v.is_between(s.a, s.b, t.b)) ||
         (sa == 0 && v.is_between(t.a, t.b, s.a)) || (sb == 0 && v.is_between(t.a, t.b, s.b));
}

std::vector<char> find_entangled(const Vertices2& vertices, const std::vector<Segment2>& segments) {
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (const Segment2& s : segments) {
    const auto &p = vertices.approximate(s.a), &q = vertices.approximate(s.b);
    const double error = vertices.approximation_error();
    const auto below = [error](double x) { return x - error; };
    const auto above = [error](double x) { return x + error; };
    double low[2] = {below(std::min(p.x, q.x)), below(std::min(p.y, q.y))};
    double high[2] = {above(std::max(p.x, q.x)), above(std::max(p.y, q.y))};
    boxes.emplace_back(low, high, &s);
  }
  std::vector<char> entangled(segments.size(), 0);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& one, const Box& two) {
    const auto i = static_cast<std::size_t>(one.handle() - segments.data());
    const auto j = static_cast<std::size_t>(two.handle() - segments.data());
    if (entangled[i] && entangled[j]) return;
    if (are_entangled(vertices, segments[i], segments[j])) entangled[i] = entangled[j] = 1;
  });
  return entangled;
}

const Rational& to_rational(const Rational& value) { return value; }
const Rational& to_rational(const ExactKernel::FT& value) { return value.exact(); }

struct ArrangedEdge {
  Segment2 piece;
  std::vector<std::uint32_t> sources;
};

// The edges of the arrangement of the entangled segments, by CGAL on the integer form of their ends.
template <class Kernel, class IdOf>
std::vector<ArrangedEdge> arrange(const Vertices2& vertices, const std::vector<Segment2>& segments,
                                  const std::vector<char>& entangled, const IdOf& id_of) {
  using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
  using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, std::uint32_t>;
  using Arrangement = CGAL::Arrangement_2<Traits>;
  const auto to_point = [&vertices](VertexId i) {
    const ExactPoint2 p = vertices.exact(i);
    return typename Kernel::Point_2(typename Kernel::FT(p.x), typename Kernel::FT(p.y));
  };
  std::vector<typename Traits::Curve_2> curves;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (entangled[i])
      curves.emplace_back(typename SegmentTraits::Curve_2(to_point(segments[i].a), to_point(segments[i].b)), i);
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());

  const auto id_of_vertex = [&id_of](const typename Arrangement::Vertex_handle& v) {
    return id_of(ExactPoint2{to_rational(v->point().x()), to_rational(v->point().y())});
  };
  std::vector<ArrangedEdge> edges;
  for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge) {
    edges.push_back(ArrangedEdge{Segment2{id_of_vertex(edge->source()), id_of_vertex(edge->target())}, {}});
    for (auto data = edge->curve().data().begin(); data != edge->curve().data().end(); ++data)
      edges.back().sources.push_back(*data);
    std::sort(edges.back().sources.begin(), edges.back().sources.end());
  }
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

Overlay2 overlay(const std::vector<ExactPoint2>& points, const std::vector<Segment2>& segments) {
  Overlay2 result;
  result.vertices = Vertices2(points, points.size());
  const std::vector<char> entangled = find_entangled(result.vertices, segments);

  result.source_begin.push_back(0);
  const auto add_piece = [&result](Segment2 piece) {
    result.pieces.push_back(piece);
    result.source_begin.push_back(static_cast<std::uint32_t>(result.source_list.size()));
  };
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (entangled[i]) continue;
    result.source_list.push_back(i);
    add_piece(segments[i]);
  }
  if (result.pieces.size() == segments.size()) return result;

  PointIndex2 index(points);
  const auto id_of = [&](const ExactPoint2& p) { return index.insert(result.vertices.to_scene(p)); };
  std::vector<ArrangedEdge> found = result.vertices.exponent() <= kMostBitsForIntervals
                                        ? arrange<ExactKernel>(result.vertices, segments, entangled, id_of)
                                        : arrange<RationalKernel>(result.vertices, segments, entangled, id_of);
  if (index.points().size() > points.size()) result.vertices = Vertices2(index.points(), points.size());
  // One order for the pieces whatever CGAL's: by first source, then along it.
  const Vertices2& v = result.vertices;
  for (ArrangedEdge& f : found) {
    const Segment2& source = segments[f.sources.front()];
    if (v.precedes(f.piece.a, f.piece.b) != v.precedes(source.a, source.b)) std::swap(f.piece.a, f.piece.b);
  }
  std::sort(found.begin(), found.end(), [&](const ArrangedEdge& a, const ArrangedEdge& b) {
    if (a.sources.front() != b.sources.front()) return a.sources.front() < b.sources.front();
    if (a.piece.a == b.piece.a) return false;
    const Segment2& source = segments[a.sources.front()];
    return v.precedes(a.piece.a, b.piece.a) == v.precedes(source.a, source.b);
  });
  for (const ArrangedEdge& f : found) {
    result.source_list.insert(result.source_list.end(), f.sources.begin(), f.sources.end());
    add_piece(f.piece);
  }
  return result;
}

}  // namespace hottel
