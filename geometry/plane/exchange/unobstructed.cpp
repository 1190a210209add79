#include "geometry/plane/exchange/unobstructed.h"

#include <array>

namespace hottel {
namespace {

struct String {
  VertexId u, v;
  int sign;
};

// 2 S0 as signed strings, or the front ends p of f and q of g when f and g cross.
struct Strings {
  std::array<String, 4> strings;
  int count = 0;
  bool crosses = false;
  VertexId p{0}, q{0};

  void add(VertexId u, VertexId v, int sign) { strings[static_cast<std::size_t>(count++)] = {u, v, sign}; }
};

// With f = a -> b and g = c -> d, fronts on the right: the uncrossed strings are a-d and b-c. Where g's line cuts f in
// x, the part behind it is clipped; x lies on the line of g outside g, so |x c| - |x d| = ±|c d|, and the sign is the
// one that keeps the sum from being negative.
Strings strings_between(const Vertices2& vertices, const Segment2& f, const Segment2& g) {
  const VertexId a = f.a, b = f.b, c = g.a, d = g.b;
  const int a_in_front = -vertices.orientation(c, d, a), b_in_front = -vertices.orientation(c, d, b);
  const int c_in_front = -vertices.orientation(a, b, c), d_in_front = -vertices.orientation(a, b, d);
  Strings result;
  if ((a_in_front <= 0 && b_in_front <= 0) || (c_in_front <= 0 && d_in_front <= 0)) return result;
  const bool f_is_cut = a_in_front * b_in_front < 0, g_is_cut = c_in_front * d_in_front < 0;
  if (f_is_cut && g_is_cut) {
    result.crosses = true;
    result.p = a_in_front > 0 ? a : b;
    result.q = c_in_front > 0 ? c : d;
  } else if (f_is_cut) {
    const bool a_stays = a_in_front > 0;
    result.add(a_stays ? a : b, a_stays ? c : d, 1);
    result.add(a_stays ? a : b, a_stays ? d : c, -1);
    result.add(c, d, 1);
  } else if (g_is_cut) {
    const bool c_stays = c_in_front > 0;
    result.add(c_stays ? a : b, c_stays ? c : d, 1);
    result.add(c_stays ? b : a, c_stays ? c : d, -1);
    result.add(a, b, 1);
  } else {
    result.add(a, c, 1);
    result.add(b, d, 1);
    result.add(a, d, -1);
    result.add(b, c, -1);
  }
  return result;
}

Rational squared_distance(const Point2& p, const Point2& q) {
  const Rational dx = q.x - p.x, dy = q.y - p.y;
  return dx * dx + dy * dy;
}

}  // namespace

bool face_each_other(const Vertices2& vertices, const Segment2& f, const Segment2& g) {
  const Strings strings = strings_between(vertices, f, g);
  return strings.crosses || strings.count > 0;
}

std::optional<FixedSum> unobstructed_sum(const Vertices2& vertices, const Segment2& f, const Segment2& g) {
  const Strings strings = strings_between(vertices, f, g);
  if (strings.crosses) return std::nullopt;
  FixedSum sum;
  for (int k = 0; k < strings.count; ++k) {
    const String& string = strings.strings[static_cast<std::size_t>(k)];
    const FixedLength2 length = vertices.distance(string.u, string.v);
    sum.value += string.sign > 0 ? length.value : -length.value;
    if (!length.is_exact) sum.error += vertices.length_error();
  }
  return sum;
}

RootSum unobstructed_exact(const Vertices2& vertices, const Segment2& f, const Segment2& g) {
  const Strings strings = strings_between(vertices, f, g);
  RootSum sum;
  if (strings.crosses) {
    const Point2 a = vertices.exact(f.a), b = vertices.exact(f.b), c = vertices.exact(g.a), d = vertices.exact(g.b);
    const Rational at_a = doubled_area(c, d, a), at_b = doubled_area(c, d, b), t = at_a / (at_a - at_b);
    const Point2 x{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const Point2 p = vertices.exact(strings.p), q = vertices.exact(strings.q);
    sum.add(1, squared_distance(p, x));
    sum.add(1, squared_distance(q, x));
    sum.add(-1, squared_distance(p, q));
  }
  for (int k = 0; k < strings.count; ++k) {
    const String& string = strings.strings[static_cast<std::size_t>(k)];
    sum.add(string.sign, vertices.squared_distance(string.u, string.v));
  }
  return sum;
}

}  // namespace hottel
