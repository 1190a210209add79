#include "geometry/plane/visibility/visibility_polygon.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Where the ray from the eye through a point meets the line of a piece. REQUIRES that they are not parallel.
Point2 ray_meets_piece(const Point2& eye, const Point2& through, const Point2& a, const Point2& b) {
  const Point2 along = minus(b, a), ray = minus(through, eye);
  const Rational t = cross(minus(a, eye), along) / cross(ray, along);
  return {eye.x + t * ray.x, eye.y + t * ray.y};
}

}  // namespace

std::vector<Point2> VisibilityPolygon2::corners() const {
  std::vector<Point2> result;
  const auto add = [&result](const Point2& p) {
    if (result.empty() || !(result.back() == p)) result.push_back(p);
  };
  const auto is_solid = [this](std::size_t k) { return parts[k % parts.size()].solid != Solids2::kNone; };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (is_solid(k)) continue;
    add(parts[k].from);
    add(parts[k].to);
    if (!is_solid(k + 1)) continue;
    std::size_t next = k + 1;
    while (is_solid(next)) ++next;
    const Point2 from = minus(parts[k].to, eye), to = minus(parts[next % parts.size()].from, eye);
    if (cross(from, to) != 0 || dot(from, to) > 0) add(eye);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

VisibilityPolygon2 visibility_polygon(const Arrangement2& arrangement, const PointLocation2& location,
                                      const Point2& eye) {
  const Vertices2& vertices = arrangement.vertices();
  const Eye2 look(vertices, vertices.from_scene(eye));
  const Point2 at = look.exact();

  VisibilityPolygon2 result;
  View2& view = result.view;
  result.eye = eye;
  result.location = location.look_around(look, view);
  Rational twice_area = 0;
  bool is_bounded = !view.seen.empty();
  const std::size_t m = view.seen.size();
  for (std::size_t k = 0; k < m; ++k) {
    const VertexId right = view.seen[k].vertex, left = view.seen[k + 1 == m ? 0 : k + 1].vertex;
    const PieceSideId side = view.seen[k].behind;
    Point2 from = vertices.exact(right), to = vertices.exact(left);
    if (side == kSky) {
      is_bounded = false;
    } else {
      const Segment2& piece = arrangement.piece(side);
      const Point2 a = vertices.exact(piece.a), b = vertices.exact(piece.b);
      if (right != piece.a && right != piece.b) from = ray_meets_piece(at, from, a, b);
      if (left != piece.a && left != piece.b) to = ray_meets_piece(at, to, a, b);
      if (!arrangement.is_covered(side)) twice_area += cross(minus(from, at), minus(to, at));
    }
    result.parts.push_back({vertices.to_scene(from), vertices.to_scene(to), side,
                            side == kSky ? Solids2::kNone : arrangement.solids().maker(side)});
  }
  result.solid = solid_around(arrangement, view);
  if (is_bounded && result.solid == Solids2::kNone) result.area = twice_area * vertices.scale() * vertices.scale() / 2;
  return result;
}

Ball angle_fraction(const VisibilityPolygon2& polygon, std::size_t part, long precision) {
  const Rational one = 1;
  if (polygon.parts.size() == 1) return Ball::of(one, precision);
  const Point2 from = minus(polygon.parts[part].from, polygon.eye), to = minus(polygon.parts[part].to, polygon.eye);
  const Rational across = cross(from, to), along = dot(from, to);
  const Ball two = Ball::of(Rational(2), precision);
  const Ball turn = Ball::atan2(Ball::of(across, precision), Ball::of(along, precision), precision)
                        .over(Ball::pi(precision).times(two, precision), precision);
  return across < 0 ? turn.plus(Ball::of(one, precision), precision) : turn;
}

Rounded rounded_angle_fraction(const VisibilityPolygon2& polygon, std::span<const std::size_t> parts) {
  // The product of the turns as complex numbers has the argument of the sum.
  const auto is_multiple_of_eighth = [&] {
    Rational re = 1, im = 0;
    if (polygon.parts.size() == 1) return true;
    for (const std::size_t part : parts) {
      const Point2 from = minus(polygon.parts[part].from, polygon.eye), to = minus(polygon.parts[part].to, polygon.eye);
      const Rational c = dot(from, to), s = cross(from, to), next = re * c - im * s;
      im = re * s + im * c;
      re = next;
    }
    return re == 0 || im == 0 || re == im || re == -im;
  };
  for (long precision = 128;; precision *= 2) {
    Ball sum;
    for (const std::size_t part : parts) sum = sum.plus(angle_fraction(polygon, part, precision), precision);
    const Enclosure ends = sum.nearest_of_ends();
    if (ends.lower != ends.upper) continue;
    const double nearest = ends.lower;
    if (const int side = sum.compare(nearest); side != 0) return {nearest, static_cast<signed char>(side)};
    if (8 * nearest == std::floor(8 * nearest) && is_multiple_of_eighth()) return {nearest, 0};
  }
}

std::vector<PointFactor2> point_factors(const Arrangement2& arrangement, const PointLocation2& location,
                                        const Point2& from, const Point2& to, bool from_back, const Rational& t) {
  HOTTEL_REQUIRE(t >= 0 && t <= 1);
  const Vertices2& vertices = arrangement.vertices();
  // The front is on the right of from -> to, the back on the right of to -> from: u runs with the seen side on its
  // right.
  const Point2 first = vertices.from_scene(from), second = vertices.from_scene(to);
  const Point2 u = from_back ? minus(first, second) : minus(second, first);
  const Point2 back_u{-u.x, -u.y};
  const Eye2 eye(vertices, {first.x + t * (second.x - first.x), first.y + t * (second.y - first.y)});
  View2 view;
  location.look_around(eye, view);
  const std::size_t m = view.seen.size();
  const Point2 at = eye.exact();
  std::vector<Point2> direction;
  for (const View2::Seen& seen : view.seen) direction.push_back(minus(vertices.exact(seen.vertex), at));

  // The front half-plane, counter-clockwise from -u to u, holds the directions with cross(u, direction) < 0. What is
  // seen in it, cone by cone:
  struct Cone {
    Point2 right, left;
    PieceSideId side;
  };
  std::vector<Cone> cones;
  const auto is_in_front = [&](const Point2& d) { return cross(u, d) < 0; };
  for (std::size_t k = 0; k < m; ++k) {
    const Point2 &right = direction[k], &left = direction[(k + 1) % m];
    const PieceSideId side = view.seen[k].behind;
    const Rational turn = cross(right, left);
    if (is_in_front(right) && is_in_front(left) && turn > 0) {
      cones.push_back({right, left, side});
    } else if (is_in_front(right) || is_in_front(left)) {
      if (is_in_front(left)) cones.push_back({back_u, left, side});
      if (is_in_front(right)) cones.push_back({right, u, side});
    } else {
      const bool stays_behind = turn > 0 || (turn == 0 && m > 1 && dot(u, right) > 0 && dot(u, left) < 0);
      if (!stays_behind) cones.push_back({back_u, u, side});
    }
  }

  // A piece that leaves the edge at the eye hides everything beyond it from a point moved along the edge.
  const bool moves_along_u = (t < 1) != from_back;
  std::optional<Cone> hidden;
  for (std::size_t k = 0; k < m; ++k) {
    if (view.seen[k].left == kNoPiece || !is_in_front(direction[k])) continue;
    if (moves_along_u) {
      if (!hidden || cross(hidden->left, direction[k]) > 0) hidden = Cone{back_u, direction[k], view.seen[k].left};
    } else {
      if (!hidden || cross(hidden->right, direction[k]) < 0) hidden = Cone{direction[k], u, view.seen[k].right};
    }
  }
  if (hidden) {
    std::erase_if(cones, [&](const Cone& cone) {
      return moves_along_u ? cross(cone.left, hidden->left) >= 0 : cross(hidden->right, cone.right) >= 0;
    });
    cones.push_back(*hidden);
  }

  // sin phi of a direction, with phi from the normal towards u, is (direction . u) / (|direction| |u|).
  const auto sine = [&](const Point2& d) {
    const Rational squared = dot(d, d) * dot(u, u);
    RootSum result;
    result.add(dot(d, u) / squared, squared);
    return result;
  };
  std::vector<PointFactor2> result;
  for (const Cone& cone : cones) {
    const RootSum part = (sine(cone.left) - sine(cone.right)) * Rational(1, 2);
    const auto same = std::find_if(result.begin(), result.end(), [&](const auto& f) { return f.side == cone.side; });
    if (same == result.end())
      result.push_back({cone.side, part});
    else
      same->factor += part;
  }
  return result;
}

}  // namespace hottel
