#include "geometry/plane/visibility/corner_rounding.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "kernel/exact_double.h"
#include "kernel/support/parallel.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Kind = ViewCorner2::Kind;

// Vertices are below this power of two in integer form.
constexpr int kPlaceBits = 60;

// Integers below 2^62 have differences and, times those of vertices, cross products that 128 bits hold.
constexpr int kEyeBits = 61;

DoubleDouble split(const Rational& value) {
  const double hi = written_double(value);
  return {hi, std::isfinite(hi) ? to_double(value - exact_value(hi)) : 0.0};
}

bool is_below(Int128 value, Int128 limit) { return -limit < value && value < limit; }

// Off by at most 2^-51 |value|. REQUIRES |value| < 2^126.
double near(Int128 value) {
  const auto low = static_cast<std::int64_t>(value);
  if (low == value) return static_cast<double>(low);
  constexpr std::int64_t kMask = std::numeric_limits<std::int64_t>::max();
  return static_cast<double>(static_cast<std::int64_t>(value >> 63)) * 0x1p63 + static_cast<double>(low & kMask);
}

// number * factor modulo 2^128, as a signed number.
Int128 wrapped_product(Int128 number, std::int64_t factor) {
  return static_cast<Int128>(static_cast<UInt128>(number) * static_cast<UInt128>(static_cast<Int128>(factor)));
}
Int128 wrapped_difference(Int128 a, Int128 b) {
  return static_cast<Int128>(static_cast<UInt128>(a) - static_cast<UInt128>(b));
}

// Where the ray from the eye through a point meets the line of a piece. REQUIRES that they are not parallel.
Point2 ray_meets_line(const Point2& eye, const Point2& through, const Point2& a, const Point2& b) {
  const Rational wx = b.x - a.x, wy = b.y - a.y, rx = through.x - eye.x, ry = through.y - eye.y;
  const Rational t = ((a.x - eye.x) * wy - (a.y - eye.y) * wx) / (rx * wy - ry * wx);
  return {eye.x + t * rx, eye.y + t * ry};
}

// Moves `origin` by distance * unit, both exact to 2^-100 or so, and rounds; nothing where an error of `error` could
// change the result.
std::optional<double> moved(const DoubleDouble& origin, double distance, double rest, const DoubleDouble& unit,
                            double error) {
  double p, e, s, t;
  two_product(distance, unit.hi, p, e);
  e += distance * unit.lo + rest * unit.hi;
  two_sum(origin.hi, p, s, t);
  t += e + origin.lo;
  double hi, lo;
  two_sum(s, t, hi, lo);
  if (hi + (lo - error) != hi || hi + (lo + error) != hi) return std::nullopt;
  return hi;
}

}  // namespace

CornerRounding2::CornerRounding2(const Arrangement2& arrangement)
    : arrangement_(arrangement), places_(arrangement.vertices().size()), lines_(arrangement.pieces()) {
  const Vertices2& vertices = arrangement.vertices();
  if (places_.empty()) return;
  constexpr std::size_t kGrain = 256;
  const auto place = [&](std::size_t k) { places_[k] = place_of(VertexId(k)); };
  parallel_for(places_.size(), place, kGrain);
  parallel_for(
      lines_.size(), [&](std::size_t k) { lines_[k] = line_of(k); }, kGrain);
  // In the unit, distances between points of the scene, which are below 2^(exponent + 1), have up to 61 bits.
  const int exponent = std::max(vertices.exponent(), 1);
  unit_bits_ = std::max(0, 55 - exponent);
  unit_in_scene_ = split(scaled_by_power_of_two(vertices.scale(), -unit_bits_));
  double extent = std::ldexp(to_double(vertices.scale()), exponent + 1);
  for (const Place& p : places_) extent = std::max({extent, std::fabs(p.scene_x.hi), std::fabs(p.scene_y.hi)});
  has_filter_ = exponent <= kPlaceBits && extent < 0x1p800 && unit_in_scene_.hi > 0x1p-800;
  error_ = extent * 0x1p-95;
}

CornerRounding2::Place CornerRounding2::place_of(VertexId v) const {
  const Vertices2& vertices = arrangement_.vertices();
  const Point2 p = vertices.exact(v), there = vertices.to_scene(p);
  Place place{0, 0, false, split(there.x), split(there.y)};
  place.is_integer =
      p.x.get_den() == 1 && p.y.get_den() == 1 && p.x.get_num().fits_slong_p() && p.y.get_num().fits_slong_p();
  if (place.is_integer) {
    place.x = p.x.get_num().get_si();
    place.y = p.y.get_num().get_si();
  }
  return place;
}

// The piece, or a surface that it is a part of: where surfaces cross, the ends of pieces are no integers, but those of
// surfaces are.
Segment2 CornerRounding2::line_of(std::size_t piece) const {
  const Vertices2& vertices = arrangement_.vertices();
  const Segment2& whole = arrangement_.pieces()[piece];
  const auto has_integers = [this](const Segment2& line) {
    return places_[line.a.index()].is_integer && places_[line.b.index()].is_integer;
  };
  if (has_integers(whole)) return whole;
  for (const PieceSource2& source : arrangement_.sources(piece)) {
    const Segment2& line = arrangement_.segment(source.surface);
    if (has_integers(line) && vertices.orientation(line.a, line.b, whole.a) == 0 &&
        vertices.orientation(line.a, line.b, whole.b) == 0)
      return line;
  }
  return whole;
}

EyeRounding2::EyeRounding2(const CornerRounding2& scene, const Point2& at, const Point2& point)
    : scene_(scene), at_(at), point_(point) {
  const mpz_srcptr numbers[] = {at.x.get_num_mpz_t(), at.x.get_den_mpz_t(), at.y.get_num_mpz_t(), at.y.get_den_mpz_t()};
  if (!scene.has_filter_ || !std::all_of(std::begin(numbers), std::end(numbers), mpz_fits_slong_p)) return;
  const std::int64_t of_x = mpz_get_si(numbers[1]), of_y = mpz_get_si(numbers[3]), factor = of_y / std::gcd(of_x, of_y);
  const Int128 denominator = static_cast<Int128>(of_x) * factor;
  const Int128 limit = static_cast<Int128>(1) << kEyeBits;
  if (denominator > limit >> scene.arrangement_.vertices().exponent()) return;
  const Int128 x = static_cast<Int128>(mpz_get_si(numbers[0])) * factor,
               y = static_cast<Int128>(mpz_get_si(numbers[2])) * static_cast<std::int64_t>(denominator / of_y);
  if (!is_below(x, limit) || !is_below(y, limit)) return;
  x_ = static_cast<std::int64_t>(x);
  y_ = static_cast<std::int64_t>(y);
  denominator_ = static_cast<std::int64_t>(denominator);
}

RoundedPoint2 EyeRounding2::operator()(const ViewCorner2& corner, RoundingCounts2& counts) const {
  if (corner.kind != Kind::kBehind) {
    ++counts.known;
    if (corner.kind == Kind::kEye) return {written_double(point_.x), written_double(point_.y)};
    const CornerRounding2::Place& place = scene_.places_[corner.vertex.index()];
    return {place.scene_x.hi, place.scene_y.hi};
  }
  if (const auto result = filtered(corner)) {
    ++counts.filtered;
    return *result;
  }
  ++counts.exact;
  const Point2 p = exact(corner);
  return {written_double(p.x), written_double(p.y)};
}

// With r = vertex - eye, w along the piece and a from the vertex to its line, the corner is vertex + r N / D, where
// N = a x w and D = r x w are integers (r times the denominator of the eye). A first guess m of a coordinate of r N / D
// in units of 2^-k comes from doubles: the roundings of N, D and r, one quotient and two products put it off by less
// than 2^-49 of itself, and the fraction that is dropped by one. The remainder r N 2^k - m D is below
// (2^-49 |m| + 2) D; where that is below 2^126 it is exact, though its terms are known modulo 2^128 only. Divided by D,
// which puts it off by 2^-49 of itself at the most, it is the rest of the coordinate. The rest is below 2^-49 of the
// extent and 2 units, so that it is off by 2^-97 of the extent at the most: an extent has 2^56 units and more. The way
// to the scene adds a few times 2^-106 of the extent.
std::optional<RoundedPoint2> EyeRounding2::filtered(const ViewCorner2& corner) const {
  if (denominator_ == 0) return std::nullopt;
  const Segment2& line = scene_.lines_[piece_of(corner.on)];
  const auto &v = scene_.places_[corner.vertex.index()], &a = scene_.places_[line.a.index()],
             &b = scene_.places_[line.b.index()];
  if (!v.is_integer || !a.is_integer || !b.is_integer) return std::nullopt;
  const std::int64_t wx = b.x - a.x, wy = b.y - a.y;
  const std::int64_t rx = denominator_ * v.x - x_, ry = denominator_ * v.y - y_;
  Int128 n = static_cast<Int128>(a.x - v.x) * wy - static_cast<Int128>(a.y - v.y) * wx;
  Int128 d = static_cast<Int128>(rx) * wy - static_cast<Int128>(ry) * wx;
  if (d < 0) {
    d = -d;
    n = -n;
  }
  if (d == 0) return std::nullopt;
  const double divisor = near(d), inverse = 1 / divisor, quotient = near(n) * inverse;
  const double unit = static_cast<double>(std::int64_t{1} << scene_.unit_bits_);
  const auto coordinate = [&](std::int64_t r, const DoubleDouble& origin) -> std::optional<double> {
    const auto guess = static_cast<std::int64_t>(static_cast<double>(r) * quotient * unit);
    const auto distance = static_cast<double>(guess);
    if (!((std::fabs(distance) * 0x1p-49 + 2) * divisor < 0x1p125)) return std::nullopt;
    const Int128 whole = static_cast<Int128>(static_cast<UInt128>(wrapped_product(n, r)) << scene_.unit_bits_);
    const double rest = near(wrapped_difference(whole, wrapped_product(d, guess))) * inverse;
    return moved(origin, distance, rest, scene_.unit_in_scene_, scene_.error_);
  };
  // Along an axis a coordinate is that of the piece, or of the vertex.
  const auto x = wx == 0   ? std::optional(a.scene_x.hi)
                 : rx == 0 ? std::optional(v.scene_x.hi)
                           : coordinate(rx, v.scene_x);
  if (!x) return std::nullopt;
  const auto y = wy == 0   ? std::optional(a.scene_y.hi)
                 : ry == 0 ? std::optional(v.scene_y.hi)
                           : coordinate(ry, v.scene_y);
  if (!y) return std::nullopt;
  return RoundedPoint2{*x, *y};
}

Point2 EyeRounding2::exact(const ViewCorner2& corner) const {
  if (corner.kind == Kind::kEye) return point_;
  const Vertices2& vertices = scene_.arrangement_.vertices();
  const Point2 through = vertices.exact(corner.vertex);
  if (corner.kind == Kind::kVertex) return vertices.to_scene(through);
  const Segment2& piece = scene_.arrangement_.piece(corner.on);
  return vertices.to_scene(ray_meets_line(at_, through, vertices.exact(piece.a), vertices.exact(piece.b)));
}

}  // namespace hottel
