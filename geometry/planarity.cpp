#include "geometry/planarity.h"

#include <algorithm>

namespace hottel {
namespace {

constexpr long kUnits = 4, kPartOfDiameter = 10'000, kPartOfPatch = 100, kPlacesOfRounding = 40;

}  // namespace

void FinestDigit::take(std::string_view number) {
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

Rational FinestDigit::unit() const {
  if (!exponent_) return 0;
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(*exponent_ < 0 ? -*exponent_ : *exponent_));
  return *exponent_ < 0 ? Rational(1, power) : Rational(power);
}

bool is_within_planarity(const Rational& squared_distance, const Rational& squared_diameter, const Rational& unit) {
  if (squared_distance <= scaled_by_power_of_two(squared_diameter, -2 * kPlacesOfRounding)) return true;
  return squared_distance <= kUnits * kUnits * unit * unit &&
         squared_distance * (kPartOfDiameter * kPartOfDiameter) <= squared_diameter;
}

bool is_within_seat(const Rational& squared_distance, const Rational& squared_patch, const Rational& squared_base,
                    const Rational& unit) {
  return squared_distance * (kPartOfPatch * kPartOfPatch) <= squared_patch &&
         is_within_planarity(squared_distance, std::max(squared_patch, squared_base), unit);
}

}  // namespace hottel
