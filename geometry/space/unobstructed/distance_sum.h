// Sums over points of weights over distances. Internal to geometry/space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/space/vectors/local_vector.h"
#include "kernel/legendre_rule.h"

namespace hottel {

// A quadrilateral, the image of the unit square under a bilinear map, with the height and the density of area at its
// corners: both are linear in each coordinate.
struct WeightedCell3 {
  std::array<LocalVector3<double>, 4> corner;
  std::array<Approximation<double>, 4> height, density;
};

// Points with weights, each coordinate by itself, so that several terms are made at once.
struct WeightedPoints3 {
  std::vector<double> x, y, z, weight;

  std::size_t size() const { return weight.size(); }

  // Appends the points of a cell at the nodes of two rules, one along its first side and one along the next; the weight
  // of a point is the product of those of the rules, height and density. Adds to `off` what the weights are off by.
  //
  //   (1) the same bits on every processor
  //
  // COST: some 5 ns a point.
  void add(const WeightedCell3& cell, const LegendreRule<double>& along, const LegendreRule<double>& across,
           double& off);
};

// Returns the sum of weight / distance^4 from a point to all of these: of four sums over every fourth one, added up in
// pairs.
//
//   (1) the same bits on every processor
//
// COST: some 1 ns a point.
double sum_over_fourth_powers(const LocalVector3<double>& from, const WeightedPoints3& points);

}  // namespace hottel
