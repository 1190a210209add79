// The symmetric form of a radiosity system in doubles: rows times A_i / rho_i.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/system/radiosity_system.h"

namespace hottel {

// K = D + L: couplings S_ij = A_i F_ij between different unknowns (equal to S_ji but for roundings), defects
// d_i = A_i (loss_i / rho_i + sum of F_ij over all that is known), areas in units of the largest.
//
//   (K x)_i = d_i x_i + sum_j S_ij (x_i - x_j)
//
// REQUIRES rows that are closed.
struct SymmetricRows {
  std::vector<std::size_t> begin;  // by unknown, one more at the end
  std::vector<std::uint32_t> to;
  std::vector<double> coupling_of;               // by entry
  std::vector<double> coupling, defect, weight;  // by unknown; coupling is the sum of its entries
  std::vector<std::uint32_t> component;

  explicit SymmetricRows(const RadiositySystem& system);
};

}  // namespace hottel
