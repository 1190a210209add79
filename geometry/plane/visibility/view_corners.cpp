#include "geometry/plane/visibility/view_corners.h"

namespace hottel {
namespace {

using Kind = ViewCorner2::Kind;

class CornerList {
 public:
  CornerList(const Arrangement2& arrangement, const Eye2& eye, std::vector<ViewCorner2>& corners)
      : arrangement_(arrangement), eye_(eye), corners_(corners) {
    corners_.clear();
  }

  // Where the ray to a vertex meets what is seen beside it.
  ViewCorner2 corner(VertexId vertex, PieceSideId side, PieceSideId after) const {
    if (side == kSky) return {Kind::kVertex, vertex, kNoPiece, after};
    const Segment2& piece = arrangement_.piece(side);
    if (vertex == piece.a || vertex == piece.b) return {Kind::kVertex, vertex, kNoPiece, after};
    return {Kind::kBehind, vertex, side, after};
  }

  void begin_part(VertexId right, PieceSideId side) {
    const ViewCorner2 from = corner(right, side, side);
    if (!corners_.empty() && is_same_place(corners_.back(), from))
      corners_.back().after = side;
    else
      corners_.push_back(from);
  }
  void end_part(VertexId left, PieceSideId side) {
    const ViewCorner2 to = corner(left, side, kNoPiece);
    if (!is_same_place(corners_.back(), to)) corners_.push_back(to);
  }
  void add_eye() { corners_.push_back({Kind::kEye, VertexId(0), kNoPiece, kNoPiece}); }

  void close() {
    while (corners_.size() > 1 && is_same_place(corners_.front(), corners_.back())) corners_.pop_back();
  }

 private:
  // Of neighbours in the list, and of the last and the first one: they lie on one ray, or are different points.
  bool is_same_place(const ViewCorner2& p, const ViewCorner2& q) const {
    if (p.kind != q.kind || p.vertex != q.vertex) return false;
    if (p.kind != Kind::kBehind) return true;
    const Segment2 &a = arrangement_.piece(p.on), &b = arrangement_.piece(q.on);
    if (piece_of(p.on) == piece_of(q.on)) return true;
    // Pieces meet in common ends only.
    for (const VertexId end : {a.a, a.b})
      if ((end == b.a || end == b.b) && eye_.orientation(p.vertex, end) == 0) return true;
    return false;
  }

  const Arrangement2& arrangement_;
  const Eye2& eye_;
  std::vector<ViewCorner2>& corners_;
};

}  // namespace

void view_corners(const Arrangement2& arrangement, const Eye2& eye, const View2& view,
                  std::vector<ViewCorner2>& corners) {
  CornerList list(arrangement, eye, corners);
  const auto& seen = view.seen;
  const std::size_t m = seen.size();
  const auto wrapped = [m](std::size_t k) { return k < m ? k : k - m; };
  const bool has_solids = !arrangement.solids().is_empty();
  const auto is_solid = [&](std::size_t k) {
    const PieceSideId side = seen[wrapped(k)].behind;
    return has_solids && side != kSky && arrangement.is_covered(side);
  };
  for (std::size_t k = 0; k < m; ++k) {
    if (is_solid(k)) continue;
    const VertexId left = seen[wrapped(k + 1)].vertex;
    list.begin_part(seen[k].vertex, seen[k].behind);
    list.end_part(left, seen[k].behind);
    if (!is_solid(k + 1)) continue;
    std::size_t next = k + 1;
    while (is_solid(next)) ++next;
    const VertexId right = seen[wrapped(next)].vertex;
    if (eye.orientation(left, right) != 0 || eye.direction_sign(left, right) > 0) list.add_eye();
  }
  list.close();
}

}  // namespace hottel
