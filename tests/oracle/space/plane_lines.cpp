#include "tests/oracle/space/plane_lines.h"

#include <algorithm>
#include <cmath>

namespace hottel::oracle {
namespace {

using Coefficients = std::array<mpq_class, 3>;
using Integers = std::array<mpz_class, 3>;

constexpr double kMargin = 1e-3;    // around the polygon, of its size
constexpr double kParallel = 1e-7;  // sine, as lines are scaled, below which doubles do not tell where they meet
constexpr double kParallelToDigits = 1e-90;

// The line in which a plane cuts that of the frame.
Coefficients line_of(const PlaneFrame& frame, const SpacePoint& normal, const SpacePoint& through) {
  return {dot(normal, frame.u), dot(normal, frame.v), dot(normal, frame.origin - through)};
}

Integers crossed(const Integers& a, const Integers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpz_class product(const Integers& a, const Integers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool are_same(const PlaneLine& a, const PlaneLine& b) {
  for (const long t : {0, 1, 2})
    if (crossed(a.at(t), b.at(t)) != Integers{0, 0, 0}) return false;
  return true;
}

// The cubic with these values at -1, 0, 1 and 2, times 6.
std::array<mpz_class, 4> interpolated(const std::array<mpz_class, 4>& y) {
  return {6 * y[1], -2 * y[0] - 3 * y[1] + 6 * y[2] - y[3], 3 * y[0] - 6 * y[1] + 3 * y[2],
          -y[0] + 3 * y[1] - 3 * y[2] + y[3]};
}

// Without its root p / q, which it has.
std::array<mpz_class, 4> without_root(const std::array<mpz_class, 4>& c, const mpz_class& p, const mpz_class& q) {
  const mpz_class b2 = c[3] * q * q, b1 = c[2] * q * q + c[3] * q * p, b0 = c[1] * q * q + c[2] * q * p + c[3] * p * p;
  return {b0, b1, b2, 0};
}

// The roots of a quadratic polynomial in (0, 1). REQUIRES that it is not 0 everywhere.
template <class Visit>
void for_each_root(const std::array<mpz_class, 4>& c, const Visit& visit) {
  const auto visit_inner = [&](const DeepReal& t) {
    if (t > 0 && t < 1) visit(t);
  };
  if (c[2] == 0) {
    if (c[1] != 0) visit_inner(-real<DeepReal>(c[0]) / real<DeepReal>(c[1]));
    return;
  }
  const mpz_class discriminant = c[1] * c[1] - 4 * c[0] * c[2];
  if (discriminant < 0) return;
  const DeepReal root = sqrt(real<DeepReal>(discriminant));
  const DeepReal sum = -(real<DeepReal>(c[1]) + (c[1] < 0 ? -root : root));
  visit_inner(sum / (2 * real<DeepReal>(c[2])));
  if (sum != 0) visit_inner(2 * real<DeepReal>(c[0]) / sum);
}

bool is_zero(const std::array<mpz_class, 4>& c) {
  return std::all_of(c.begin(), c.end(), [](const mpz_class& z) { return z == 0; });
}

std::size_t place_of(std::size_t a, std::size_t b, std::size_t c, std::size_t n) { return (a * n + b) * n + c; }

// Of all edges that planes past f are taken through.
std::vector<SpaceSegment> edges_of(const std::vector<PlanePolygon>& polygons) {
  std::vector<SpaceSegment> edges;
  for (std::size_t k = 1; k < polygons.size(); ++k)
    for (const SpaceSegment& side : sides_of(polygons[k].points)) edges.push_back(side);
  for (std::size_t k = 2; k < polygons.size(); ++k)
    for (const SpaceSegment& foot : common_segment(polygons[1], polygons[k])) edges.push_back(foot);
  return edges;
}

}  // namespace

std::array<mpz_class, 3> PlaneLine::at(long t) const {
  return {at_0[0] + t * slope[0], at_0[1] + t * slope[1], at_0[2] + t * slope[2]};
}

PlaneFrame::PlaneFrame(const SpacePolygon& polygon)
    : origin(polygon[0]), u(polygon[1] - polygon[0]), v(polygon[2] - polygon[0]) {}

std::array<mpq_class, 2> PlaneFrame::place(const SpacePoint& p) const {
  const SpacePoint normal = cross(u, v), from = p - origin;
  const mpq_class square = dot(normal, normal);
  return {dot(cross(from, v), normal) / square, dot(cross(u, from), normal) / square};
}

// The least box around the polygon in its frame, and a margin.
std::array<double, 4> reach_of(const PlaneFrame& frame, const SpacePolygon& polygon) {
  std::array<double, 4> reach{0, 0, 0, 0};
  for (const SpacePoint& p : polygon) {
    const std::array<mpq_class, 2> place = frame.place(p);
    for (std::size_t k = 0; k < 2; ++k) {
      reach[2 * k] = std::min(reach[2 * k], place[k].get_d());
      reach[2 * k + 1] = std::max(reach[2 * k + 1], place[k].get_d());
    }
  }
  for (std::size_t k = 0; k < 4; ++k) reach[k] += k % 2 == 0 ? -kMargin : kMargin;
  return reach;
}

PlaneLines::PlaneLines(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f)
    : polygons_(polygons), f_(f), frame_(polygons[0].points), reach_(reach_of(frame_, polygons[0].points)) {
  for (const SpaceSegment& side : sides_of(polygons[0].points)) {
    const Coefficients line = line_of(frame_, cross(polygons[0].normal, side.b - side.a), side.a);
    add(line, line, false);
  }
  sides_ = lines_.size();
  for (std::size_t k = 1; k < polygons.size(); ++k) add_static(polygons[k]);
  for (const SpaceSegment& e : edges_of(polygons)) add_moving(e);
  meet_all();
}

void PlaneLines::add_static(const PlanePolygon& polygon) {
  const Coefficients line = line_of(frame_, polygon.normal, polygon.points[0]);
  add(line, line, false);
}

void PlaneLines::add_moving(const SpaceSegment& e) {
  const auto at = [&](const SpacePoint& p) { return line_of(frame_, cross(e.a - p, e.b - p), e.a); };
  add(at(f_.a), at(f_.b), true);
}

void PlaneLines::add(const std::array<mpq_class, 3>& at_0, const std::array<mpq_class, 3>& at_1, bool is_moving) {
  mpz_class common = 1;
  for (const Coefficients* c : {&at_0, &at_1})
    for (const mpq_class& q : *c) mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
  PlaneLine line;
  line.is_moving = is_moving;
  for (std::size_t k = 0; k < 3; ++k) {
    line.at_0[k] = mpq_class(at_0[k] * common).get_num();
    line.slope[k] = mpq_class((at_1[k] - at_0[k]) * common).get_num();
  }
  const bool is_none = line.at_0[0] == 0 && line.at_0[1] == 0 && line.slope[0] == 0 && line.slope[1] == 0;
  if (is_none || std::any_of(lines_.begin(), lines_.end(), [&](const PlaneLine& l) { return are_same(l, line); }))
    return;
  lines_.push_back(std::move(line));
}

bool PlaneLines::always_meet(std::size_t a, std::size_t b, std::size_t c) const {
  std::array<std::size_t, 3> order{a, b, c};
  std::sort(order.begin(), order.end());
  return always_[place_of(order[0], order[1], order[2], lines_.size())] != 0;
}

PlaneLines::Polynomial PlaneLines::meeting(std::size_t a, std::size_t b, std::size_t c) const {
  std::array<mpz_class, 4> values;
  for (const long t : {-1, 0, 1, 2})
    values[static_cast<std::size_t>(t + 1)] = product(lines_[a].at(t), crossed(lines_[b].at(t), lines_[c].at(t)));
  const Polynomial cubic = interpolated(values);
  if (cubic[3] == 0) return cubic;
  // Planes through f(t) meet in it: where it passes through the plane of the lines, the determinant is 0.
  const mpq_class from = polygons_[0].height(f_.a), to = polygons_[0].height(f_.b);
  const mpq_class root = from / (from - to);
  return without_root(cubic, root.get_num(), root.get_den());
}

void PlaneLines::meet_all() {
  const std::size_t n = lines_.size();
  always_.assign(n * n * n, 0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c) {
        Meeting one{a, b, c, meeting(a, b, c)};
        if (is_zero(one.when))
          always_[place_of(a, b, c, n)] = 1;
        else
          meetings_.push_back(std::move(one));
      }
}

// Whether the lines, at t, meet near polygon 0, or are too nearly parallel to tell.
template <class Real>
std::optional<bool> PlaneLines::meet_near(const Real& t, const std::array<std::size_t, 3>& which, double least) const {
  using std::fabs;
  std::array<std::array<Real, 3>, 3> lines;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlaneLine& line = lines_[which[k]];
    for (std::size_t m = 0; m < 3; ++m) lines[k][m] = real<Real>(line.at_0[m]) + t * real<Real>(line.slope[m]);
    const Real size = std::max(Real(fabs(lines[k][0])), Real(fabs(lines[k][1])));
    if (size > 0)
      for (Real& c : lines[k]) c /= size;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &p = lines[k], &q = lines[(k + 1) % 3];
    const Real sine = p[0] * q[1] - p[1] * q[0];
    if (!(fabs(sine) > least)) continue;
    const Real alpha = (p[1] * q[2] - p[2] * q[1]) / sine, beta = (p[2] * q[0] - p[0] * q[2]) / sine;
    return alpha > reach_[0] && alpha < reach_[1] && beta > reach_[2] && beta < reach_[3];
  }
  return std::nullopt;
}

bool PlaneLines::is_near(const DeepReal& t, const std::array<std::size_t, 3>& which) const {
  if (const auto told = meet_near(static_cast<double>(t), which, kParallel)) return *told;
  return meet_near(t, which, kParallelToDigits).value_or(true);
}

void PlaneLines::add_plain_events(std::vector<DeepReal>& found) const {
  const auto add_zero = [&](const mpq_class& from, const mpq_class& to) {
    if (sgn(from) * sgn(to) < 0) found.push_back(real<DeepReal>(mpq_class(from / (from - to))));
  };
  for (const PlanePolygon& polygon : polygons_) add_zero(polygon.height(f_.a), polygon.height(f_.b));
  const SpacePoint way = f_.b - f_.a;
  std::vector<SpaceSegment> edges = edges_of(polygons_);
  for (const SpaceSegment& side : sides_of(polygons_[0].points)) edges.push_back(side);
  for (const SpaceSegment& e : edges) {
    const SpacePoint normal = cross(way, e.b - e.a), across = cross(e.b - e.a, normal);
    if (dot(normal, e.a - f_.a) == 0) add_zero(dot(across, f_.a - e.a), dot(across, f_.b - e.a));
  }
}

std::vector<DeepReal> PlaneLines::events() const {
  std::vector<DeepReal> found{DeepReal(0), DeepReal(1)};
  add_plain_events(found);
  for (const Meeting& one : meetings_)
    for_each_root(one.when, [&](const DeepReal& t) {
      if (is_near(t, {one.a, one.b, one.c})) found.push_back(t);
    });
  std::sort(found.begin(), found.end());
  const DeepReal least("1e-120");
  found.erase(
      std::unique(found.begin(), found.end(), [&](const DeepReal& s, const DeepReal& t) { return t - s < least; }),
      found.end());
  return found;
}

}  // namespace hottel::oracle
