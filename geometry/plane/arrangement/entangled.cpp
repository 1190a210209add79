#include "geometry/plane/arrangement/entangled.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "geometry/plane/arrangement/meeting_boxes.h"

namespace hottel {
namespace {

// Do the two segments meet in more than common end points? REQUIRES that they do not have the same two ends.
bool are_entangled(const Vertices2& v, const Segment2& s, const Segment2& t) {
  const int ta = v.orientation(s.a, s.b, t.a), tb = v.orientation(s.a, s.b, t.b);
  if (ta * tb > 0) return false;
  const int sa = v.orientation(t.a, t.b, s.a), sb = v.orientation(t.a, t.b, s.b);
  if (sa * sb > 0) return false;
  if (ta * tb < 0 && sa * sb < 0) return true;
  return (ta == 0 && v.is_between(s.a, s.b, t.a)) || (tb == 0 && v.is_between(s.a, s.b, t.b)) ||
         (sa == 0 && v.is_between(t.a, t.b, s.a)) || (sb == 0 && v.is_between(t.a, t.b, s.b));
}

NumberedBox2 box_of(const Vertices2& vertices, const Segment2& segment, std::uint32_t number) {
  const auto &p = vertices.approximate(segment.a), &q = vertices.approximate(segment.b);
  const double error = vertices.approximation_error();
  return {{std::min(p.x, q.x) - error, std::min(p.y, q.y) - error},
          {std::max(p.x, q.x) + error, std::max(p.y, q.y) + error},
          number};
}

// The line of a sweep from left to right, upwards where that is no order: the lexicographic order of points.
class Sweep {
 public:
  Sweep(const Vertices2& vertices, const std::vector<Segment2>& segments)
      : vertices_(vertices),
        segments_(segments),
        rank_(vertices.size()),
        place_(segments.size()),
        found_(segments.size(), 0),
        line_(Below{this}) {}

  std::vector<char> run() {
    const std::vector<VertexId> order = lexicographic_order();
    for (std::uint32_t k = 0; k < order.size(); ++k) rank_[order[k].index()] = k;
    for (Segment2& s : segments_)
      if (rank(s.b) < rank(s.a)) std::swap(s.a, s.b);

    const std::vector<std::uint32_t> begins = sorted_by([](const Segment2& s) { return s.a; });
    const std::vector<std::uint32_t> ends = sorted_by([](const Segment2& s) { return s.b; });
    auto begin = begins.begin(), end = ends.begin();
    for (const VertexId v : order) {
      for (; end != ends.end() && segments_[*end].b == v; ++end)
        if (place_[*end]) remove(*end);
      for (; begin != begins.end() && segments_[*begin].a == v; ++begin) insert(*begin);
    }
    return std::move(found_);
  }

 private:
  // Of two segments on the line, or one that is there and one that begins: which is lower. Neither where they are
  // entangled at the point where the later one begins.
  struct Below {
    const Sweep* sweep;
    bool operator()(std::uint32_t s, std::uint32_t t) const { return sweep->height(s, t) > 0; }
  };
  using Line = std::set<std::uint32_t, Below>;

  std::uint32_t rank(VertexId v) const { return rank_[v.index()]; }

  // +1 when t is above s, -1 when it is below.
  int height(std::uint32_t s, std::uint32_t t) const {
    const Segment2 &f = segments_[s], &g = segments_[t];
    if (f.a == g.a) return vertices_.orientation(f.a, f.b, g.b);
    return rank(f.a) < rank(g.a) ? vertices_.orientation(f.a, f.b, g.a) : -vertices_.orientation(g.a, g.b, f.a);
  }

  // Approximate coordinates ascend with the exact ones, so that only where they are equal these are asked.
  std::vector<VertexId> lexicographic_order() const {
    std::vector<std::pair<double, VertexId>> by_x;
    by_x.reserve(vertices_.size());
    for (const VertexId v : vertices_.ids()) by_x.emplace_back(vertices_.approximate(v).x, v);
    std::sort(by_x.begin(), by_x.end(), [&](const auto& i, const auto& j) {
      return i.first != j.first ? i.first < j.first : vertices_.precedes(i.second, j.second);
    });
    std::vector<VertexId> order;
    order.reserve(by_x.size());
    for (const auto& [x, v] : by_x) order.push_back(v);
    return order;
  }

  template <class End>
  std::vector<std::uint32_t> sorted_by(const End& end) const {
    std::vector<std::uint32_t> order(segments_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t s, std::uint32_t t) { return rank(end(segments_[s])) < rank(end(segments_[t])); });
    return order;
  }

  void insert(std::uint32_t s) {
    const auto [place, is_new] = line_.insert(s);
    if (!is_new) {
      found_[s] = found_[*place] = 1;
      remove(*place);
      return;
    }
    place_[s] = place;
    if (place != line_.begin()) part(std::prev(place), place);
    if (place_[s] && std::next(place) != line_.end()) part(place, std::next(place));
  }

  void remove(std::uint32_t s) {
    const auto above = line_.erase(*place_[s]);
    place_[s].reset();
    if (above != line_.end() && above != line_.begin()) part(std::prev(above), above);
  }

  // Takes two neighbours away if they are entangled, and those who become neighbours thereby.
  void part(Line::iterator lower, Line::iterator upper) {
    while (are_entangled(vertices_, segments_[*lower], segments_[*upper])) {
      for (const auto gone : {lower, upper}) {
        found_[*gone] = 1;
        place_[*gone].reset();
      }
      upper = line_.erase(lower, std::next(upper));
      if (upper == line_.begin() || upper == line_.end()) return;
      lower = std::prev(upper);
    }
  }

  const Vertices2& vertices_;
  std::vector<Segment2> segments_;   // from left to right
  std::vector<std::uint32_t> rank_;  // of vertices
  std::vector<std::optional<Line::iterator>> place_;
  std::vector<char> found_;
  Line line_;  // from below
};

}  // namespace

std::vector<char> entangled_neighbours(const Vertices2& vertices, const std::vector<Segment2>& segments) {
  return Sweep(vertices, segments).run();
}

std::vector<char> find_entangled(const Vertices2& vertices, const std::vector<Segment2>& segments) {
  std::vector<char> entangled = entangled_neighbours(vertices, segments);
  std::vector<NumberedBox2> known, others;
  for (std::uint32_t s = 0; s < segments.size(); ++s)
    (entangled[s] ? known : others).push_back(box_of(vertices, segments[s], s));
  if (known.empty()) return entangled;
  for_each_meeting(known, others, [&](std::uint32_t one, std::uint32_t two) {
    if (entangled[two] == 0 && are_entangled(vertices, segments[one], segments[two])) entangled[two] = 1;
  });
  return entangled;
}

}  // namespace hottel
