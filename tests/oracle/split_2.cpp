#include "tests/oracle/split_2.h"

#include <algorithm>
#include <map>
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

Point start(const InputSegment& s) { return {s.ax, s.ay}; }
Point end(const InputSegment& s) { return {s.bx, s.by}; }

// Adds where t touches s, as points of s.
void add_contacts(const InputSegment& s, const InputSegment& t, std::vector<Point>& contacts) {
  const Point a = start(s), b = end(s), c = start(t), d = end(t);
  const mpq_class c_side = cross(a, b, c), d_side = cross(a, b, d);
  const mpq_class length = dot(a, b, b);
  const auto add_if_inside = [&](const Point& p) {
    const mpq_class along = dot(a, b, p);
    if (along > 0 && along < length) contacts.push_back(p);
  };
  if (c_side == 0) add_if_inside(c);
  if (d_side == 0) add_if_inside(d);
  if (sgn(c_side) * sgn(d_side) >= 0) return;
  const mpq_class share = c_side / (c_side - d_side);
  const Point p{c.first + share * (d.first - c.first), c.second + share * (d.second - c.second)};
  add_if_inside(p);
}

struct Covering {
  std::size_t edge;
  bool is_forwards;  // runs like the piece, from the smaller point to the larger
};

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

}  // namespace

Split split(const std::vector<InputSegment>& edges) {
  std::map<std::pair<Point, Point>, std::vector<Covering>> pieces;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::vector<Point> points{start(edges[i]), end(edges[i])};
    for (std::size_t j = 0; j < edges.size(); ++j)
      if (j != i) add_contacts(edges[i], edges[j], points);
    const bool is_forwards = points[0] < points[1];
    std::sort(points.begin(), points.end());  // along the edge: the order of points is that of their projections
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (std::size_t k = 0; k + 1 < points.size(); ++k) pieces[{points[k], points[k + 1]}].push_back({i, is_forwards});
  }

  Split result;
  for (const auto& [ends, coverings] : pieces) {
    std::vector<Claim> left, right;
    for (const auto& [edge, is_forwards] : coverings) {
      const Claim front{front_label(edge), edges[edge].front_material};
      const Claim back{back_label(edge), edges[edge].back_material};
      right.push_back(is_forwards ? front : back);
      left.push_back(is_forwards ? back : front);
    }
    const auto& [a, b] = ends;
    result.pieces.push_back({a.first, a.second, b.first, b.second, settle(left, a, b, result.conflicts),
                             settle(right, a, b, result.conflicts)});
  }
  return result;
}

}  // namespace hottel::oracle
