#include "geometry/plane/visibility/range_polygon.h"

#include "kernel/ball.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

Point2 times(const Rational& t, const Point2& p) { return {t * p.x, t * p.y}; }
Point2 plus(const Point2& p, const Point2& q) { return {p.x + q.x, p.y + q.y}; }

// base + slope sqrt(radicand), correctly rounded. What is irrational is neither a double nor half-way between two.
double rounded(const Rational& base, const Rational& slope, const Rational& radicand) {
  if (slope == 0 || radicand == 0) return written_double(base);
  const Integer square = radicand.get_num() * radicand.get_den();
  const Rational factor = slope / radicand.get_den();
  if (mpz_perfect_square_p(square.get_mpz_t())) return written_double(base + factor * Integer(sqrt(square)));
  for (long precision = 128;; precision *= 2) {
    const Ball root = Ball::of(factor, precision).times(Ball::root(square, precision), precision);
    const Enclosure ends = Ball::of(base, precision).plus(root, precision).nearest_of_ends();
    if (ends.lower == ends.upper)  // and not 0
      return written_double(Rounded{ends.lower, 1});
  }
}

// A corner base + slope sqrt(radicand), in scene coordinates.
struct RangeCorner {
  Point2 base, slope;
  Rational radicand;
  PieceSideId after;
};

// The border of what is seen in one part: it begins on the part's right ray, and ends on the left one.
struct PartBorder {
  std::vector<RangeCorner> corners;
  bool begins_with_arc = false, ends_with_arc = false;
  bool begins_on_circle = false, ends_on_circle = false;  // where it is no arc
  bool is_joined = false;                                 // to the next part; else a solid lies between them
  bool has_eye_after = false;
};

class Cutter {
 public:
  Cutter(const VisibilityPolygon2& polygon, const Rational& range) : polygon_(polygon), range_(range) {}

  RoundedPolygon2 cut() {
    for (std::size_t k = 0; k < polygon_.parts.size(); ++k)
      if (!is_solid(k)) borders_.push_back(border(k));
    for (std::size_t k = 0; k < borders_.size(); ++k)
      if (borders_[k].is_joined) join(borders_[k], borders_[k + 1 == borders_.size() ? 0 : k + 1]);
    RoundedPolygon2 result;
    const auto add = [&](const RangeCorner& c) {
      result.corners.push_back(
          {rounded(c.base.x, c.slope.x, c.radicand), rounded(c.base.y, c.slope.y, c.radicand), c.after});
    };
    for (const PartBorder& border : borders_) {
      for (const RangeCorner& corner : border.corners) add(corner);
      if (border.has_eye_after) add({polygon_.eye, {}, 0, kNoPiece});
    }
    if (result.corners.empty() && (polygon_.parts.empty() || !borders_.empty()))
      add({{polygon_.eye.x + range_, polygon_.eye.y}, {}, 0, kRange});
    return result;
  }

 private:
  bool is_solid(std::size_t k) const { return polygon_.parts[k % polygon_.parts.size()].solid != Solids2::kNone; }

  // Where the ray through a point meets the circle.
  RangeCorner on_ray(const Point2& through, PieceSideId after) const {
    const Point2 d = minus(through, polygon_.eye);
    const Rational squared = dot(d, d);
    return {polygon_.eye, times(range_ / squared, d), squared, after};
  }

  PartBorder border(std::size_t k) const {
    const auto& part = polygon_.parts[k];
    PartBorder result;
    add_corners(part, result);
    result.is_joined = !is_solid(k + 1);
    if (!result.is_joined) {
      std::size_t next = k + 1;
      while (is_solid(next)) ++next;
      const Point2 from = minus(part.to, polygon_.eye),
                   to = minus(polygon_.parts[next % polygon_.parts.size()].from, polygon_.eye);
      result.has_eye_after = cross(from, to) != 0 || dot(from, to) > 0;
    }
    return result;
  }

  // The squared distance of from + t w from the eye, less that of the circle, is a t² + 2 b t + c.
  void add_corners(const VisibilityPolygon2::Part& part, PartBorder& result) const {
    const Point2 from = minus(part.from, polygon_.eye), w = minus(part.to, part.from);
    const Rational a = dot(w, w), b = dot(from, w), c = dot(from, from) - range_ * range_;
    const Rational end = a + 2 * b + c, discriminant = b * b - a * c;
    const bool is_met = part.side != kSky && (c < 0 || end < 0 || (b < 0 && -b < a && discriminant > 0));
    const auto crossing = [&](int sign, PieceSideId after) -> RangeCorner {
      return {plus(part.from, times(-b / a, w)), times(sign / a, w), discriminant, after};
    };
    if (!is_met) {
      result.corners = {on_ray(part.from, kRange), on_ray(part.to, kNoPiece)};
      result.begins_with_arc = result.ends_with_arc = true;
      return;
    }
    result.begins_with_arc = c > 0;
    result.begins_on_circle = c == 0;
    if (c > 0) {
      result.corners.push_back(on_ray(part.from, kRange));
      result.corners.push_back(crossing(-1, part.side));
    } else {
      result.corners.push_back({part.from, {}, 0, part.side});
    }
    result.ends_with_arc = end > 0;
    result.ends_on_circle = end == 0;
    if (end > 0) {
      result.corners.push_back(crossing(1, kRange));
      result.corners.push_back(on_ray(part.to, kNoPiece));
    } else {
      result.corners.push_back({part.to, {}, 0, kNoPiece});
    }
  }

  // Drops corners that two parts have in common: both are on one ray.
  static void join(PartBorder& before, PartBorder& next) {
    RangeCorner& end = before.corners.back();
    const RangeCorner& begin = next.corners.front();
    if (before.ends_with_arc && next.begins_with_arc) {
      before.corners.pop_back();
      next.corners.erase(next.corners.begin());
    } else if (before.ends_with_arc) {
      if (next.begins_on_circle) before.corners.pop_back();
    } else if (next.begins_with_arc) {
      if (!before.ends_on_circle) return;
      end.after = begin.after;
      next.corners.erase(next.corners.begin());
    } else if (end.base == begin.base) {
      before.corners.pop_back();
    }
  }

  const VisibilityPolygon2& polygon_;
  const Rational& range_;
  std::vector<PartBorder> borders_;
};

}  // namespace

RoundedPolygon2 polygon_within(const VisibilityPolygon2& polygon, const Rational& range) {
  HOTTEL_REQUIRE(range > 0);
  if (polygon.solid == Solids2::kNone) return Cutter(polygon, range).cut();
  RoundedPolygon2 result;
  result.solid = polygon.solid;
  return result;
}

}  // namespace hottel
