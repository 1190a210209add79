#include "viewer/edit/plane/rotation.h"

#include <numbers>

#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "viewer/edit/decimals.h"

namespace hottel {

Rotation2::Rotation2(const Point2& centre, const Rational& degrees, int decimals)
    : centre_(centre), decimals_(decimals) {
  Integer quarters;
  const Rational turns = degrees / 90;
  mpz_fdiv_q(quarters.get_mpz_t(), turns.get_num_mpz_t(), turns.get_den_mpz_t());
  quarters_ = mpz_fdiv_ui(quarters.get_mpz_t(), 4);
  const Rational rest = degrees - 90 * Rational(quarters);
  is_exact_ = rest == 0;
  const double radians = to_double(rest) * std::numbers::pi / 180;
  cosine_ = exact_value(is_exact_ ? 1 : same_bits::cos(radians));
  sine_ = exact_value(is_exact_ ? 0 : same_bits::sin(radians));
}

Point2 Rotation2::operator()(const Point2& p) const {
  Point2 way{p.x - centre_.x, p.y - centre_.y};
  if (!is_exact_) way = {cosine_ * way.x - sine_ * way.y, sine_ * way.x + cosine_ * way.y};
  for (unsigned long k = 0; k < quarters_; ++k) way = {-way.y, way.x};
  Point2 turned{centre_.x + way.x, centre_.y + way.y};
  if (!is_exact_) turned = {rounded_decimal(turned.x, decimals_), rounded_decimal(turned.y, decimals_)};
  return turned;
}

}  // namespace hottel
