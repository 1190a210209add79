// Means that stay within what they are of.
#pragma once

#include <algorithm>
#include <limits>

namespace hottel {

// The mean of values by weights.
//
//   (1) it is between the least and the largest of the values, also as rounded; equal values are their mean exactly
// Degenerate: of no values, or of weights that are all 0, it is NaN.
class BoundedMean {
 public:
  // REQUIRES a weight that is not negative, and a value that is a number.
  void add(double value, double weight) {
    sum_ += weight * value;
    weight_ += weight;
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }
  double value() const {
    return weight_ > 0 ? std::clamp(sum_ / weight_, least_, most_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  double sum_ = 0, weight_ = 0;
  double least_ = std::numeric_limits<double>::infinity(), most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace hottel
