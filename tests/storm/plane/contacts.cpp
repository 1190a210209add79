#include "tests/storm/plane/contacts.h"

#include <algorithm>
#include <utility>

namespace hottel::storm {

namespace {

struct Point {
  long x, y;
  auto operator<=>(const Point&) const = default;
};

long turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The ends, the smaller first.
std::pair<Point, Point> ends(const LatticeEdge& e) { return std::minmax(Point{e.ax, e.ay}, Point{e.bx, e.by}); }

bool is_on(const LatticeEdge& e, const Point& p) {
  const auto [a, b] = ends(e);
  return turn(a, b, p) == 0 && a <= p && p <= b;
}

bool has_end(const LatticeEdge& e, const Point& p) { return ends(e).first == p || ends(e).second == p; }

bool differ_in_sign(long a, long b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

bool cross(const LatticeEdge& e, const LatticeEdge& f) {
  const auto [a, b] = ends(e);
  const auto [c, d] = ends(f);
  return differ_in_sign(turn(a, b, c), turn(a, b, d)) && differ_in_sign(turn(c, d, a), turn(c, d, b));
}

Contact contact_on_one_line(const LatticeEdge& e, const LatticeEdge& f) {
  const auto [a, b] = ends(e);
  const auto [c, d] = ends(f);
  if (a == c && b == d) return Contact::kEqual;
  const Point low = std::max(a, c), high = std::min(b, d);
  if (high < low) return Contact::kCollinearApart;
  if (high == low) return Contact::kEndToEnd;
  const bool is_within = (low == a && high == b) || (low == c && high == d);
  return is_within ? Contact::kContained : Contact::kPartialOverlap;
}

// Do three edges that cross each other do so in one point?
bool meet_in_one_point(const LatticeEdge& e, const LatticeEdge& f, const LatticeEdge& g) {
  const auto [a, b] = ends(e);
  const auto [c, d] = ends(f);
  const auto [p, q] = ends(g);
  // The crossing of e and f divides cd as |s| : |t|; it lies on the line of g iff the turns of c and d from it do too.
  const long s = turn(a, b, c), t = turn(a, b, d);
  return turn(p, q, c) * t == turn(p, q, d) * s;
}

// Do some ends of the three lie on one line that is not the line of any two of the ends of one edge?
bool have_tips_on_one_line(const LatticeEdge& e, const LatticeEdge& f, const LatticeEdge& g) {
  const auto tips = [](const LatticeEdge& edge) { return std::array{ends(edge).first, ends(edge).second}; };
  for (const Point& p : tips(e))
    for (const Point& q : tips(f))
      for (const Point& r : tips(g)) {
        if (p == q || q == r || p == r || turn(p, q, r) != 0) continue;
        const auto lies_along = [&](const LatticeEdge& edge) {
          return turn(p, q, ends(edge).first) == 0 && turn(p, q, ends(edge).second) == 0;
        };
        if (!lies_along(e) && !lies_along(f) && !lies_along(g)) return true;
      }
  return false;
}

}  // namespace

const char* to_string(Contact contact) {
  static constexpr const char* kNames[kContactKinds] = {"apart",
                                                        "tips meet",
                                                        "T-junction",
                                                        "crossing",
                                                        "end to end",
                                                        "collinear apart",
                                                        "equal",
                                                        "partial overlap",
                                                        "contained",
                                                        "three through one point",
                                                        "three tips on one line",
                                                        "scenes with solids",
                                                        "with covered faces",
                                                        "with silent fronts",
                                                        "with rooms in solids",
                                                        "with solids behind"};
  return kNames[static_cast<std::size_t>(contact)];
}

Contact contact_of(const LatticeEdge& e, const LatticeEdge& f) {
  const auto [a, b] = ends(e);
  const auto [c, d] = ends(f);
  if (turn(a, b, c) == 0 && turn(a, b, d) == 0) return contact_on_one_line(e, f);
  if (has_end(e, c) || has_end(e, d)) return Contact::kTipsMeet;
  if (is_on(e, c) || is_on(e, d) || is_on(f, a) || is_on(f, b)) return Contact::kTJunction;
  return cross(e, f) ? Contact::kCrossing : Contact::kApart;
}

void count_contacts(const std::vector<LatticeEdge>& edges, ContactCounts& counts) {
  const auto add = [&](Contact contact) { ++counts[static_cast<std::size_t>(contact)]; };
  for (auto e = edges.begin(); e != edges.end(); ++e)
    for (auto f = std::next(e); f != edges.end(); ++f) {
      const Contact contact = contact_of(*e, *f);
      add(contact);
      for (auto g = std::next(f); g != edges.end(); ++g) {
        if (contact == Contact::kCrossing && cross(*e, *g) && cross(*f, *g) && meet_in_one_point(*e, *f, *g))
          add(Contact::kThreeThroughOnePoint);
        if (have_tips_on_one_line(*e, *f, *g)) add(Contact::kThreeTipsOnOneLine);
      }
    }
}

void count_solids(const LatticeScene& scene, ContactCounts& counts) {
  const auto add = [&](Contact contact, bool is_there) { counts[static_cast<std::size_t>(contact)] += is_there; };
  bool has_solid = false, has_covered_face = false;
  for (std::size_t p = 0; p < scene.split.pieces.size(); ++p)
    for (const bool left : {true, false}) {
      const oracle::Segment& piece = scene.split.pieces[p];
      if ((left ? piece.left : piece.right) != oracle::kCovered) continue;
      has_solid = true;
      for (const oracle::Lying& lying : scene.split.lying[p])
        has_covered_face |= lying.is_forwards != left || scene.edges[lying.edge].back_material >= 0;
    }
  add(Contact::kSolid, has_solid);
  add(Contact::kCoveredFace, has_covered_face);
  add(Contact::kSilentFront, scene.split.silent_fronts > 0);
  add(Contact::kRoomInSolid, scene.split.has_room);
  add(Contact::kSolidBehind, std::any_of(scene.edges.begin(), scene.edges.end(), [](const oracle::InputSegment& edge) {
        return edge.behind == oracle::Behind::kSolid;
      }));
}

}  // namespace hottel::storm
