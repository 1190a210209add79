#include "geometry/plane/visibility/weak_visibility.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/visible_lines.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

class Sight {
 public:
  Sight(const PreparedScene2& prepared, const Face& from)
      : prepared_(prepared),
        arrangement_(prepared.arrangement),
        vertices_(arrangement_.vertices()),
        location_(vertices_, arrangement_.triangulation()),
        from_(from),
        places_(arrangement_.side_count()) {
    for (const PieceSideId side : arrangement_.sides())
      if (is_from(side)) {
        own_sides_.push_back(side);
        const Segment2& piece = arrangement_.piece(side);
        for (const VertexId end : {piece.a, piece.b}) {
          const auto same = std::find(ends_.begin(), ends_.end(), end);
          if (same == ends_.end())
            ends_.push_back(end);
          else
            ends_.erase(same);  // the run of pieces goes on
        }
      }
  }

  // Where the lines meet sides on which sight of the face may begin or end.
  void find_places() {
    std::mutex mutex;
    parallel_ranges(vertices_.size(), 16, [&](std::size_t begin, std::size_t end) {
      View2 view;
      std::vector<std::pair<PieceSideId, Rational>> found;
      for (std::size_t k = begin; k < end; ++k) {
        throw_if_interrupted();
        look_around(vertices_, arrangement_.triangulation(), VertexId(k), view);
        for_each_gap(vertices_, VertexId(k), view, true, [&](const Gap2& gap) { find_places_of(gap, found); });
      }
      const std::lock_guard lock(mutex);
      for (auto& [side, s] : found) places_[side.index()].push_back(std::move(s));
    });
  }

  // The seen stretches of a side, from the first end of its piece (0) to the second (1).
  std::vector<Stretch2> seen_on(PieceSideId side) {
    std::vector<Rational>& places = places_[side.index()];
    places.push_back(0);
    places.push_back(1);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<Stretch2> stretches;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Point2 middle = point_on(side, (places[k] + places[k + 1]) / 2);
      const bool is_seen = sees(middle, side, [this](PieceSideId behind) { return is_from(behind); });
      if (!is_seen) continue;
      if (!stretches.empty() && stretches.back().end == places[k])
        stretches.back().end = places[k + 1];
      else
        stretches.push_back({places[k], places[k + 1]});
    }
    return stretches;
  }

  bool is_from(PieceSideId side) const {
    return side != kSky && !arrangement_.is_covered(side) &&
           static_cast<const Face&>(arrangement_.owner(side)) == from_;
  }

  // A place s on the piece of a side as a place on the surface that owns it.
  Rational on_surface(PieceSideId side, const Rational& s) const {
    const Edge2& edge = prepared_.scene.edges[arrangement_.owner(side).surface];
    const Point2 p = vertices_.to_scene(point_on(side, s));
    return edge.from.x != edge.to.x ? Rational((p.x - edge.from.x) / (edge.to.x - edge.from.x))
                                    : Rational((p.y - edge.from.y) / (edge.to.y - edge.from.y));
  }

  // Between two critical points with respect to the sky all points of the face see it, or none.
  bool sees_sky() const {
    std::vector<Rational> places{0, 1};
    for (const CriticalPoint2& c : critical_points(arrangement_, prepared_.scene, from_, std::nullopt))
      places.push_back(c.t);
    for (const PieceSideId side : own_sides_)
      for (const int s : {0, 1}) places.push_back(on_surface(side, s));
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (places[k] == places[k + 1]) continue;
      const Point2 middle =
          vertices_.from_scene(point_at(prepared_.scene.edges[from_.surface], (places[k] + places[k + 1]) / 2));
      for (const PieceSideId side : own_sides_)
        if (holds(side, middle) && sees(middle, side, [](PieceSideId behind) { return behind == kSky; })) return true;
    }
    return false;
  }

 private:
  Point2 point_on(PieceSideId side, const Rational& s) const {
    const Segment2& piece = arrangement_.piece(side);
    const Point2 a = vertices_.exact(piece.a), b = vertices_.exact(piece.b);
    return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  }

  bool holds(PieceSideId side, const Point2& p) const {
    const Segment2& piece = arrangement_.piece(side);
    const Point2 a = vertices_.exact(piece.a), b = vertices_.exact(piece.b);
    return (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < 0;
  }

  // A limit of sight passes two vertices between the face and the side, or one and an end of the face, or lies along
  // the face.
  void find_places_of(const Gap2& gap, std::vector<std::pair<PieceSideId, Rational>>& found) const {
    const std::array<PieceSideId, 4> sides{gap.behind_left, gap.behind_right, gap.ahead_left, gap.ahead_right};
    const bool is_limit = std::any_of(sides.begin(), sides.end(), [this](PieceSideId side) { return is_from(side); }) ||
                          std::any_of(ends_.begin(), ends_.end(),
                                      [&](VertexId end) { return vertices_.orientation(gap.v, gap.w, end) == 0; });
    if (!is_limit) return;
    const Point2 v = vertices_.exact(gap.v), w = vertices_.exact(gap.w);
    const Rational dx = w.x - v.x, dy = w.y - v.y;
    for (const PieceSideId side : sides) {
      if (side == kSky || arrangement_.is_covered(side)) continue;
      const Segment2& piece = arrangement_.piece(side);
      const Point2 a = vertices_.exact(piece.a), b = vertices_.exact(piece.b);
      const Rational turn = dx * (b.y - a.y) - dy * (b.x - a.x);
      if (turn == 0) continue;
      const Rational s = (dx * (v.y - a.y) - dy * (v.x - a.x)) / turn;
      if (s > 0 && s < 1) found.emplace_back(side, s);
    }
  }

  // Whether a point inside a piece, in integer form, sees something before a side of it under an angle.
  template <class Is>
  bool sees(const Point2& point, PieceSideId side, const Is& is_it) const {
    const Segment2 piece = arrangement_.turned_piece(side);  // the side is its right one
    const Eye2 eye(vertices_, point);
    thread_local View2 view;
    location_.look_around(eye, view);
    const std::size_t m = view.seen.size();
    for (std::size_t k = 0; k < m; ++k) {
      if (!is_it(view.seen[k].behind)) continue;
      const VertexId right = view.seen[k].vertex, left = view.seen[k + 1 == m ? 0 : k + 1].vertex;
      const int at_right = vertices_.orientation(piece.a, piece.b, right),
                at_left = vertices_.orientation(piece.a, piece.b, left);
      if (at_right < 0 || at_left < 0) return true;
      // From one end of the line to the other: before the side where it begins at the piece's first end.
      if (at_right == 0 && at_left == 0 && eye.direction_sign(right, piece.a) > 0) return true;
    }
    return false;
  }

  const PreparedScene2& prepared_;
  const Arrangement2& arrangement_;
  const Vertices2& vertices_;
  const PointLocation2 location_;
  const Face from_;
  std::vector<PieceSideId> own_sides_;         // of the face
  std::vector<VertexId> ends_;                 // of the runs of pieces that the face has
  std::vector<std::vector<Rational>> places_;  // by side
};

// Ascending, united where one ends as the next begins.
SeenFace2 united(const Face& face, std::vector<Stretch2> stretches) {
  std::sort(stretches.begin(), stretches.end(), [](const auto& p, const auto& q) { return p.begin < q.begin; });
  SeenFace2 result{face, {}, 0};
  for (Stretch2& stretch : stretches) {
    result.share += stretch.end - stretch.begin;
    if (!result.stretches.empty() && result.stretches.back().end == stretch.begin)
      result.stretches.back().end = std::move(stretch.end);
    else
      result.stretches.push_back(std::move(stretch));
  }
  return result;
}

}  // namespace

WeakVisibility2 weak_visibility(const PreparedScene2& prepared, const Face& from,
                                const std::function<void(double)>& progress) {
  const Arrangement2& arrangement = prepared.arrangement;
  Sight sight(prepared, from);
  sight.find_places();
  std::vector<std::vector<Stretch2>> by_side(arrangement.side_count());
  std::atomic<std::size_t> done{0};
  parallel_ranges(by_side.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      throw_if_interrupted();
      const PieceSideId side(k);
      if (arrangement.is_covered(side) || sight.is_from(side)) continue;
      for (const Stretch2& s : sight.seen_on(side)) {
        Rational first = sight.on_surface(side, s.begin), second = sight.on_surface(side, s.end);
        if (second < first) std::swap(first, second);
        by_side[k].push_back({std::move(first), std::move(second)});
      }
    }
    const std::size_t so_far = done += end - begin;
    if (progress) progress(static_cast<double>(so_far) / static_cast<double>(by_side.size()));
  });
  std::vector<std::vector<Stretch2>> by_face(2 * prepared.scene.surfaces.size());
  for (const PieceSideId side : arrangement.sides())
    for (Stretch2& stretch : by_side[side.index()])
      by_face[arrangement.owner(side).number()].push_back(std::move(stretch));
  WeakVisibility2 result;
  for (std::uint32_t number = 0; number < by_face.size(); ++number)
    if (!by_face[number].empty()) result.faces.push_back(united(Face::of(number), std::move(by_face[number])));
  result.sees_sky = sight.sees_sky();
  return result;
}

}  // namespace hottel
