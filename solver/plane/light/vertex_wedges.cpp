#include "solver/plane/light/vertex_wedges.h"

namespace hottel {
namespace {

// A ray turns about the vertex once. It meets the vertices seen (events of the ray itself) and, with its opposite end,
// the same ones again.
class TurningRay {
 public:
  TurningRay(const Vertices2& vertices, VertexId v, const View2& view, std::vector<Wedge2>& wedges)
      : vertices_(vertices), v_(v), seen_(view.seen), m_(view.seen.size()), wedges_(wedges) {
    quadrant_.resize(m_);
    for (std::size_t k = 0; k < m_; ++k) quadrant_[k] = quadrant(seen_[k].vertex);
    first_ = 0;
    while (first_ + 1 < m_ && !begins_turn(first_)) ++first_;
    lower_half_ = 0;
    for (const int q : quadrant_) lower_half_ += q >= 2 ? 1u : 0u;
    measure_to_incident();
  }

  void run() {
    for (std::uint32_t q = 0; q < 4; ++q) {
      VertexRay2 start = VertexRay2::axis(q);
      Wedge2 sight = current();
      for (;;) {
        const bool has_seen = ahead_ < m_ && quadrant_[at(ahead_)] == static_cast<int>(q);
        const bool has_opposite = behind_ < m_ && (quadrant_[at(opposite(behind_))] + 2) % 4 == static_cast<int>(q);
        if (!has_seen && !has_opposite) break;
        VertexRay2 event;
        if (has_seen && (!has_opposite || vertices_.orientation(v_, vertex(ahead_), vertex(opposite(behind_))) <= 0))
          event = VertexRay2::towards(vertex(ahead_++));
        else
          event = VertexRay2::away_from(vertex(opposite(behind_++)));
        const Wedge2 next = current();
        if (same_sight(sight, next)) continue;
        emit(sight, start, event);
        start = event;
        sight = next;
      }
      emit(sight, start, VertexRay2::axis(q + 1));
    }
  }

 private:
  std::size_t at(std::size_t place) const { return first_ + place < m_ ? first_ + place : first_ + place - m_; }
  VertexId vertex(std::size_t place) const { return seen_[at(place)].vertex; }
  // The k-th vertex that the opposite end meets: those in the lower half plane first.
  std::size_t opposite(std::size_t k) const {
    const std::size_t upper_half = m_ - lower_half_;
    return k < lower_half_ ? upper_half + k : k - lower_half_;
  }

  int quadrant(VertexId w) const {
    const int x = vertices_.compare_x(w, v_), y = vertices_.compare_y(w, v_);
    if (y > 0) return x > 0 ? 0 : 1;
    if (y < 0) return x < 0 ? 2 : 3;
    return x > 0 ? 0 : 2;
  }
  bool begins_turn(std::size_t k) const {
    const std::size_t before = k == 0 ? m_ - 1 : k - 1;
    if (quadrant_[k] != quadrant_[before]) return quadrant_[k] < quadrant_[before];
    return vertices_.orientation(v_, seen_[before].vertex, seen_[k].vertex) <= 0;
  }

  // Steps from each place back (forward) to the nearest vertex at the end of a piece that starts at v.
  void measure_to_incident() {
    steps_back_.assign(m_, m_);
    steps_forward_.assign(m_, m_);
    for (std::size_t turn = 0, back = m_, forward = m_; turn < 2 * m_; ++turn) {
      const std::size_t up = turn % m_, down = m_ - 1 - up;
      back = seen_[at(up)].left != kNoPiece ? 0 : back + 1;
      forward = seen_[at(down)].left != kNoPiece ? 0 : forward + 1;
      steps_back_[up] = back;
      steps_forward_[down] = forward;
    }
  }

  // What holds between the last event and the next one.
  Wedge2 current() const {
    const std::size_t last = ahead_ == 0 ? m_ - 1 : ahead_ - 1, next = ahead_ == m_ ? 0 : ahead_;
    const std::size_t on_right = ahead_ + lower_half_ - behind_;  // vertices less than half a turn clockwise
    const PieceSideId beyond = seen_[at(opposite(behind_ == 0 ? m_ - 1 : behind_ - 1))].behind;
    Wedge2 sight{{}, {}, seen_[at(last)].behind, beyond, beyond};
    if (steps_back_[last] < on_right) sight.seen_left = seen_[at(wrapped(last + m_ - steps_back_[last]))].left;
    if (steps_forward_[next] < m_ - on_right) sight.seen_right = seen_[at(wrapped(next + steps_forward_[next]))].right;
    return sight;
  }
  std::size_t wrapped(std::size_t place) const { return place < m_ ? place : place - m_; }

  bool is_along(const VertexRay2& axis, VertexId w) const {
    return axis.index % 2 == 0 ? vertices_.compare_y(w, v_) == 0 : vertices_.compare_x(w, v_) == 0;
  }
  // REQUIRES two rays of one quadrant.
  bool same_direction(const VertexRay2& a, const VertexRay2& b) const {
    if (b.kind == VertexRay2::Kind::kAxis) return false;  // the axis that ends the quadrant
    if (a.kind == VertexRay2::Kind::kAxis) return is_along(a, b.vertex());
    return vertices_.orientation(v_, a.vertex(), b.vertex()) == 0;
  }
  void emit(Wedge2 sight, const VertexRay2& right, const VertexRay2& left) {
    if (same_direction(right, left)) return;
    sight.right = right;
    sight.left = left;
    wedges_.push_back(sight);
  }

  const Vertices2& vertices_;
  const VertexId v_;
  const std::vector<View2::Seen>& seen_;
  const std::size_t m_;
  std::vector<Wedge2>& wedges_;
  std::vector<int> quadrant_;
  std::size_t first_ = 0;               // seen first from the x axis on; places count from there
  std::size_t lower_half_ = 0;          // vertices in quadrants 2 and 3
  std::size_t ahead_ = 0, behind_ = 0;  // events of either end so far
  std::vector<std::size_t> steps_back_, steps_forward_;
};

}  // namespace

void append_wedges(const Vertices2& vertices, VertexId v, const View2& view, std::vector<Wedge2>& wedges) {
  if (!view.seen.empty()) TurningRay(vertices, v, view, wedges).run();
}

}  // namespace hottel
