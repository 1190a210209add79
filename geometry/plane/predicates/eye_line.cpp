#include "geometry/plane/predicates/eye_line.h"

#include <numeric>
#include <optional>

namespace hottel {
namespace {

// A point with one denominator for both coordinates.
struct Fraction2 {
  Int128 x, y, denominator;
};

// Differences of two numbers below this are below 2^62, products of two of them below 2^124.
constexpr Int128 kLimit = static_cast<Int128>(1) << 61;

bool is_small(Int128 value) { return -kLimit < value && value < kLimit; }

}  // namespace

int EyeLine2::exact_side(VertexId v) const {
  const auto fraction = [](const Eye2& eye) -> std::optional<Fraction2> {
    const EyeCoordinate2 &x = *eye.exact_x_, &y = *eye.exact_y_;
    if (x.denominator_ == 0 || y.denominator_ == 0) return std::nullopt;
    const std::int64_t factor = y.denominator_ / std::gcd(x.denominator_, y.denominator_);
    const Int128 denominator = static_cast<Int128>(x.denominator_) * factor;
    if (!is_small(denominator)) return std::nullopt;
    return Fraction2{static_cast<Int128>(x.numerator_) * factor,
                     static_cast<Int128>(y.numerator_) * static_cast<std::int64_t>(denominator / y.denominator_),
                     denominator};
  };
  const auto p = fraction(*from_), q = fraction(*to_);
  if (p && q && is_small(p->x) && is_small(p->y) && is_small(q->x) && is_small(q->y)) {
    const Vertices2::Small& r = from_->vertices_->small_[v.index()];
    const Int128 factors[] = {q->x * p->denominator, p->x * q->denominator, q->y * p->denominator,
                              p->y * q->denominator, r.x * p->denominator,  r.y * p->denominator};
    bool all_are_small = true;
    for (const Int128 factor : factors) all_are_small &= is_small(factor);
    if (all_are_small) {
      const Int128 determinant =
          (factors[0] - factors[1]) * (factors[5] - p->y) - (factors[2] - factors[3]) * (factors[4] - p->x);
      return (determinant > 0) - (determinant < 0);
    }
  }
  const Rational &px = from_->exact_x_->exact_, &py = from_->exact_y_->exact_;
  const Point2 r = from_->vertices_->exact(v);
  const Rational left = (to_->exact_x_->exact_ - px) * (r.y - py), right = (to_->exact_y_->exact_ - py) * (r.x - px);
  const int order = cmp(left, right);
  return (order > 0) - (order < 0);
}

}  // namespace hottel
