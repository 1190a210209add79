#include "geometry/space/scene/near_plane.h"

#include <algorithm>

#include "geometry/space/scene/bent_loops.h"

namespace hottel {
namespace {

constexpr long kUnits = 4, kPartOfDiameter = 10'000, kPlacesOfRounding = 40;

}  // namespace

void FinestDigit3::take(std::string_view number) {
  if (number.find('/') != std::string_view::npos) return;
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, e);
  long exponent = 0;
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos)
    exponent -= static_cast<long>(digits.size() - point - 1);
  if (e < number.size())
    if (const auto shift = parse_rational(number.substr(e + 1)); shift) exponent += shift->get_num().get_si();
  exponent_ = std::min(exponent, exponent_.value_or(exponent));
}

Rational FinestDigit3::unit() const {
  if (!exponent_) return 0;
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(*exponent_ < 0 ? -*exponent_ : *exponent_));
  return *exponent_ < 0 ? Rational(1, power) : Rational(power);
}

Rational float_spacing(const Polygon3& polygon, int digits) {
  Rational largest;
  for (const Point3& p : corners_of(polygon))
    for (const Rational* coordinate : {&p.x, &p.y, &p.z}) largest = std::max(largest, Rational(abs(*coordinate)));
  if (largest == 0) return 0;
  // 2^e <= largest < 2^(e + 1)
  long e = static_cast<long>(mpz_sizeinbase(largest.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(largest.get_den_mpz_t(), 2));
  if (scaled_by_power_of_two(1, e) > largest) --e;
  return scaled_by_power_of_two(1, e - digits + 1);
}

bool accept_nearly_plane(Polygon3& polygon, const Rational& unit) {
  polygon.is_nearly_plane = false;
  const std::vector<std::vector<Point3>> loops = loops_of(polygon);
  if (std::any_of(loops.begin(), loops.end(), [](const auto& loop) { return loop.size() < 3; })) return false;
  const std::vector<Point3> points = corners_of(polygon);
  if (points.size() < 4 || are_in_one_plane(points)) return false;
  const Bend3 bend = bend_of(points);
  const Rational& off = bend.squared_distance;
  const bool is_rounding = off <= scaled_by_power_of_two(bend.squared_diameter, -2 * kPlacesOfRounding);
  const bool is_of_digits =
      off <= kUnits * kUnits * unit * unit && off * (kPartOfDiameter * kPartOfDiameter) <= bend.squared_diameter;
  polygon.is_nearly_plane = (is_rounding || is_of_digits) && !triangles_of_loops(loops).empty();
  return polygon.is_nearly_plane;
}

}  // namespace hottel
