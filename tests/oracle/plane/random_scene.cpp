#include "tests/oracle/plane/random_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace hottel::oracle {

namespace {

struct Node {
  long x, y;
  bool operator==(const Node&) const = default;
};

struct Stroke {
  Node a, b;
};

class Pen {
 public:
  Pen(std::uint64_t seed, bool lattice) : random_(seed * 2 + (lattice ? 1 : 0)) {}

  // A number in [low, high]; the library's distributions differ between platforms.
  long number(long low, long high) {
    return low + static_cast<long>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int percent) { return number(0, 99) < percent; }
  const Stroke& any(const std::vector<Stroke>& strokes) {
    return strokes[static_cast<std::size_t>(number(0, static_cast<long>(strokes.size()) - 1))];
  }

 private:
  std::mt19937_64 random_;
};

std::vector<Stroke> room(long size) {
  return {{{0, 0}, {0, size}}, {{0, size}, {size, size}}, {{size, size}, {size, 0}}, {{size, 0}, {0, 0}}};
}

bool is_inside(const Node& p, long size) { return p.x >= 0 && p.y >= 0 && p.x <= size && p.y <= size; }

Stroke lattice_stroke(Pen& pen, const std::vector<Stroke>& drawn, long size) {
  const long reach = std::max(2L, size / 2);
  Stroke s{{pen.number(0, size), pen.number(0, size)}, {}};
  const auto go_on = [&] { s.b = {s.a.x + pen.number(-reach, reach), s.a.y + pen.number(-reach, reach)}; };
  go_on();
  if (drawn.empty()) return s;
  const Stroke old = pen.any(drawn);
  const long dx = old.b.x - old.a.x, dy = old.b.y - old.a.y, steps = std::gcd(dx, dy);
  const auto on_old = [&](long k) { return Node{old.a.x + k * (dx / steps), old.a.y + k * (dy / steps)}; };
  switch (pen.number(0, 9)) {
    case 0:  // along an old one: beside it on its line, overlapping, within, or the same; either way round
      s = {on_old(pen.number(-1, steps)), on_old(pen.number(0, steps + 1))};
      break;
    case 1:  // from a lattice point of an old one, often inside it
    case 2:
      s.a = on_old(pen.number(0, steps));
      go_on();
      break;
    case 3:  // from tip to tip
      s = {old.b, pen.any(drawn).a};
      break;
    default:
      break;
  }
  return s;
}

long turn(const Node& o, const Node& a, const Node& b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

int sign(long value) { return (value > 0) - (value < 0); }

bool lies_on(const Stroke& s, const Node& p) {
  return turn(s.a, s.b, p) == 0 && std::min(s.a.x, s.b.x) <= p.x && p.x <= std::max(s.a.x, s.b.x) &&
         std::min(s.a.y, s.b.y) <= p.y && p.y <= std::max(s.a.y, s.b.y);
}

// Do the strokes meet elsewhere than in a common end?
bool clash(const Stroke& s, const Stroke& t) {
  const auto is_end = [](const Stroke& u, const Node& p) { return p == u.a || p == u.b; };
  const auto touches = [&](const Stroke& u, const Node& p) { return lies_on(u, p) && !is_end(u, p); };
  if (touches(s, t.a) || touches(s, t.b) || touches(t, s.a) || touches(t, s.b)) return true;
  if (is_end(s, t.a) && is_end(s, t.b)) return true;
  return sign(turn(s.a, s.b, t.a)) * sign(turn(s.a, s.b, t.b)) < 0 &&
         sign(turn(t.a, t.b, s.a)) * sign(turn(t.a, t.b, s.b)) < 0;
}

Stroke free_stroke(Pen& pen, const std::vector<Stroke>& drawn, long size, long reach) {
  Stroke s{{pen.number(0, size), pen.number(0, size)}, {}};
  if (!drawn.empty() && pen.chance(40)) s.a = pen.any(drawn).b;
  s.b = {s.a.x + pen.number(-reach, reach), s.a.y + pen.number(-reach, reach)};
  return s;
}

std::vector<Stroke> draw(Pen& pen, std::size_t n, bool lattice, bool has_room) {
  const long side = 4 + std::lround(std::sqrt(static_cast<double>(n)) * (lattice ? 1.5 : 1.0));
  const long size = lattice ? side : side * 1000;
  std::vector<Stroke> drawn = has_room ? room(size) : std::vector<Stroke>{};
  for (long tries = 0; drawn.size() < n; ++tries) {
    // Where there is no place left for a long free stroke there is for a short one.
    const long reach = std::max(10L, size / 3 - tries * (size / 400));
    const Stroke s = lattice ? lattice_stroke(pen, drawn, size) : free_stroke(pen, drawn, size, reach);
    if (s.a == s.b || !is_inside(s.a, size) || !is_inside(s.b, size)) continue;
    const auto clashes = [&](const Stroke& t) { return clash(s, t); };
    if (lattice || std::none_of(drawn.begin(), drawn.end(), clashes)) drawn.push_back(s);
  }
  return drawn;
}

}  // namespace

void settle_conflicts(std::vector<InputSegment>& edges) { settle_conflicts(edges, cut(edges)); }

Split settle_conflicts(std::vector<InputSegment>& edges, const Cut& cut) {
  std::vector<std::size_t> like(2 * edges.size());  // by label: a face listed earlier that it must agree with
  std::iota(like.begin(), like.end(), std::size_t{0});
  const auto root = [&](std::size_t label) {
    while (like[label] != label) label = like[label];
    return label;
  };
  const auto join = [&](std::size_t f, std::size_t g) {
    f = root(f), g = root(g);
    like[std::max(f, g)] = std::min(f, g);
  };
  const auto material = [&](std::size_t label) -> int& {
    InputSegment& edge = edges[label / 2];
    return label % 2 == 0 ? edge.front_material : edge.back_material;
  };
  for (const std::vector<std::size_t>& group : groups_of(edges))
    for (const std::size_t k : group) {
      join(2 * group.front(), 2 * k);
      join(2 * group.front() + 1, 2 * k + 1);
    }
  Split result = split(edges, cut);
  while (!result.conflicts.empty()) {
    for (const Conflict& conflict : result.conflicts)
      join(static_cast<std::size_t>(conflict.first), static_cast<std::size_t>(conflict.second));
    for (std::size_t label = 0; label < like.size(); ++label) material(label) = material(root(label));
    result = split(edges, cut);
  }
  return result;
}

RandomScene random_scene(std::uint64_t seed, int n, bool lattice) {
  Pen pen(seed, lattice);
  const long denominators[] = {1, 2, 3, 10};
  const mpq_class step(1, lattice ? denominators[pen.number(0, 3)] : 1000);
  RandomScene scene;
  for (const auto& [a, b] : draw(pen, static_cast<std::size_t>(n), lattice, seed % 2 == 1)) {
    const int front = static_cast<int>(pen.number(0, 2));
    const int back = pen.chance(50) ? -1 : static_cast<int>(pen.number(0, 2));
    scene.edges.push_back({a.x * step, a.y * step, b.x * step, b.y * step, front, back});
  }
  settle_conflicts(scene.edges);
  return scene;
}

}  // namespace hottel::oracle
