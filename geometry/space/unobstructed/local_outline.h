// The outline of a part of a pair, in any Real, and the cells for integrals over its area.
#pragma once

#include <array>
#include <vector>

#include "geometry/space/unobstructed/local_pair.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// Corners in local coordinates times 2^-exponent, each off by at most what is told of it.
//
//   (1) is_exact: no corner of the pair is off, nor is any difference of two of them
//   (2) all points of the part are within radius of centre, and no coordinate is above size: as they are, not as
//   rounded
template <class Real>
struct LocalOutline3 {
  LocalOutline3(const LocalPair3& pair, int side, int exponent);

  std::vector<LocalVector3<Real>> corners;
  std::vector<double> off;
  bool is_exact = false;
  LocalVector3<Real> centre;
  double radius = 0, size = 0, most_off = 0;
};

// A part of it: the image of the unit square under a bilinear map; where two corners are one, a triangle. The density
// of area is linear in each coordinate: that of the parallelogram of the sides at a corner.
template <class Real>
struct PatchCell3 {
  std::array<std::size_t, 4> corner;  // of the outline
  std::array<Approximation<Real>, 4> density;
  double most_density = 0;  // at most
};

template <class Real>
std::vector<PatchCell3<Real>> cells_of(const LocalOutline3<Real>& outline);

// The shares of the four corners of a cell in a node of it: node a of a rule along its first side, node b of one along
// the next.
template <class Real>
std::array<Real, 4> shares_of_corners(const std::vector<Real>& along, std::size_t a, const std::vector<Real>& across,
                                      std::size_t b) {
  const Real s = along[a], t = across[b], s1 = along[along.size() - 1 - a], t1 = across[across.size() - 1 - b];
  return {s1 * t1, s * t1, s * t, s1 * t};
}

// The sum of shares times values: off by the shares of their errors and by 7 roundoffs.
template <class Real>
Approximation<Real> mixed(const std::array<Real, 4>& share, const std::array<Approximation<Real>, 4>& values) {
  Approximation<Real> result;
  for (std::size_t c = 0; c < 4; ++c) {
    result.value += share[c] * values[c].value;
    result.error += static_cast<double>(share[c]) * values[c].error;
  }
  result.error += 7 * kRoundoff<Real> * static_cast<double>(result.value);
  return result;
}

}  // namespace hottel
