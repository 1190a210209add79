#include "geometry/arrangement/overlay_2.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>

#include "geometry/arrangement/point_index_2.h"
#include "kernel/kernels.h"

namespace hottel {
namespace {

using Traits = CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<ExactKernel>, std::uint32_t>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Segment2*>;

Rational to_rational(const ExactKernel::FT& value) { return CGAL::exact(value); }

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
  std::vector<Traits::Curve_2> curves;
  // CGAL works on the integer form, which its interval filters like best, scaled down where its exponents would take
  // intervals beyond the range of double (CGAL 5.5 does not survive that).
  const int shift = result.vertices.exponent() > 400 ? result.vertices.exponent() : 0;
  const auto to_point = [&result, shift](VertexId i) {
    ExactPoint2 p = result.vertices.exact(i);
    if (shift > 0) p = {scaled_by_power_of_two(p.x, -shift), scaled_by_power_of_two(p.y, -shift)};
    return ExactKernel::Point_2(ExactKernel::FT(p.x), ExactKernel::FT(p.y));
  };
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (entangled[i]) {
      const ExactKernel::Segment_2 segment(to_point(segments[i].a), to_point(segments[i].b));
      curves.emplace_back(CGAL::Arr_segment_traits_2<ExactKernel>::Curve_2(segment), i);
    } else {
      result.source_list.push_back(i);
      add_piece(segments[i]);
    }
  }
  if (curves.empty()) return result;

  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  PointIndex2 index(points);
  const auto id_of = [&](const Arrangement::Vertex_handle& v) {
    const Rational x = scaled_by_power_of_two(to_rational(v->point().x()), shift);
    const Rational y = scaled_by_power_of_two(to_rational(v->point().y()), shift);
    return index.insert(result.vertices.to_scene({x, y}));
  };
  struct Found {
    Segment2 piece;
    std::vector<std::uint32_t> sources;
  };
  std::vector<Found> found;
  for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge) {
    Found f{{id_of(edge->source()), id_of(edge->target())}, {}};
    for (auto data = edge->curve().data().begin(); data != edge->curve().data().end(); ++data)
      f.sources.push_back(*data);
    std::sort(f.sources.begin(), f.sources.end());
    found.push_back(std::move(f));
  }
  if (index.points().size() > points.size()) result.vertices = Vertices2(index.points(), points.size());
  // One order for the pieces whatever CGAL's: by first source, then along it.
  const Vertices2& v = result.vertices;
  for (Found& f : found) {
    const Segment2& source = segments[f.sources.front()];
    if (v.precedes(f.piece.a, f.piece.b) != v.precedes(source.a, source.b)) std::swap(f.piece.a, f.piece.b);
  }
  std::sort(found.begin(), found.end(), [&](const Found& a, const Found& b) {
    if (a.sources.front() != b.sources.front()) return a.sources.front() < b.sources.front();
    if (a.piece.a == b.piece.a) return false;
    const Segment2& source = segments[a.sources.front()];
    return v.precedes(a.piece.a, b.piece.a) == v.precedes(source.a, source.b);
  });
  for (const Found& f : found) {
    result.source_list.insert(result.source_list.end(), f.sources.begin(), f.sources.end());
    add_piece(f.piece);
  }
  return result;
}

}  // namespace hottel
