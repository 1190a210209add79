#include "geometry/plane/predicates/vertices.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <span>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A small coordinate: differences stay below 2^61, squared distances below 2^123.
constexpr std::size_t kSmallBits = 60;

std::size_t bits(const Integer& value) { return value == 0 ? 0 : mpz_sizeinbase(value.get_mpz_t(), 2); }

template <class Number>
int sign_of(const Number& value) {
  return (value > 0) - (value < 0);
}

// Least common denominator of the coordinates, and the largest common factor of their numerators over it.
struct CommonScale {
  Integer denominator = 1;
  Integer factor = 0;
  bool is_bounded = true;  // false: the denominator grew beyond any use and was given up

  void include_denominator(const Rational& value) {
    if (!is_bounded) return;
    if (mpz_divisible_p(denominator.get_mpz_t(), value.get_den_mpz_t())) return;
    denominator = lcm(denominator, value.get_den());
    is_bounded = bits(denominator) <= 40000;
  }
  void include_factor(const Rational& value) {
    if (factor == 1) return;
    factor = gcd(factor, Integer(value.get_num() * (denominator / value.get_den())));
  }
};

double nearest(const Rational& value, int shift) { return to_double(scaled_by_power_of_two(value, -shift)); }

// Position of the leading bit of |value|: |value| < 2^result.
int exponent_above(const Rational& value) {
  if (value == 0) return 0;
  return static_cast<int>(bits(Integer(abs(value.get_num())))) - static_cast<int>(bits(value.get_den())) + 1;
}

// value * 2^shift rounded to an integer, for |value * 2^shift| < 2^126.
Int128 to_fixed(double value, int shift) {
  int exponent;
  const double mantissa = std::frexp(value, &exponent);
  const auto integer = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int left = exponent - 53 + shift;
  if (left >= 0) return static_cast<Int128>(integer) << left;
  if (left < -60) return 0;
  return (static_cast<Int128>(integer) + (static_cast<Int128>(1) << (-left - 1))) >> -left;
}

// Points in words, where coordinates as they are typed fit: what big numbers come to, without them.
class SmallScale {
 public:
  // Translates by the first point and divides by the common measure of the first `typed` coordinates. Returns the
  // integers, x and y in turn; nothing where words do not suffice, or others than the typed ones are no integers then.
  std::optional<std::vector<std::int64_t>> apply(const std::vector<Point2>& points, std::size_t typed) {
    for (std::size_t i = 0; i < typed; ++i)
      for (const Rational* value : {&points[i].x, &points[i].y})
        if (!include_denominator(*value)) return std::nullopt;
    std::vector<std::int64_t> result;
    result.reserve(2 * points.size());
    for (const Point2& p : points)
      for (const Rational* value : {&p.x, &p.y}) {
        const auto scaled = over_denominator(*value);
        if (!scaled) return std::nullopt;
        result.push_back(*scaled - (result.size() < 2 ? 0 : result[result.size() % 2]));
      }
    result[0] = result[1] = 0;
    std::int64_t factor = 0;
    for (std::size_t k = 0; k < 2 * typed && factor != 1; ++k) factor = std::gcd(factor, result[k]);
    if (factor == 0) return std::nullopt;
    for (std::int64_t& value : result) {
      if (factor != 1 && value % factor != 0) return std::nullopt;
      value /= factor;
      if (value >= kLimit || value <= -kLimit) return std::nullopt;
    }
    unit_ = Rational(Integer(static_cast<long>(factor)), Integer(static_cast<long>(denominator_)));
    unit_.canonicalize();
    return result;
  }
  const Rational& unit() const { return unit_; }

 private:
  static constexpr std::int64_t kLimit = std::int64_t{1} << kSmallBits;

  bool include_denominator(const Rational& value) {
    if (!mpz_fits_slong_p(value.get_den_mpz_t())) return false;
    const auto own = static_cast<std::int64_t>(mpz_get_si(value.get_den_mpz_t()));
    if (denominator_ % own == 0) return true;
    const Int128 common = static_cast<Int128>(denominator_ / std::gcd(denominator_, own)) * own;
    if (common >= kLimit) return false;
    denominator_ = static_cast<std::int64_t>(common);
    return true;
  }
  // The numerator of the value over the common denominator, below 2^62.
  std::optional<std::int64_t> over_denominator(const Rational& value) const {
    if (!mpz_fits_slong_p(value.get_num_mpz_t()) || !mpz_fits_slong_p(value.get_den_mpz_t())) return std::nullopt;
    const auto own = static_cast<std::int64_t>(mpz_get_si(value.get_den_mpz_t()));
    if (denominator_ % own != 0) return std::nullopt;
    const Int128 scaled = static_cast<Int128>(denominator_ / own) * mpz_get_si(value.get_num_mpz_t());
    if (scaled >= 4 * kLimit || scaled <= -4 * kLimit) return std::nullopt;
    return static_cast<std::int64_t>(scaled);
  }

  std::int64_t denominator_ = 1;
  Rational unit_ = 1;
};

}  // namespace

Vertices2::Vertices2(const std::vector<Point2>& points, std::size_t typed) {
  if (points.empty()) return;
  origin_ = points.front();
  SmallScale words;
  if (const auto coordinates = words.apply(points, typed)) {
    scale_ = words.unit();
    set_small(*coordinates);
  } else {
    scale_big(points, typed);
  }
  double extent = 0;
  for (const Approximate& p : approximate_) extent = std::max({extent, std::fabs(p.x), std::fabs(p.y)});
  const double difference = 2 * (extent + input_error_);  // of two coordinates, at most
  error_anywhere_ = 2.0000001 * difference * (kOrientationError * difference + 2 * input_error_);
  set_total_length(1);
}

// Takes coordinates in integer form, x and y in turn.
void Vertices2::set_small(std::span<const std::int64_t> coordinates) {
  small_.resize(coordinates.size() / 2);
  approximate_.resize(small_.size());
  bool all_are_doubles = true;
  for (std::size_t i = 0; i < small_.size(); ++i) {
    const auto [x, y] = small_[i] = {coordinates[2 * i], coordinates[2 * i + 1]};
    const Approximate& p = approximate_[i] = {static_cast<double>(x), static_cast<double>(y)};
    all_are_doubles &= static_cast<std::int64_t>(p.x) == x && static_cast<std::int64_t>(p.y) == y;
    for (const std::int64_t value : {x, y})
      coordinate_bits_ =
          std::max(coordinate_bits_, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(value)))));
  }
  input_error_ = all_are_doubles ? 0 : std::ldexp(1.0, coordinate_bits_ - 53) * 2.0000001;
}

// The same by big rationals, whatever the coordinates.
void Vertices2::scale_big(const std::vector<Point2>& points, std::size_t typed) {
  std::vector<Point2> shifted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) shifted[i] = {points[i].x - origin_.x, points[i].y - origin_.y};

  const auto common_scale = [&shifted](std::size_t count) {
    CommonScale common;
    for (std::size_t i = 0; i < count; ++i) {
      common.include_denominator(shifted[i].x);
      common.include_denominator(shifted[i].y);
    }
    if (common.is_bounded)
      for (std::size_t i = 0; i < count && common.factor != 1; ++i) {
        common.include_factor(shifted[i].x);
        common.include_factor(shifted[i].y);
      }
    if (common.factor == 0) common.factor = 1;
    return common;
  };
  const auto apply = [this, &shifted](const CommonScale& common) {
    if (!common.is_bounded) return false;
    Rational factor(common.denominator, common.factor);
    factor.canonicalize();
    for (Point2& p : shifted) {
      p.x *= factor;
      p.y *= factor;
    }
    scale_ /= factor;
    return true;
  };
  const auto has_small_form = [&shifted] {
    return std::all_of(shifted.begin(), shifted.end(), [](const Point2& p) {
      return p.x.get_den() == 1 && p.y.get_den() == 1 && bits(p.x.get_num()) <= kSmallBits &&
             bits(p.y.get_num()) <= kSmallBits;
    });
  };

  apply(common_scale(typed));
  bool small = has_small_form();
  if (!small && typed < points.size()) {
    const CommonScale all = common_scale(points.size());
    if (all.is_bounded && bits(all.denominator) <= kSmallBits) {
      apply(all);
      small = has_small_form();
    }
  }

  if (small) {
    std::vector<std::int64_t> coordinates;
    coordinates.reserve(2 * shifted.size());
    for (const Point2& p : shifted)
      for (const Rational* value : {&p.x, &p.y}) coordinates.push_back(value->get_num().get_si());
    set_small(coordinates);
    return;
  }
  int& top = coordinate_bits_;
  for (const Point2& p : shifted) top = std::max({top, exponent_above(p.x), exponent_above(p.y)});
  approximate_.resize(points.size());
  large_ = std::move(shifted);
  low_.resize(points.size());
  approximation_shift_ = top - 53;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto split = [this](const Rational& value, double& hi, double& lo) {
      hi = nearest(value, approximation_shift_);
      const Rational back = scaled_by_power_of_two(exact_value(hi), approximation_shift_);
      lo = nearest(value - back, approximation_shift_);
    };
    split(large_[i].x, approximate_[i].x, low_[i].x);
    split(large_[i].y, approximate_[i].y, low_[i].y);
  }
  // |approximate| < 2^53, so its error is at most 1/2; low repeats the argument one level down: at most 2^-54.
  input_error_ = 1.0000001;
}

void Vertices2::set_total_length(double diameters) {
  double extent = 1;
  for (const Approximate& p : approximate_) extent = std::max({extent, std::fabs(p.x), std::fabs(p.y)});
  // Every distance is below 3 extents; twice the total stays below 2^124 units.
  int bits_above;
  std::frexp(3 * extent * std::max(1.0, diameters), &bits_above);
  fixed_bits_ = 123 - bits_above;
  // Small form: half a unit for dropping bits, less than 1.5 for the root.
  // Large form: the low parts are off by 2^-54 at most, four of them enter; the double-double root is good to 2^-98.
  length_error_ = is_small() ? 2 : std::ldexp(0x1p-51 + std::ldexp(extent, -97), fixed_bits_) + 4;
}

int Vertices2::exact_orientation(VertexId i, VertexId j, VertexId k) const {
  if (is_small()) {
    const Small &p = small_[i.index()], &q = small_[j.index()], &r = small_[k.index()];
    return sign_of(static_cast<Int128>(q.x - p.x) * (r.y - p.y) - static_cast<Int128>(q.y - p.y) * (r.x - p.x));
  }
  const Point2 &p = large_[i.index()], &q = large_[j.index()], &r = large_[k.index()];
  const Rational left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
  return sign_of(cmp(left, right));
}

int Vertices2::direction_sign(VertexId i, VertexId j, VertexId k) const {
  if (is_small()) {
    const Small &p = small_[i.index()], &q = small_[j.index()], &r = small_[k.index()];
    return sign_of(static_cast<Int128>(q.x - p.x) * (r.x - p.x) + static_cast<Int128>(q.y - p.y) * (r.y - p.y));
  }
  const Point2 &p = large_[i.index()], &q = large_[j.index()], &r = large_[k.index()];
  const Rational product = (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
  return sgn(product);
}

bool Vertices2::is_between(VertexId i, VertexId j, VertexId k) const { return direction_sign(k, i, j) < 0; }

FixedLength2 Vertices2::distance(VertexId i, VertexId j) const {
  return is_small() ? small_distance(i, j) : large_distance(i, j);
}

// The integer N = dx² + dy² is scaled by 4^h to 124 or 125 bits. A double gives its root to 53 bits, the integer S up
// to 2^10.2; with R = N - S² the rest of the root is R / (2 S), off by less than three units of 2^-40 in doubles. What
// is left of R then gives the root to 2^-62.
FixedLength2 Vertices2::small_distance(VertexId i, VertexId j) const {
  const Small to = small(j), from = small(i);
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  const UInt128 squared =
      static_cast<UInt128>(static_cast<Int128>(dx) * dx) + static_cast<UInt128>(static_cast<Int128>(dy) * dy);
  if (squared == 0) return {0, true};
  const auto high = static_cast<std::uint64_t>(squared >> 64);
  const int width =
      high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(static_cast<std::uint64_t>(squared));
  const int half_shift = (125 - width) / 2;
  const auto n = static_cast<Int128>(squared << (2 * half_shift));
  const double approximate = static_cast<double>(static_cast<std::int64_t>(n >> 62)) * 0x1p62;
  const double near_root = std::sqrt(approximate);
  const auto root = static_cast<std::int64_t>(near_root);
  const Int128 remainder = n - static_cast<Int128>(root) * root;
  const double inverse = near_root * (0.5 / approximate);  // the division does not wait for the root
  const double rest = static_cast<double>(static_cast<std::int64_t>(remainder >> 11)) * (inverse * 0x1p51);
  auto coarse = static_cast<std::int64_t>(rest);  // in units of 2^-40
  // A root that is an integer is found as one.
  constexpr std::int64_t kOne = std::int64_t{1} << 40;
  if (((coarse + 4) & (kOne - 1)) <= 8) coarse = (coarse + kOne / 2) & -kOne;
  const Int128 left =
      (remainder << 40) - 2 * static_cast<Int128>(root) * coarse - ((static_cast<Int128>(coarse) * coarse) >> 40);
  const auto fine = static_cast<std::int64_t>(double_near(left) * (inverse * 0x1p22));
  const Int128 value = (static_cast<Int128>(root) << 62) + (static_cast<Int128>(coarse) << 22) + fine;
  const int drop = half_shift + 62 - fixed_bits_;
  const bool is_exact = left == 0 && (coarse & (kOne - 1)) == 0;
  return {(value + (static_cast<Int128>(1) << (drop - 1))) >> drop, is_exact};
}

FixedLength2 Vertices2::large_distance(VertexId i, VertexId j) const {
  const auto difference = [](double ahi, double alo, double bhi, double blo) {
    double s, e, t, f;
    two_sum(bhi, -ahi, s, e);
    two_sum(blo, -alo, t, f);
    e += t;
    double hi, lo;
    two_sum(s, e, hi, lo);
    return DoubleDouble{hi, lo + f};
  };
  const DoubleDouble dx =
      difference(approximate_[i.index()].x, low_[i.index()].x, approximate_[j.index()].x, low_[j.index()].x);
  const DoubleDouble dy =
      difference(approximate_[i.index()].y, low_[i.index()].y, approximate_[j.index()].y, low_[j.index()].y);
  double xx, xe, yy, ye, s, e;
  two_product(dx.hi, dx.hi, xx, xe);
  xe += 2 * dx.hi * dx.lo;
  two_product(dy.hi, dy.hi, yy, ye);
  ye += 2 * dy.hi * dy.lo;
  two_sum(xx, yy, s, e);
  e += xe + ye;
  if (s <= 0) return {0, false};
  const double root = std::sqrt(s);
  double rr, re;
  two_product(root, root, rr, re);
  const double correction = (((s - rr) - re) + e) / (2 * root);
  return {to_fixed(root, fixed_bits_) + to_fixed(correction, fixed_bits_), false};
}

int Vertices2::side_of_circle(VertexId i, VertexId j, VertexId k, VertexId l) const {
  const Approximate& d = approximate_[l.index()];
  const double ax = approximate_[i.index()].x - d.x, ay = approximate_[i.index()].y - d.y;
  const double bx = approximate_[j.index()].x - d.x, by = approximate_[j.index()].y - d.y;
  const double cx = approximate_[k.index()].x - d.x, cy = approximate_[k.index()].y - d.y;
  const double a = ax * ax + ay * ay, b = bx * bx + by * by, c = cx * cx + cy * cy;
  const double determinant = a * (bx * cy - cx * by) + b * (cx * ay - ax * cy) + c * (ax * by - bx * ay);
  const double permanent = a * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                           b * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                           c * (std::fabs(ax * by) + std::fabs(bx * ay));
  const double largest =
      std::max({std::fabs(ax), std::fabs(ay), std::fabs(bx), std::fabs(by), std::fabs(cx), std::fabs(cy)}) +
      2 * input_error_;
  // (10 + 96 u) u for the rounding (Shewchuk 1997, 4.3); each of 12 products of four differences moves by at most
  // 4 input errors times the cube of the largest one.
  const double bound = 1.2e-15 * permanent + 60 * input_error_ * largest * largest * largest;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  if (is_small() && largest < 0x1p28) {
    const auto dx = [&](VertexId v) { return small_[v.index()].x - small_[l.index()].x; };
    const auto dy = [&](VertexId v) { return small_[v.index()].y - small_[l.index()].y; };
    const std::int64_t pax = dx(i), pay = dy(i), pbx = dx(j), pby = dy(j), pcx = dx(k), pcy = dy(k);
    return sign_of(static_cast<Int128>(pax * pax + pay * pay) * (pbx * pcy - pcx * pby) +
                   static_cast<Int128>(pbx * pbx + pby * pby) * (pcx * pay - pax * pcy) +
                   static_cast<Int128>(pcx * pcx + pcy * pcy) * (pax * pby - pbx * pay));
  }
  const Point2 p = exact(i), q = exact(j), r = exact(k), s = exact(l);
  const Rational pax = p.x - s.x, pay = p.y - s.y, pbx = q.x - s.x, pby = q.y - s.y, pcx = r.x - s.x, pcy = r.y - s.y;
  const Rational value = (pax * pax + pay * pay) * (pbx * pcy - pcx * pby) +
                         (pbx * pbx + pby * pby) * (pcx * pay - pax * pcy) +
                         (pcx * pcx + pcy * pcy) * (pax * pby - pbx * pay);
  return sgn(value);
}

int Vertices2::compare_x(VertexId i, VertexId j) const {
  return is_small() ? sign_of(small_[i.index()].x - small_[j.index()].x)
                    : sign_of(cmp(large_[i.index()].x, large_[j.index()].x));
}

int Vertices2::compare_y(VertexId i, VertexId j) const {
  return is_small() ? sign_of(small_[i.index()].y - small_[j.index()].y)
                    : sign_of(cmp(large_[i.index()].y, large_[j.index()].y));
}

bool Vertices2::precedes(VertexId i, VertexId j) const {
  const int order = compare_x(i, j);
  return order != 0 ? order < 0 : compare_y(i, j) < 0;
}

Point2 Vertices2::exact(VertexId i) const {
  if (!is_small()) return large_[i.index()];
  return {Rational(Integer(static_cast<long>(small_[i.index()].x))),
          Rational(Integer(static_cast<long>(small_[i.index()].y)))};
}

Rational Vertices2::squared_distance(VertexId i, VertexId j) const {
  const Point2 p = exact(i), q = exact(j);
  const Rational dx = q.x - p.x, dy = q.y - p.y;
  return dx * dx + dy * dy;
}

Point2 Vertices2::to_scene(const Point2& p) const { return {origin_.x + scale_ * p.x, origin_.y + scale_ * p.y}; }

Point2 Vertices2::from_scene(const Point2& p) const { return {(p.x - origin_.x) / scale_, (p.y - origin_.y) / scale_}; }

Rational Vertices2::fixed_unit() const {
  return scaled_by_power_of_two(Rational(1), approximation_shift_ - fixed_bits_);
}

EyeCoordinate2::EyeCoordinate2(const Vertices2& vertices, const Rational& value) : exact_(value) {
  approximate_ = nearest(value, vertices.approximation_shift_);
  // A coordinate beyond the double range makes every bound infinite: the exact step decides.
  const bool is_exact =
      vertices.approximation_shift_ == 0 && std::isfinite(approximate_) && exact_value(approximate_) == value;
  error_ = std::max(vertices.input_error_, is_exact ? 0.0 : (std::fabs(approximate_) + 1) * 0x1p-52);
  constexpr std::size_t kLimit = 61;  // differences stay below 2^62, their products below 2^124
  if (vertices.is_small() && bits(value.get_num()) <= kLimit &&
      bits(value.get_den()) + static_cast<std::size_t>(vertices.coordinate_bits_) <= kLimit) {
    numerator_ = value.get_num().get_si();
    denominator_ = value.get_den().get_si();
  }
}

Eye2::Eye2(const Vertices2& vertices, const Point2& point)
    : Eye2(vertices, std::make_shared<const std::pair<EyeCoordinate2, EyeCoordinate2>>(
                         EyeCoordinate2(vertices, point.x), EyeCoordinate2(vertices, point.y))) {}

Eye2::Eye2(const Vertices2& vertices, std::shared_ptr<const std::pair<EyeCoordinate2, EyeCoordinate2>> own)
    : Eye2(vertices, own->first, own->second) {
  own_ = std::move(own);
}

int Eye2::exact_orientation(VertexId j, VertexId k) const {
  const EyeCoordinate2 &x = *exact_x_, &y = *exact_y_;
  if (x.denominator_ != 0 && y.denominator_ != 0) {
    const auto &q = vertices_->small_[j.index()], &r = vertices_->small_[k.index()];
    return sign_of(static_cast<Int128>(q.x * x.denominator_ - x.numerator_) * (r.y * y.denominator_ - y.numerator_) -
                   static_cast<Int128>(q.y * y.denominator_ - y.numerator_) * (r.x * x.denominator_ - x.numerator_));
  }
  const Point2 q = vertices_->exact(j), r = vertices_->exact(k);
  const Rational left = (q.x - x.exact_) * (r.y - y.exact_), right = (q.y - y.exact_) * (r.x - x.exact_);
  return sign_of(cmp(left, right));
}

int Eye2::direction_sign(VertexId j, VertexId k) const {
  const Point2 q = vertices_->exact(j), r = vertices_->exact(k);
  const Rational &x = exact_x_->exact_, &y = exact_y_->exact_;
  const Rational product = (q.x - x) * (r.x - x) + (q.y - y) * (r.y - y);
  return sgn(product);
}

bool Eye2::coincides_with(VertexId j) const {
  const Point2 q = vertices_->exact(j);
  return q.x == exact_x_->exact_ && q.y == exact_y_->exact_;
}

}  // namespace hottel
