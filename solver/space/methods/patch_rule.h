// Gauss points on convex patches.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/space/point.h"
#include "solver/methods/gauss_rule.h"
#include "solver/space/methods/element_geometry.h"

namespace hottel {

// A point of a patch: the mean of up to four of its corners, by shares that sum to 1.
//
//   (1) the first share is what the others leave of 1, exactly: so the point is on the plane of the patch
struct RulePoint3 {
  std::array<std::size_t, 4> corner{0, 0, 0, 0};
  std::array<double, 4> share{1, 0, 0, 0};
  Vector3d at;        // in doubles
  double weight = 0;  // of the area of the patch; those of all points sum to 1 but for rounding
};

// Returns n x n points on a patch of four corners, else on each of the triangles at its first corner, n the points of
// the rule: the product rule, of a triangle in Duffy's coordinates (s, t) -> s (1 - t) a + s t b.
//
//   (1) exact for polynomials of degree 2 n - 2 on triangles and parallelograms
// SEE: Duffy, Quadrature over a pyramid or cube of integrands with a singularity at a vertex, 1982.
std::vector<RulePoint3> rule_points(const ElementPatch3& patch, const GaussRule& rule);

// Returns the point in scene coordinates, exactly on the plane of its patch, from the exact corners of that.
Point3 exact_point(std::span<const Point3> corners, const RulePoint3& point);

}  // namespace hottel
