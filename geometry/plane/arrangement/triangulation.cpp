#include "geometry/plane/arrangement/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

#include "geometry/plane/arrangement/hilbert_order.h"

namespace hottel {
namespace {

// What CGAL's triangulation asks of a geometry, answered by our own predicates on vertex numbers: the triangulation is
// exact whatever the size of the coordinates, and rests on the same signs as everything after it. Segment_2 and
// Triangle_2 are required as names only.
struct VertexTraits {
  const Vertices2* vertices = nullptr;

  struct Point_2 {
    VertexId id{0};
  };
  using Segment_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Segment_2;
  using Triangle_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Triangle_2;

  struct Predicate {
    const Vertices2* vertices;
  };
  struct Orientation_2 : Predicate {
    using result_type = CGAL::Orientation;
    CGAL::Orientation operator()(Point_2 p, Point_2 q, Point_2 r) const {
      return CGAL::enum_cast<CGAL::Orientation>(vertices->orientation(p.id, q.id, r.id));
    }
  };
  struct Side_of_oriented_circle_2 : Predicate {
    using result_type = CGAL::Oriented_side;
    CGAL::Oriented_side operator()(Point_2 p, Point_2 q, Point_2 r, Point_2 s) const {
      return CGAL::enum_cast<CGAL::Oriented_side>(vertices->side_of_circle(p.id, q.id, r.id, s.id));
    }
  };
  struct Compare_x_2 : Predicate {
    using result_type = CGAL::Comparison_result;
    CGAL::Comparison_result operator()(Point_2 p, Point_2 q) const {
      return CGAL::enum_cast<CGAL::Comparison_result>(vertices->compare_x(p.id, q.id));
    }
  };
  struct Compare_y_2 : Predicate {
    using result_type = CGAL::Comparison_result;
    CGAL::Comparison_result operator()(Point_2 p, Point_2 q) const {
      return CGAL::enum_cast<CGAL::Comparison_result>(vertices->compare_y(p.id, q.id));
    }
  };
  struct Construct_point_2 {
    Point_2 operator()(Point_2 p) const { return p; }
  };

  Orientation_2 orientation_2_object() const { return {{vertices}}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {{vertices}}; }
  Compare_x_2 compare_x_2_object() const { return {{vertices}}; }
  Compare_y_2 compare_y_2_object() const { return {{vertices}}; }
  Construct_point_2 construct_point_2_object() const { return {}; }
};

using VertexBase = CGAL::Triangulation_vertex_base_2<VertexTraits>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<VertexTraits,
                                                CGAL::Triangulation_face_base_with_info_2<TriangleId, VertexTraits>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<VertexTraits, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;

// Finds the piece between two vertices.
class PieceBetween {
 public:
  PieceBetween(const std::vector<Segment2>& pieces, std::size_t vertices) : pieces_(pieces), begin_(vertices + 1, 0) {
    for (const Segment2& piece : pieces) ++begin_[low(piece) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    by_low_.resize(pieces.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t p = 0; p < pieces.size(); ++p) by_low_[next[low(pieces[p])]++] = {high(pieces[p]), p};
    for (std::size_t v = 0; v < vertices; ++v) std::sort(by_low_.begin() + begin_[v], by_low_.begin() + begin_[v + 1]);
  }
  // The side of the piece u-v that faces the left of u -> v; kNoPiece if there is no such piece.
  PieceSideId side_facing_left(VertexId u, VertexId v) const {
    const Segment2 wanted{u, v};
    const auto end = by_low_.begin() + begin_[low(wanted) + 1];
    const auto place =
        std::lower_bound(by_low_.begin() + begin_[low(wanted)], end, std::pair(high(wanted), std::uint32_t{0}));
    if (place == end || place->first != high(wanted)) return kNoPiece;
    return pieces_[place->second].a == u ? left_side(place->second) : right_side(place->second);
  }

 private:
  static std::uint32_t low(const Segment2& s) { return static_cast<std::uint32_t>(std::min(s.a, s.b).index()); }
  static std::uint32_t high(const Segment2& s) { return static_cast<std::uint32_t>(std::max(s.a, s.b).index()); }

  const std::vector<Segment2>& pieces_;
  std::vector<std::uint32_t> begin_;                             // by the lower end: where its pieces begin
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_low_;  // higher end and number of each piece
};

StarEntry2 star_entry(VertexId neighbour, HalfEdgeId beyond, PieceSideId left) {
  return {neighbour, beyond, left, left == kNoPiece ? kNoPiece : opposite(left)};
}

// Along a curve, but in rounds that double, drawn by number: where vertices lie on a convex outline, neighbours that
// follow each other would each be joined to all before them and cost O(n²). (Amenta, Choi, Rote, Incremental
// constructions con BRIO, 2003.)
std::vector<VertexId> insertion_order(const std::vector<VertexId>& along_curve) {
  constexpr int kRounds = 32;
  const auto round_of = [](VertexId v) {
    return kRounds - 1 -
           std::countr_zero((v.index() + 1) * 0x9E3779B97F4A7C15u >> 32 | std::uint64_t{1} << (kRounds - 1));
  };
  std::array<std::vector<VertexId>, kRounds> rounds;
  for (const VertexId v : along_curve) rounds[static_cast<std::size_t>(round_of(v))].push_back(v);
  std::vector<VertexId> order;
  order.reserve(along_curve.size());
  for (const auto& round : rounds) order.insert(order.end(), round.begin(), round.end());
  return order;
}

// Makes the edge u-v a constraint. CGAL looks for it among all neighbours of the first end; where these are many, it is
// told the end that has fewer. In a planar graph the sum over all edges of the smaller degree is linear (Chiba,
// Nishizeki 1985), however many meet at one vertex.
void insert_constraint(Cdt& cdt, Cdt::Vertex_handle u, Cdt::Vertex_handle v) {
  constexpr int kFew = 64;
  auto around_u = cdt.incident_faces(u), around_v = cdt.incident_faces(v);
  const auto first_u = around_u, first_v = around_v;
  bool has_fewer_at_v = false;
  for (int k = 0; ++around_u != first_u; ++k)
    if (k >= kFew && (has_fewer_at_v = ++around_v == first_v)) break;
  if (has_fewer_at_v) std::swap(u, v);
  cdt.insert_constraint(u, v);
}

}  // namespace

Triangulation2::Triangulation2(const Vertices2& vertices, const std::vector<Segment2>& pieces) {
  const std::size_t count = vertices.size();
  const PieceBetween piece_between(pieces, count);
  star_begin_.assign(count + 1, 0);
  sweep_order_ = hilbert_order(vertices);

  // CGAL looks for its way among all points while they lie on one line: many of them wait for one that does not.
  constexpr std::ptrdiff_t kFew = 64;
  std::vector<VertexId> order = insertion_order(sweep_order_);
  const auto off_line = std::find_if(order.begin(), order.end(), [&](VertexId v) {
    return order.size() > 2 && vertices.orientation(order[0], order[1], v) != 0;
  });
  const bool is_line = off_line == order.end();
  if (!is_line && off_line - order.begin() > kFew) std::rotate(order.begin() + 2, off_line, off_line + 1);

  Cdt cdt(VertexTraits{&vertices});
  std::vector<Cdt::Vertex_handle> handle(count);
  Cdt::Face_handle hint;
  if (is_line) {
    std::sort(order.begin(), order.end(), [&](VertexId i, VertexId j) { return vertices.precedes(i, j); });
    std::vector<std::vector<StarEntry2>> stars(count);
    const auto join = [&](VertexId v, VertexId neighbour) {
      const PieceSideId left = piece_between.side_facing_left(v, neighbour);
      stars[v.index()].push_back(star_entry(neighbour, HalfEdgeId::none(), left));
    };
    for (std::size_t k = 1; k < order.size(); ++k) {
      join(order[k], order[k - 1]);
      join(order[k - 1], order[k]);
    }
    for (std::size_t v = 0; v < count; ++v) {
      star_.insert(star_.end(), stars[v].begin(), stars[v].end());
      star_begin_[v + 1] = static_cast<std::uint32_t>(star_.size());
    }
    return;
  }

  for (const VertexId v : order) {
    handle[v.index()] = cdt.insert(VertexTraits::Point_2{v}, hint);
    hint = handle[v.index()]->face();
  }
  for (const Segment2& piece : pieces) insert_constraint(cdt, handle[piece.a.index()], handle[piece.b.index()]);

  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) face->info() = TriangleId::none();
  TriangleId next(0);
  for (const VertexId v : sweep_order_) {
    auto face = cdt.incident_faces(handle[v.index()]);
    const auto first = face;
    do {
      if (cdt.is_infinite(face) || !face->info().is_none()) continue;
      face->info() = next;
      ++next;
    } while (++face != first);
  }
  passages_.assign(3 * next.index(), {VertexId(0), Beyond2(kSky), Beyond2(kSky)});
  across_.assign(passages_.size(), HalfEdgeId::none());
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face)
    for (int i = 0; i < 3; ++i) {
      const HalfEdgeId h = half_edge(face->info(), i);
      passages_[h.index()].corner = face->vertex(i)->point().id;
      const auto neighbour = face->neighbor(i);
      if (!cdt.is_infinite(neighbour)) across_[h.index()] = half_edge(neighbour->info(), neighbour->index(face));
      Beyond2 beyond(kSky);
      if (face->is_constrained(i))
        beyond = Beyond2(piece_between.side_facing_left(face->vertex(Cdt::ccw(i))->point().id,
                                                        face->vertex(Cdt::cw(i))->point().id));
      else if (!across(h).is_none())
        beyond = Beyond2(across(h));
      passages_[next_half_edge(h).index()].on_left = beyond;
      passages_[previous_half_edge(h).index()].on_right = beyond;
    }

  // What stands on the edge opposite corner k, as the inside of a triangle sees it, or of the outside of the hull.
  const auto side_seen_from = [&](Cdt::Face_handle face, int k) {
    if (!face->is_constrained(k)) return kNoPiece;
    if (!cdt.is_infinite(face)) return side(half_edge(face->info(), k));
    const auto inside = face->neighbor(k);
    return opposite(side(half_edge(inside->info(), inside->index(face))));
  };
  star_.reserve(6 * count);
  for (const VertexId v : vertices.ids()) {
    const Cdt::Vertex_handle here = handle[v.index()];
    auto face = cdt.incident_faces(here);
    const auto first = face;
    do {
      const int i = face->index(here);
      const auto neighbour = face->vertex(Cdt::ccw(i));
      if (!cdt.is_infinite(neighbour))
        star_.push_back(star_entry(neighbour->point().id,
                                   cdt.is_infinite(face) ? HalfEdgeId::none() : half_edge(face->info(), i),
                                   side_seen_from(face, Cdt::cw(i))));
    } while (++face != first);
    star_begin_[v.index() + 1] = static_cast<std::uint32_t>(star_.size());
  }
}

}  // namespace hottel
