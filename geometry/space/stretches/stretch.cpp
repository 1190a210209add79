#include "geometry/space/stretches/stretch.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace hottel {
namespace {

bool is_before_zero(const IntegerVector& a) {
  const int x = sgn(a.x), y = sgn(a.y);
  return x < 0 || (x == 0 && (y < 0 || (y == 0 && sgn(a.z) < 0)));
}

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

// A line: its direction in coprime integers, the first that is not zero positive, and the product of a point with it.
struct LineKey {
  IntegerVector direction;
  Rational x, y, z;
  friend bool operator<(const LineKey& a, const LineKey& b) {
    return std::tie(a.direction.x, a.direction.y, a.direction.z, a.x, a.y, a.z) <
           std::tie(b.direction.x, b.direction.y, b.direction.z, b.x, b.y, b.z);
  }
};

// A part with its ends along the direction of the line.
struct PlacedPart {
  const LinePart3* part;
  Rational low, high;
  bool is_turned;  // the part runs against the direction of the line
};

LineKey key_of(const LinePart3& part, bool& is_turned) {
  LineKey key;
  key.direction = primitive(stretch_between(part.from, part.to).way);
  is_turned = is_before_zero(key.direction);
  if (is_turned) key.direction = opposite(key.direction);
  const IntegerVector moment = cross(part.from.numerator, key.direction);
  key.x = quotient(moment.x, part.from.weight);
  key.y = quotient(moment.y, part.from.weight);
  key.z = quotient(moment.z, part.from.weight);
  return key;
}

// True iff both lie in one plane and on opposite sides of the stretch: whatever passes there meets one of them.
bool continue_each_other(const StretchFace3& a, const StretchFace3& b, std::span<const IntegerVector> normals) {
  const IntegerVector &n = normals[a.surface], &m = normals[b.surface];
  if (!is_zero(cross(n, m))) return false;
  const bool is_alike = sgn(dot(n, m)) > 0;
  return (a.is_forward == b.is_forward) != is_alike;
}

bool is_closed(const AtomicStretch3& stretch, std::span<const IntegerVector> normals) {
  for (std::size_t a = 0; a < stretch.faces.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (continue_each_other(stretch.faces[a], stretch.faces[b], normals)) return true;
  return false;
}

void add_stretches(const std::vector<PlacedPart>& placed, bool keeps_inside, std::span<const IntegerVector> normals,
                   std::vector<AtomicStretch3>& result) {
  std::map<Rational, const WeightedPoint3*> ends;
  for (const PlacedPart& p : placed) {
    ends.try_emplace(p.low, p.is_turned ? &p.part->to : &p.part->from);
    ends.try_emplace(p.high, p.is_turned ? &p.part->from : &p.part->to);
  }
  for (auto end = ends.begin(), next = std::next(end); next != ends.end(); end = next, ++next) {
    AtomicStretch3 stretch;
    bool is_inside = false;
    for (const PlacedPart& p : placed) {
      if (p.low > end->first || p.high < next->first) continue;
      is_inside |= p.part->is_inside;
      stretch.faces.push_back({p.part->face.surface, p.part->face.is_forward != p.is_turned});
    }
    if (stretch.faces.empty() || (!keeps_inside && (is_inside || is_closed(stretch, normals)))) continue;
    std::sort(stretch.faces.begin(), stretch.faces.end(),
              [](const StretchFace3& a, const StretchFace3& b) { return a.surface < b.surface; });
    stretch.stretch = stretch_between(*end->second, *next->second);
    result.push_back(std::move(stretch));
  }
}

}  // namespace

Stretch3 stretch_between(const WeightedPoint3& a, const WeightedPoint3& b) {
  if (a.weight == b.weight) return {a.numerator, difference(b.numerator, a.numerator), a.weight};
  return {multiple(b.weight, a.numerator), difference(multiple(a.weight, b.numerator), multiple(b.weight, a.numerator)),
          a.weight * b.weight};
}

Stretch3 part_of(const Stretch3& s, const Rational& low, const Rational& high) {
  if (low == 0 && high == 1) return s;
  const auto point_at = [&s](const Rational& t) -> WeightedPoint3 {
    const Integer &p = t.get_num(), &q = t.get_den();
    return {{q * s.from.x + p * s.way.x, q * s.from.y + p * s.way.y, q * s.from.z + p * s.way.z}, q * s.weight};
  };
  return stretch_between(point_at(low), point_at(high));
}

std::vector<AtomicStretch3> atomic_stretches(const std::vector<LinePart3>& parts, bool keeps_inside,
                                             std::span<const IntegerVector> normals) {
  std::map<LineKey, std::vector<PlacedPart>> lines;
  for (const LinePart3& part : parts) {
    bool is_turned;
    LineKey key = key_of(part, is_turned);
    const auto place = [&key](const WeightedPoint3& point) {
      return quotient(dot(key.direction, point.numerator), point.weight);
    };
    Rational low = place(part.from), high = place(part.to);
    if (is_turned) std::swap(low, high);
    lines[std::move(key)].push_back({&part, std::move(low), std::move(high), is_turned});
  }
  std::vector<AtomicStretch3> result;
  for (const auto& [key, placed] : lines) add_stretches(placed, keeps_inside, normals, result);
  return result;
}

}  // namespace hottel
