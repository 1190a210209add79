// Sums of areas of polygons in space.
#pragma once

#include <map>

#include "kernel/enclosure.h"
#include "kernel/rational.h"

namespace hottel {

// A sum q_1 sqrt(s_1) + ... + q_n sqrt(s_n) of areas, each a multiple q of the length of an integer normal whose square
// is s.
class AreaSum3 {
 public:
  // REQUIRES share > 0 and squared_normal > 0.
  void add(const Rational& share, const Integer& squared_normal) { shares_[squared_normal] += share; }

  // Returns unit * sum, correctly rounded. REQUIRES unit > 0, and that something was added.
  // COST: a few microseconds a term; more where the sum is a double or half-way between two.
  Rounded rounded(const Rational& unit) const;

  friend bool operator==(const AreaSum3&, const AreaSum3&) = default;

 private:
  std::map<Integer, Rational> shares_;
};

}  // namespace hottel
