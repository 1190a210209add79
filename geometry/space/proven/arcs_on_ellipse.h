// What the integrand of a part is at most on ellipses about the part. Internal to geometry/space.
#pragma once

#include <vector>

#include "geometry/space/proven/part_arcs.h"

namespace hottel {

// Where the squares of all vectors are zero nowhere on an ellipse, the formula of arcs is one analytic function there.
//
// b and e are at right angles to n. So with R^2 = b^2 e^2, X = n . (b x e) / |n| and Y = b . e it is X^2 + Y^2 = R^2,
// and the angle, -i log((Y + i X) / R), is singular nowhere else. It changes by
//   angle' = n . (e x e' / e^2 - b x b' / b^2) / |n|,
// and so is no more than in the middle and the way from there times that.
class ArcsOnEllipse3 {
 public:
  // REQUIRES: all that the part is of outlives what is asked of it.
  void set(const PartArcs3& part);

  // As VectorOnEllipse3 has it, of all vectors.
  double reach() const { return reach_; }
  // No less than the formula is anywhere on the ellipse of that half axis; infinite where nothing is known.
  double largest(double half_axis);
  // Of each arc the sign that its angle has wherever on the part it is more than a right angle; 0 where that is not
  // known: by how fast angles change on an ellipse of which the largest is known.
  void find_turns(double half_axis, std::vector<signed char>& turns);

 private:
  // An angle in the middle of the part: at most, and its sign where it is more than a right angle; 0 where that is not
  // known.
  struct Middle {
    double most;
    int sign;
  };
  // Of a plane: what the moment comes to along the unit normal, and how much longer the normal is, over the root of its
  // square, than that, at most.
  struct Normal {
    double moment, excess;
  };
  Middle middle(const SeenArc3& arc) const;
  void set_bounds(double half_axis);
  // How fast the angle changes at most; as set_bounds() has it.
  double speed(const SeenArc3& arc) const;

  PartArcs3 part_;
  std::vector<VectorOnEllipse3> planes_, corners_;
  std::vector<Middle> middles_;
  std::vector<Normal> normals_;
  std::vector<double> turns_;         // of corners
  double reach_ = 0, half_axis_ = 0;  // of what the bounds are
};

}  // namespace hottel
