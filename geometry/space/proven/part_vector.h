// Vectors along a part of a stretch, and what they come to on ellipses about it. Internal to geometry/space.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/space/proven/proven_vector.h"

namespace hottel {

// power[0] + x power[1] + x^2 power[2], where x is -1 at the beginning of a part and 1 at its end. Each power is no
// further than its error from the true one, as a vector.
struct PartVector3 {
  std::array<LocalVector3<double>, 3> power;
  std::array<double, 3> error{}, size{};  // size: the lengths of the powers

  PartVector3() = default;
  // Along the part from `low` on, of that half length as a double tells it.
  PartVector3(const ProvenVector3<double>& vector, double low, double half);

  bool is_linear() const { return size[2] == 0; }
  // Where doubles make it at an x from -1 to 1 that is off by 3 units itself, it is off by no more than these times 1,
  // |x| and x^2.
  std::array<double, 3> off_at_nodes() const;
};

// What a vector comes to on the ellipses with foci -1 and 1, filled, by their half axis from focus to focus. Where its
// square v . v is zero nowhere on one, the root of that is one analytic function there.
//
// The square is v . v at 0 times factors 1 + a x + b x^2, whose zeros are a number and its conjugate, but for what is
// left of it. Half the sum of the distances from the foci to a zero is as far as ellipses reach; and an ellipse is no
// nearer to the zero than what that is more than its half axis.
class VectorOnEllipse3 {
 public:
  explicit VectorOnEllipse3(const PartVector3& vector);

  // The half axis of the ellipse through the nearest zero of the square, about: no ellipse that anyone asks for where
  // there is none near.
  double reach() const { return reach_; }

  struct Bounds {
    double most = 0;  // |v| is no more, nor is it further off than the second
    double off = 0;
    double least_square = 0;  // |v . v| is no less; nothing is known where it is not positive
    double turn = 0;          // |v x v'| is no more
  };
  Bounds within(double half_axis) const;

 private:
  // 1 + linear x + square x^2, without zeros on the axis.
  struct Factor {
    double linear = 0, square = 0;
    double root = 0;    // of `square`
    double ends = 1;    // the half axis of the ellipse through the zeros, times `root`
    double height = 1;  // how far these are from the axis, times `root`
  };
  static Factor factor(double linear, double square);

  double first_ = 0;  // the square at 0
  std::array<Factor, 2> factors_;
  std::array<double, 5> rest_{};  // what the product of factors leaves of the square, over `first_`
  std::array<double, 3> size_, error_, turn_{};
  double reach_ = 0;
};

}  // namespace hottel
