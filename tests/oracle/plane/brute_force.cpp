#include "tests/oracle/plane/brute_force.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hottel::oracle {

namespace {

using Index = std::size_t;

// Twice the signed area of the triangle a, b, c: positive if c lies left of the line from a to b.
template <class Number>
Number turn(const std::pair<Number, Number>& a, const std::pair<Number, Number>& b,
            const std::pair<Number, Number>& c) {
  return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

// The distinct end points of the segments, and orientation tests on them.
class Points {
 public:
  explicit Points(const std::vector<Segment>& segments) {
    std::map<std::pair<mpq_class, mpq_class>, Index> known;
    const auto add = [&](const mpq_class& x, const mpq_class& y) {
      const auto [place, is_new] = known.try_emplace({x, y}, exact_.size());
      if (is_new) exact_.push_back({x, y});
      return place->second;
    };
    for (const Segment& s : segments) {
      const Index a = add(s.ax, s.ay);
      ends_.emplace_back(a, add(s.bx, s.by));
    }
    double largest = 0;
    for (const auto& [x, y] : exact_) {
      rounded_.push_back({x.get_d(), y.get_d()});
      largest = std::max({largest, std::abs(x.get_d()), std::abs(y.get_d())});
    }
    // Each coordinate is off by at most 2^-52 of the largest: differences by 2^-50, and the determinant by less than
    // 2^-45 of the largest squared.
    doubt_ = std::ldexp(largest * largest, -45);
  }

  Index count() const { return exact_.size(); }
  std::pair<Index, Index> ends(Index segment) const { return ends_[segment]; }

  // 1 if c lies left of the line from a to b, -1 right, 0 on it.
  int side(Index a, Index b, Index c) const {
    const double guess = turn(rounded_[a], rounded_[b], rounded_[c]);
    if (guess > doubt_) return 1;
    if (guess < -doubt_) return -1;
    return sgn(turn(exact_[a], exact_[b], exact_[c]));
  }

  // True iff b lies ahead of a in the direction from `from` to `to`, for points on one line.
  bool is_ahead(Index from, Index to, Index a, Index b) const {
    const auto& p = exact_[from];
    const auto& q = exact_[to];
    const auto& r = exact_[a];
    const auto& s = exact_[b];
    return (q.first - p.first) * (s.first - r.first) + (q.second - p.second) * (s.second - r.second) > 0;
  }

  mpq_class squared_distance(Index a, Index b) const {
    const mpq_class x = exact_[a].first - exact_[b].first, y = exact_[a].second - exact_[b].second;
    return x * x + y * y;
  }

  bool is_inside(Index segment, Index v) const {
    const auto [a, b] = ends_[segment];
    return v != a && v != b && side(a, b, v) == 0 && is_ahead(a, b, a, v) && is_ahead(a, b, v, b);
  }

 private:
  std::vector<std::pair<mpq_class, mpq_class>> exact_;
  std::vector<std::pair<double, double>> rounded_;
  std::vector<std::pair<Index, Index>> ends_;
  double doubt_ = 0;
};

// A segment that starts at a vertex (or, at a T-junction, half of one that passes through it), up to its far end.
struct Spoke {
  Index segment, far;
};

enum Side { kRight = 0, kLeft = 1 };

// One line through vertices, with what it meets.
class Line {
 public:
  Line(const std::vector<Segment>& segments, const Points& points, const std::vector<std::vector<Spoke>>& spokes,
       std::vector<int> sides, std::vector<Index> vertices, Index from, Index to)
      : segments_(segments),
        points_(points),
        spokes_(spokes),
        sides_(std::move(sides)),
        vertices_(std::move(vertices)) {
    std::sort(vertices_.begin(), vertices_.end(),
              [&](Index a, Index b) { return a != b && points_.is_ahead(from, to, a, b); });
    crossings_.resize(vertices_.size() + 1);
    for (Index s = 0; s < segments_.size(); ++s) find_crossing(s);
  }

  void visit_gaps(const std::function<void(const Gap&)>& visit) const {
    for (Index k = 0; k + 1 < vertices_.size(); ++k)
      if (crossings_[k + 1].empty()) visit_gap(k, visit);
  }

 private:
  int height(Index vertex) const { return sides_[vertex]; }

  // Puts a segment that crosses the line between vertices into the stretch where it does: 0 is before the first vertex.
  void find_crossing(Index s) {
    const auto [a, b] = points_.ends(s);
    if (height(a) * height(b) >= 0) return;
    const auto [above, below] = height(a) > 0 ? std::pair(a, b) : std::pair(b, a);
    Index stretch = 0;
    for (; stretch < vertices_.size(); ++stretch) {
      const int place = points_.side(above, below, vertices_[stretch]);  // 1: ahead of the crossing
      if (place == 0) return;  // the segment passes through the vertex: a spoke
      if (place > 0) break;
    }
    crossings_[stretch].push_back(s);
  }

  // Of two segments that cross the same stretch, is s met before t (forwards)?
  bool is_before(Index s, Index t) const {
    const auto upright = [&](Index segment) {
      const auto [a, b] = points_.ends(segment);
      return height(a) > 0 ? std::pair(a, b) : std::pair(b, a);
    };
    const auto [p, q] = upright(s);
    const auto [v, w] = upright(t);
    const int v_side = points_.side(p, q, v), w_side = points_.side(p, q, w);
    if (v_side * w_side >= 0) return v_side + w_side > 0;  // t lies wholly ahead of (or behind) the line of s
    return points_.side(v, w, p) + points_.side(v, w, q) < 0;
  }

  // The label that a traveller meets on a segment which does not lie along the line.
  int face_met(Index s, bool forwards) const {
    const auto [a, b] = points_.ends(s);
    return (height(b) > height(a)) == forwards ? segments_[s].left : segments_[s].right;
  }

  // The label first met from a stretch when every vertex is left on side `side`, so is passed on the other side.
  int shoot(Index stretch, bool forwards, Side side) const {
    for (;;) {
      const std::vector<Index>& crossing = crossings_[stretch];
      if (!crossing.empty()) {
        const auto first = [&](Index s, Index t) { return forwards ? is_before(s, t) : is_before(t, s); };
        return face_met(*std::min_element(crossing.begin(), crossing.end(), first), forwards);
      }
      if (stretch == (forwards ? vertices_.size() : 0)) return kInfinity;
      const Index vertex = vertices_[forwards ? stretch : stretch - 1];
      const int passed = side == kLeft ? -1 : 1;
      const Spoke* nearest = nullptr;
      for (const Spoke& spoke : spokes_[vertex]) {
        if (height(spoke.far) != passed) continue;
        // met first: the one that leans towards the traveller
        const bool turns_left = nearest && points_.side(vertex, nearest->far, spoke.far) > 0;
        if (!nearest || turns_left == (forwards == (passed > 0))) nearest = &spoke;
      }
      if (nearest) return face_met(nearest->segment, forwards);
      stretch = forwards ? stretch + 1 : stretch - 1;
    }
  }

  // The segment that lies along the line over the gap from vertex k, or none.
  const Segment* cover(Index k, bool& runs_forwards) const {
    for (Index s = 0; s < segments_.size(); ++s) {
      const auto [a, b] = points_.ends(s);
      if (height(a) != 0 || height(b) != 0) continue;
      const auto place = [&](Index v) {
        return static_cast<Index>(std::find(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
      };
      const Index i = place(a), j = place(b);
      if (std::min(i, j) > k || std::max(i, j) <= k) continue;
      runs_forwards = i < j;
      return &segments_[s];
    }
    return nullptr;
  }

  void visit_gap(Index k, const std::function<void(const Gap&)>& visit) const {
    const int a_left = shoot(k + 1, false, kLeft), a_right = shoot(k + 1, false, kRight);
    const int b_left = shoot(k + 1, true, kLeft), b_right = shoot(k + 1, true, kRight);
    bool runs_forwards = true;
    const Segment* cover_segment = cover(k, runs_forwards);
    if (!cover_segment && (a_left == a_right || b_left == b_right)) return;  // the terms cancel
    Gap gap{points_.squared_distance(vertices_[k], vertices_[k + 1]), cover_segment != nullptr, 0, 0, {}};
    gap.terms = {{a_left, b_left, -1}, {a_right, b_right, -1}};
    if (!cover_segment) {
      gap.terms.push_back({a_left, b_right, 1});
      gap.terms.push_back({a_right, b_left, 1});
    } else {
      gap.left = runs_forwards ? cover_segment->left : cover_segment->right;
      gap.right = runs_forwards ? cover_segment->right : cover_segment->left;
      gap.terms.push_back({a_left, gap.right, 1});
      gap.terms.push_back({gap.left, b_right, 1});
      gap.terms.push_back({a_right, gap.left, 1});
      gap.terms.push_back({gap.right, b_left, 1});
    }
    visit(gap);
  }

  const std::vector<Segment>& segments_;
  const Points& points_;
  const std::vector<std::vector<Spoke>>& spokes_;
  std::vector<int> sides_;       // of every vertex of the scene
  std::vector<Index> vertices_;  // those on the line, in its direction
  std::vector<std::vector<Index>> crossings_;
};

std::vector<std::vector<Spoke>> find_spokes(Index segment_count, const Points& points) {
  std::vector<std::vector<Spoke>> spokes(points.count());
  for (Index s = 0; s < segment_count; ++s) {
    const auto [a, b] = points.ends(s);
    spokes[a].push_back({s, b});
    spokes[b].push_back({s, a});
    for (Index v = 0; v < points.count(); ++v) {
      if (!points.is_inside(s, v)) continue;
      spokes[v].push_back({s, a});
      spokes[v].push_back({s, b});
    }
  }
  return spokes;
}

}  // namespace

void for_each_gap(const std::vector<Segment>& segments, const std::function<void(const Gap&)>& visit) {
  const Points points(segments);
  const std::vector<std::vector<Spoke>> spokes = find_spokes(segments.size(), points);
  std::vector<int> sides(points.count());
  for (Index i = 0; i < points.count(); ++i) {
    for (Index j = i + 1; j < points.count(); ++j) {
      std::vector<Index> vertices;
      bool is_known = false;  // the line was met with the two first of its vertices
      for (Index v = 0; v < points.count() && !is_known; ++v) {
        sides[v] = v == i || v == j ? 0 : points.side(i, j, v);
        if (sides[v] == 0) vertices.push_back(v);
        is_known = sides[v] == 0 && v < j && v != i;
      }
      if (!is_known) Line(segments, points, spokes, sides, std::move(vertices), i, j).visit_gaps(visit);
    }
  }
}

Measures exchange_measures(const std::vector<Segment>& segments) {
  Measures measures;
  for_each_gap(segments, [&](const Gap& gap) {
    for (const auto& [f, g, sign] : gap.terms) {
      if (f == kInfinity && g == kInfinity) continue;
      LengthSum& sum = measures[std::minmax({f, g})];
      long& coefficient = sum[gap.squared_length];
      coefficient += f == g ? 2 * sign : sign;
      if (coefficient == 0) sum.erase(gap.squared_length);
    }
  });
  std::erase_if(measures, [](const auto& entry) { return entry.second.empty(); });
  return measures;
}

ExactSum exact_sum(const LengthSum& lengths) {
  ExactSum sum;
  for (const auto& [squared_length, coefficient] : lengths) sum.add(coefficient, squared_length);
  return sum;
}

std::map<ElementPair, ExactSum> exact_measures(const std::vector<Segment>& segments) {
  std::map<ElementPair, ExactSum> result;
  for (const auto& [pair, lengths] : exchange_measures(segments)) {
    ExactSum sum = exact_sum(lengths);
    if (!sum.terms().empty()) result.emplace(pair, std::move(sum));
  }
  return result;
}

}  // namespace hottel::oracle
