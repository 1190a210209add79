// Lines through two vertices that see each other: the corners of the regions of line space
// (docs/design/plane/exchange.md).
#pragma once

#include "geometry/plane/visibility/view.h"

namespace hottel {

// The open segment between two consecutive vertices v, w of a line, crossed by no piece, and what the line meets first
// beyond both ends after it was moved a little: behind_left is met behind v when v and all vertices behind it are left
// strictly on the left of the moved line, and so on. kSky where it meets nothing.
struct Gap2 {
  VertexId v, w;
  PieceSideId behind_left, behind_right;
  PieceSideId ahead_left, ahead_right;
  PieceSideId covered_left, covered_right;  // sides of the piece that lies on the gap; kNoPiece if it is free
};

// Calls visit(const Gap2&) for every gap that starts at v, once for each unordered pair when `each_once` (that is, only
// with w > v), where view is the view from v. Points is Vertices2, or anything else that has an orientation(i, j, k).
//
//   (1) every gap of the scene is visited from each of its two ends, once from one of them when `each_once`
//   (2) lines through three or more vertices have a gap between each two that follow each other and see each other
//   (3) with exact orientations all that is told of a gap is exact
//   (4) gaps are visited in the order of the view: counter-clockwise by w, one for each vertex seen
// REQUIRES the view from v. COST: at most two orientations for each visible vertex.
template <class Points, class Visit>
void for_each_gap(const Points& points, VertexId v, const View2& view, bool each_once, const Visit& visit) {
  const auto& seen = view.seen;
  const std::size_t m = seen.size();
  thread_local std::vector<std::size_t> incident;  // vertices joined to v by a piece
  incident.clear();
  for (std::size_t k = 0; k < m; ++k)
    if (seen[k].left != kNoPiece) incident.push_back(k);
  std::size_t passed = 0;  // how many of them come up to vertex k

  const auto eye = eye_at(points, v);
  const auto wrapped = [m](std::size_t k) { return k < m ? k : k - m; };
  // last = k + number of vertices seen at an angle in (0, pi) counter-clockwise from vertex k
  std::size_t last = 0;
  for (std::size_t k = 0; k < m; ++k) {
    if (last < k) last = k;
    bool has_opposite = false;  // a vertex is seen exactly opposite to vertex k
    const auto ray = eye.ray(seen[k].vertex);
    while (last + 1 < k + m) {
      const int turn = eye.orientation(ray, eye.ray(seen[wrapped(last + 1)].vertex));
      if (turn <= 0) {
        has_opposite = turn == 0;
        break;
      }
      ++last;
    }
    if (each_once && seen[k].vertex < v) continue;

    Gap2 gap{v,
             seen[k].vertex,
             kSky,
             kSky,
             seen[k == 0 ? m - 1 : k - 1].behind,
             seen[k].behind,
             seen[k].left,
             seen[k].right};
    gap.behind_right = seen[wrapped(last)].behind;
    gap.behind_left = has_opposite ? seen[wrapped(last + 1)].behind : gap.behind_right;
    // Pieces at v that lie strictly on one side of the line hide what is behind v on that side; the one nearest to the
    // gap is met first.
    while (passed < incident.size() && incident[passed] <= k) ++passed;
    if (!incident.empty()) {
      const auto turn_to = [m, k](std::size_t i) { return i >= k ? i - k : i + m - k; };
      const std::size_t on_left = last - k, before = passed - (seen[k].left == kNoPiece ? 0 : 1);
      const std::size_t next = incident[passed < incident.size() ? passed : 0];
      const std::size_t previous = incident[(before > 0 ? before : incident.size()) - 1];
      if (turn_to(next) > 0 && turn_to(next) <= on_left) gap.behind_right = seen[next].right;
      if (turn_to(previous) > on_left + (has_opposite ? 1 : 0)) gap.behind_left = seen[previous].left;
    }
    visit(gap);
  }
}

}  // namespace hottel
