// Sums over points of weights over distances. Internal to geometry/space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// Points with weights, each coordinate by itself, so that several terms are made at once.
struct WeightedPoints3 {
  std::vector<double> x, y, z, weight;

  void reserve(std::size_t count);
  void add(const LocalVector3<double>& at, double w);
};

// Returns the sum of weight / distance^4 from a point to all of these: of four sums over every fourth one, added up in
// pairs.
//
//   (1) the same bits on every processor
//
// COST: some 1 ns a point.
double sum_over_fourth_powers(const LocalVector3<double>& from, const WeightedPoints3& points);

}  // namespace hottel
