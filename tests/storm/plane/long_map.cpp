#include "tests/storm/plane/long_map.h"

#include <utility>

namespace hottel::storm {

namespace {

mpz_class power_of_ten(unsigned long digits) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
  return power;
}

// An integer of so many digits.
mpz_class long_integer(std::mt19937_64& random, unsigned long digits) {
  mpz_class result = 0;
  for (unsigned long words = 0; words < digits; words += 19) {
    result <<= 64;
    result += mpz_class(random() >> 1) * 2 + 1;
  }
  const mpz_class least = power_of_ten(digits - 1);
  return least + result % (9 * least);
}

// Positive numbers of one scene: all decimals, or all fractions.
class LongNumbers {
 public:
  explicit LongNumbers(std::mt19937_64& random)
      : random_(random), are_decimals_(random() % 2 == 0), digits_(30 + random() % 91) {}

  mpq_class operator()() {
    const mpz_class above = long_integer(random_, digits_);
    mpq_class result(above, are_decimals_ ? power_of_ten(digits_ - random_() % 10) : long_integer(random_, digits_));
    result.canonicalize();
    return result;
  }

 private:
  std::mt19937_64& random_;
  bool are_decimals_;
  unsigned long digits_;
};

}  // namespace

LongMap long_similarity(std::mt19937_64& random, bool turns) {
  LongNumbers number(random);
  const mpq_class a = number(), b = turns ? number() : mpq_class(0);
  return {a, -b, b, a, number(), -number()};
}

LongMap long_affine_map(std::mt19937_64& random) {
  LongNumbers number(random);
  LongMap map{number(), number(), number(), number(), -number(), number()};
  if (map.a * map.d < map.b * map.c) {
    std::swap(map.a, map.c);
    std::swap(map.b, map.d);
  }
  return map;
}

}  // namespace hottel::storm
