#include "tests/storm/space/contacts.h"

#include <algorithm>

namespace hottel::storm {

using oracle::SpacePoint;
using oracle::SpacePolygon;

namespace {

// Left of a side, within the plane of the polygon: +1 inside.
mpq_class inward(const SpacePolygon& polygon, std::size_t k, const SpacePoint& p) {
  const SpacePoint way = polygon[(k + 1) % polygon.size()] - polygon[k];
  return oracle::dot(oracle::cross(oracle::normal_of(polygon), way), p - polygon[k]);
}

}  // namespace

int side_of(const SpacePolygon& polygon, const SpacePoint& p) {
  return sgn(oracle::dot(oracle::normal_of(polygon), p - polygon[0]));
}

int place_in(const SpacePolygon& polygon, const SpacePoint& p) {
  int least = 1;
  for (std::size_t k = 0; k < polygon.size(); ++k) least = std::min(least, sgn(inward(polygon, k, p)));
  return least;
}

namespace {

// Does the segment, of the plane of the polygon, have more than a point inside it?
bool runs_inside(const SpacePolygon& polygon, const SpacePoint& p, const SpacePoint& q) {
  mpq_class from = 0, to = 1;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const mpq_class a = inward(polygon, k, p), b = inward(polygon, k, q);
    if (a <= 0 && b <= 0) return false;
    if (a < 0) from = std::max(from, mpq_class(a / (a - b)));
    if (b < 0) to = std::min(to, mpq_class(a / (a - b)));
  }
  return from < to;
}

struct Segment3 {
  const SpacePoint &p, &q;
};

bool are_in_line(const Segment3& a, const Segment3& b) {
  const SpacePoint way = a.q - a.p, zero{0, 0, 0};
  if (!(oracle::cross(way, b.p - a.p) == zero && oracle::cross(way, b.q - a.p) == zero)) return false;
  const mpq_class whole = oracle::dot(way, way), s = oracle::dot(way, b.p - a.p), t = oracle::dot(way, b.q - a.p);
  return std::max(mpq_class(0), std::min(s, t)) < std::min(whole, std::max(s, t));
}

class Contacts {
 public:
  explicit Contacts(const Polygons3& polygons) {
    for (const SpacePolygon& a : polygons)
      for (const SpacePolygon& b : polygons)
        if (&a != &b) look(a, b);
  }
  const std::array<bool, kContactKinds3>& has() const { return has_; }

 private:
  void note(Contact3 contact) { has_[static_cast<std::size_t>(contact)] = true; }

  void look(const SpacePolygon& a, const SpacePolygon& b) {
    bool is_coplanar = true;
    for (const SpacePoint& p : a) is_coplanar = is_coplanar && side_of(b, p) == 0;
    if (is_coplanar) note(Contact3::kCoplanar);
    for (std::size_t k = 0; k < a.size(); ++k) look(a[k], a[(k + 1) % a.size()], b);
  }

  void look(const SpacePoint& p, const SpacePoint& q, const SpacePolygon& b) {
    const int at_p = side_of(b, p), at_q = side_of(b, q);
    if (at_p == 0 && place_in(b, p) > 0) note(Contact3::kCornerIn);
    if (at_p == 0 && at_q == 0 && runs_inside(b, p, q)) note(Contact3::kStands);
    if (at_p * at_q < 0) {
      const mpq_class a = oracle::dot(oracle::normal_of(b), p - b[0]), c = oracle::dot(oracle::normal_of(b), q - b[0]);
      const mpq_class t = a / (a - c);
      if (place_in(b, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)}) > 0)
        note(Contact3::kPierced);
    }
    for (std::size_t k = 0; k < b.size(); ++k) {
      const SpacePoint &r = b[k], &s = b[(k + 1) % b.size()];
      if (p == r) note(Contact3::kCorner);
      if ((p == r && q == s) || (p == s && q == r))
        note(Contact3::kSharedSide);
      else if (are_in_line({p, q}, {r, s}))
        note(Contact3::kInLine);
      const SpacePoint zero{0, 0, 0};
      if (oracle::cross(p - r, s - r) == zero && oracle::dot(p - r, p - s) < 0) note(Contact3::kCornerOnSide);
    }
  }

  std::array<bool, kContactKinds3> has_{};
};

}  // namespace

const char* to_string(Contact3 contact) {
  switch (contact) {
    case Contact3::kPierced:
      return "pierced";
    case Contact3::kStands:
      return "side within";
    case Contact3::kCornerIn:
      return "corner within";
    case Contact3::kSharedSide:
      return "side in common";
    case Contact3::kInLine:
      return "sides in line";
    case Contact3::kCoplanar:
      return "in one plane";
    case Contact3::kCorner:
      return "corner in common";
    case Contact3::kCornerOnSide:
      return "corner on a side";
  }
  return "";
}

void count_contacts_3(const Polygons3& polygons, ContactCounts3& counts) {
  const Contacts contacts(polygons);
  for (std::size_t c = 0; c < kContactKinds3; ++c) counts[c] += contacts.has()[c] ? 1 : 0;
}

}  // namespace hottel::storm
