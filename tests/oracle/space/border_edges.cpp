#include "tests/oracle/space/border_edges.h"

#include <algorithm>
#include <utility>

namespace hottel::oracle {
namespace {

const SpacePoint kZero{0, 0, 0};

SpacePoint between(const SpacePoint& a, const SpacePoint& b, const mpq_class& t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

// Where p is along the line, 0 at f.a and 1 at f.b.
mpq_class place(const SpaceSegment& f, const SpacePoint& p) {
  const SpacePoint way = f.b - f.a;
  return dot(p - f.a, way) / dot(way, way);
}

// The part of a segment where a height, linear along it, is not negative.
std::vector<SpaceSegment> clipped(const SpaceSegment& f, const mpq_class& from, const mpq_class& to) {
  if (from < 0 && to < 0) return {};
  SpaceSegment part = f;
  if (from < 0) part.a = between(f.a, f.b, from / (from - to));
  if (to < 0) part.b = between(f.a, f.b, from / (from - to));
  if (part.a == part.b) return {};
  return {part};
}

// The segment cut at all ends of others on its line.
void add_atoms(const SpaceSegment& f, const std::vector<SpaceSegment>& all, std::vector<SpaceSegment>& atoms) {
  std::vector<mpq_class> cuts{0, 1};
  for (const SpaceSegment& e : all)
    if (are_collinear(e, f))
      for (const SpacePoint* p : {&e.a, &e.b})
        if (const mpq_class t = place(f, *p); t > 0 && t < 1) cuts.push_back(t);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (std::size_t k = 1; k < cuts.size(); ++k)
    atoms.push_back({between(f.a, f.b, cuts[k - 1]), between(f.a, f.b, cuts[k])});
}

bool are_equal(const SpaceSegment& e, const SpaceSegment& f) {
  return (e.a == f.a && e.b == f.b) || (e.a == f.b && e.b == f.a);
}

std::vector<SpaceSegment> all_segments(const std::vector<PlanePolygon>& polygons) {
  std::vector<SpaceSegment> all;
  const auto add = [&all](const std::vector<SpaceSegment>& some) { all.insert(all.end(), some.begin(), some.end()); };
  for (std::size_t k = 1; k < polygons.size(); ++k) add(sides_of(polygons[k].points));
  for (std::size_t k = 2; k < polygons.size(); ++k) add(common_segment(polygons[1], polygons[k]));
  add(common_with_plane(polygons[1].points, polygons[0]));
  return all;
}

}  // namespace

bool are_collinear(const SpaceSegment& e, const SpaceSegment& f) {
  const SpacePoint way = f.b - f.a;
  return cross(e.a - f.a, way) == kZero && cross(e.b - f.a, way) == kZero;
}

std::vector<SpaceSegment> sides_of(const SpacePolygon& polygon) {
  std::vector<SpaceSegment> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k) sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  return sides;
}

std::vector<SpaceSegment> common_with_plane(const SpacePolygon& polygon, const PlanePolygon& plane) {
  std::vector<SpacePoint> points;
  for (const SpaceSegment& side : sides_of(polygon)) {
    const mpq_class from = plane.height(side.a), to = plane.height(side.b);
    if (from == 0) points.push_back(side.a);
    if (sgn(from) * sgn(to) < 0) points.push_back(between(side.a, side.b, from / (from - to)));
  }
  if (points.size() != 2) return {};  // more: it lies in the plane
  return {{points[0], points[1]}};
}

std::vector<SpaceSegment> common_segment(const PlanePolygon& a, const PlanePolygon& b) {
  const std::vector<SpaceSegment> of_a = common_with_plane(a.points, b), of_b = common_with_plane(b.points, a);
  if (of_a.empty() || of_b.empty()) return {};
  mpq_class low = place(of_a[0], of_b[0].a), high = place(of_a[0], of_b[0].b);
  if (low > high) std::swap(low, high);
  low = std::max(low, mpq_class(0));
  high = std::min(high, mpq_class(1));
  if (low >= high) return {};
  return {{between(of_a[0].a, of_a[0].b, low), between(of_a[0].a, of_a[0].b, high)}};
}

std::vector<SpaceSegment> border_edges(const std::vector<PlanePolygon>& polygons) {
  std::vector<SpaceSegment> inside, atoms, result;
  for (const SpaceSegment& f : all_segments(polygons)) {
    const mpq_class from = polygons[0].height(f.a), to = polygons[0].height(f.b);
    if (from == 0 && to == 0 && !polygons[1].holds(f.a, f.b)) continue;
    for (const SpaceSegment& part : clipped(f, from, to)) inside.push_back(part);
  }
  for (const SpaceSegment& f : inside) add_atoms(f, inside, atoms);
  for (const SpaceSegment& f : atoms)
    if (std::none_of(result.begin(), result.end(), [&](const SpaceSegment& e) { return are_equal(e, f); }))
      result.push_back(f);
  return result;
}

}  // namespace hottel::oracle
