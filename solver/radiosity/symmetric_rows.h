// The symmetric form of a radiosity system in doubles: rows times A_i / rho_i.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/shared_work.h"
#include "kernel/support/unset_array.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// K = D + L: couplings S_ij = A_i F_ij between different unknowns (equal to S_ji but for roundings), defects d_i = A_i
// (loss_i / rho_i + sum of F_ij over all that is known), areas in units of the largest of the component.
//
//   (K x)_i = d_i x_i + sum_j S_ij (x_i - x_j)
//
//   (1) defects and couplings are not below 0 where factors are not; weight_i = A_i / rho_i, finite also for tiny rho
// REQUIRES rows that are closed. COST: two passes over the matrix, on all threads; 12 bytes a coupling.
struct SymmetricRows {
  std::vector<std::size_t> begin;  // by unknown, one more at the end
  UnsetArray<std::uint32_t> to;    // by entry, as the one below; they stand where the matrix does
  UnsetArray<double> coupling_of;
  std::vector<double> coupling, defect, weight;  // by unknown; coupling is the sum of its entries
  std::vector<std::uint32_t> component;

  // One row for each unknown of the system, whose matrix is not needed afterwards.
  explicit SymmetricRows(const RadiositySystem& system);
  // Sets K x for some unknowns, each row summed in the order of its columns. COST: one pass over their entries, on all
  // threads.
  void multiply(const WorkRange& unknowns, const std::vector<double>& x, std::vector<double>& result) const;

 private:
  void set_row(const RadiositySystem& system, std::size_t i, double largest);
};

// Light stays so long that a constant is huge to what is sent out.
inline bool is_huge(double constant, double right_side) { return std::abs(constant) > 0x1p24 * right_side; }

// Whether the solution of a component is to be kept as a constant and differences to it, or as values.
//
//   (1) differences as large as the constant are not kept: they would cost the digits of what is far from the light
//   (2) where light stays so long that the constant is huge, values would cost the digits of the differences: the
//       constant is kept then, unless some value is very much smaller than it
class FormOfSolution {
 public:
  // Takes in one unknown of the component: x = constant + difference, and its right side.
  void meet(double constant, double difference, double right_side) {
    largest_difference_ = std::max(largest_difference_, std::abs(difference));
    least_value_ = std::min(least_value_, std::abs(constant + difference));
    right_side_ = std::max(right_side_, std::abs(right_side));
  }
  // Whether the constant is to be kept, after all unknowns have been met. Without any it is.
  bool keeps(double constant) const {
    const double size = std::abs(constant);
    return largest_difference_ <= size / 2 || (is_huge(constant, right_side_) && least_value_ > 0x1p-10 * size);
  }

 private:
  double largest_difference_ = 0, least_value_ = std::numeric_limits<double>::infinity(), right_side_ = 0;
};

}  // namespace hottel
