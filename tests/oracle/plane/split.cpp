#include "tests/oracle/plane/split.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace hottel::oracle {

namespace {

using Point = std::pair<mpq_class, mpq_class>;

mpq_class cross(const Point& o, const Point& a, const Point& b) {
  return (a.first - o.first) * (b.second - o.second) - (a.second - o.second) * (b.first - o.first);
}

mpq_class dot(const Point& o, const Point& a, const Point& b) {
  return (a.first - o.first) * (b.first - o.first) + (a.second - o.second) * (b.second - o.second);
}

// A point, exact and rounded.
struct End {
  Point p;
  double x, y;
};
struct Ends {
  End a, b;
};

Ends ends_of(const InputSegment& s) {
  return {{{s.ax, s.ay}, s.ax.get_d(), s.ay.get_d()}, {{s.bx, s.by}, s.bx.get_d(), s.by.get_d()}};
}

// The sign of cross(o, a, b), by doubles where their errors leave no doubt: each coordinate is off by at most 2^-52 of
// the largest, the differences by 2^-50, and the determinant by less than 2^-45 of the largest squared.
int side(const End& o, const End& a, const End& b) {
  const double guess = (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  const double largest =
      std::max({std::abs(o.x), std::abs(o.y), std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  const double doubt = std::ldexp(largest * largest, -45);
  if (guess > doubt) return 1;
  if (guess < -doubt) return -1;
  return sgn(cross(o.p, a.p, b.p));
}

// Adds where t touches s, as points of s.
void add_contacts(const Ends& s, const Ends& t, std::vector<Point>& contacts) {
  const int c_side = side(s.a, s.b, t.a), d_side = side(s.a, s.b, t.b);
  if (c_side * d_side > 0) return;
  const Point &a = s.a.p, &b = s.b.p, &c = t.a.p, &d = t.b.p;
  const auto add_if_inside = [&](const Point& p) {
    const mpq_class along = dot(a, b, p);
    if (along > 0 && along < dot(a, b, b)) contacts.push_back(p);
  };
  if (c_side == 0) add_if_inside(c);
  if (d_side == 0) add_if_inside(d);
  if (c_side * d_side == 0 || side(t.a, t.b, s.a) * side(t.a, t.b, s.b) >= 0) return;
  const mpq_class c_area = cross(a, b, c), share = c_area / (c_area - cross(a, b, d));
  contacts.emplace_back(c.first + share * (d.first - c.first), c.second + share * (d.second - c.second));
}

struct Claim {
  int label, material;
};

// The face that owns a side, from the faces on it in the order of the list; reports claimants that disagree.
int settle(const std::vector<Claim>& faces, const Point& a, const Point& b, std::vector<Conflict>& conflicts) {
  const Claim* owner = nullptr;
  for (const Claim& face : faces) {
    if (face.material < 0) continue;
    if (!owner) owner = &face;
    if (face.material == owner->material) continue;
    conflicts.push_back({owner->label, face.label, a.first, a.second, b.first, b.second});
    break;
  }
  return owner ? owner->label : faces.front().label;
}

// The claims on the pieces, once it is known what is solid.
class Settlement {
 public:
  Settlement(const std::vector<InputSegment>& edges, const Cut& cut, Split& result)
      : edges_(edges), pieces_(cut.pieces), regions_(cut.regions), result_(result), group_of_(edges.size()) {
    result.lying = cut.lying;
    if (!may_have_solids(edges)) return;
    has_solids_ = true;
    const Groups groups = groups_of(edges);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t k : groups[g]) group_of_[k] = g;
    if (regions_.all.empty()) regions_ = regions_of(pieces_);
    solids_ = solids_of(edges, regions_, result.lying);
    result.unbounded = solids_.unbounded;
    result.contradictions = solids_.contradictions;
    result.has_room = solids_.has_room;
  }

  void run() {
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const auto& [a, b] = pieces_[p];
      const int left = owner(p, true), right = owner(p, false);
      result_.pieces.push_back({a.first, a.second, b.first, b.second, left, right});
    }
  }

 private:
  // The groups that make solid what a side looks into.
  const std::set<std::size_t>& makers(std::size_t piece, bool left) const {
    static const std::set<std::size_t> none;
    return has_solids_ ? solids_.makers[left ? regions_.left[piece] : regions_.right[piece]] : none;
  }

  Claim face_on(const Lying& lying, bool left) const {
    const InputSegment& edge = edges_[lying.edge];
    return lying.is_forwards != left ? Claim{front_label(lying.edge), edge.front_material}
                                     : Claim{back_label(lying.edge), edge.back_material};
  }

  int owner(std::size_t piece, bool left) {
    if (!makers(piece, left).empty()) return kCovered;
    const std::vector<Lying>& lying = result_.lying[piece];
    const std::set<std::size_t>& behind = makers(piece, !left);
    const bool something_looks_in = !behind.empty() && std::any_of(lying.begin(), lying.end(), [&](const Lying& l) {
      return face_on(l, !left).material >= 0 && !is_part(l.edge, lying, behind);
    });
    std::vector<Claim> faces;
    for (const Lying& l : lying) {
      const Claim face = face_on(l, left);
      const std::vector<std::size_t> groups = groups_below(l.edge, lying);
      const bool is_silent = something_looks_in && face.label % 2 == 0 &&
                             std::ranges::any_of(groups, [&](std::size_t g) { return behind.contains(g); });
      if (is_silent)
        ++result_.silent_fronts;
      else if (!is_given_up(face, lying, left))
        faces.push_back(face);
    }
    const auto& [a, b] = pieces_[piece];
    return settle(faces, a, b, result_.conflicts);
  }

  // The groups of an edge and of what it lies on there as a patch on fronts, and so on.
  std::vector<std::size_t> groups_below(std::size_t edge, const std::vector<Lying>& lying) const {
    std::vector<std::size_t> groups{group_of_[edge]};
    for (const std::size_t base : edges_[edge].on)
      if (!edges_[edge].is_on_back && std::ranges::any_of(lying, [&](const Lying& l) { return l.edge == base; }))
        for (const std::size_t g : groups_below(base, lying)) groups.push_back(g);
    return groups;
  }

  // Whether an edge is a patch on one of some groups there, or on such a patch.
  bool is_part(std::size_t edge, const std::vector<Lying>& lying, const std::set<std::size_t>& groups) const {
    return std::ranges::any_of(edges_[edge].on, [&](std::size_t base) {
      const bool is_there = std::ranges::any_of(lying, [&](const Lying& l) { return l.edge == base; });
      return (is_there && groups.contains(group_of_[base])) || is_part(base, lying, groups);
    });
  }

  // Whether an edge is a patch on another one, or on such a patch.
  bool rests_on(std::size_t edge, std::size_t base) const {
    return std::ranges::any_of(edges_[edge].on,
                               [&](std::size_t other) { return other == base || rests_on(other, base); });
  }

  // The back of a patch that has none; what a patch there lies on, as it lies on it; what a patch there with a back
  // rests on.
  bool is_given_up(const Claim& face, const std::vector<Lying>& lying, bool left) const {
    const auto edge = static_cast<std::size_t>(face.label / 2);
    const bool is_back = face.label % 2 == 1;
    if (is_back && !edges_[edge].on.empty() && face.material < 0) return true;
    return std::ranges::any_of(lying, [&](const Lying& l) {
      const InputSegment& patch = edges_[l.edge];
      if (!rests_on(l.edge, edge)) return false;
      const Claim own = face_on(l, left);
      if (own.label % 2 == 1) return own.material >= 0;
      return std::ranges::find(patch.on, edge) != patch.on.end() && patch.is_on_back == is_back;
    });
  }

  const std::vector<InputSegment>& edges_;
  const std::vector<Stretch>& pieces_;
  Regions regions_;
  Split& result_;
  bool has_solids_ = false;
  std::vector<std::size_t> group_of_;  // of each edge
  Solids solids_;
};

}  // namespace

Cut cut(const std::vector<InputSegment>& edges) {
  std::map<std::pair<Point, Point>, std::vector<Lying>> pieces;
  std::vector<Ends> ends;
  for (const InputSegment& edge : edges) ends.push_back(ends_of(edge));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::vector<Point> points{ends[i].a.p, ends[i].b.p};
    for (std::size_t j = 0; j < edges.size(); ++j)
      if (j != i) add_contacts(ends[i], ends[j], points);
    const bool is_forwards = points[0] < points[1];
    std::sort(points.begin(), points.end());  // along the edge: the order of points is that of their projections
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (std::size_t k = 0; k + 1 < points.size(); ++k) pieces[{points[k], points[k + 1]}].push_back({i, is_forwards});
  }
  Cut result;
  for (const auto& [piece, lying] : pieces) {
    result.pieces.push_back({piece.first, piece.second});
    result.lying.push_back(lying);
  }
  if (may_have_solids(edges)) result.regions = regions_of(result.pieces);
  return result;
}

Split split(const std::vector<InputSegment>& edges, const Cut& cut) {
  Split result;
  Settlement(edges, cut, result).run();
  return result;
}

Split split(const std::vector<InputSegment>& edges) { return split(edges, cut(edges)); }

}  // namespace hottel::oracle
