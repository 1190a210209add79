// A turn in the plane, as a hand does it.
#pragma once

#include "geometry/plane/point.h"

namespace hottel {

// A turn counter-clockwise around a point.
//
//   (1) by multiples of 90 degrees exactly
//   (2) otherwise every point is rounded to `decimals` decimals, the same point always to the same one
class Rotation2 {
 public:
  Rotation2(const Point2& centre, const Rational& degrees, int decimals);

  Point2 operator()(const Point2& p) const;

 private:
  Point2 centre_;
  int decimals_;
  unsigned long quarters_ = 0;
  bool is_exact_ = true;
  Rational cosine_, sine_;
};

}  // namespace hottel
