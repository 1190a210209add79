// Dense elimination of the components of a radiosity system, each kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/lazy.h"

namespace hottel {

// Elimination without subtraction: off-diagonal magnitudes and row defects only ever grow, and each pivot is the sum
// of its row (Grassmann, Taksar, Heyman 1985). Every entry is right to a few hundred ulps however near to 1 the
// reflectivities are; the last unknown is the constant, found from the sum of all defects.
//
//   (1) a component is eliminated when it is first wanted, and never again; what comes of it does not depend on others
//   (2) one whose areas, couplings or losses leave the range of doubles is not solved: it stays 0
// All may be called by many threads at once.
// REQUIRES rows that are closed and that outlive it. COST: n^3 / 3 for a component of n unknowns, once, in dense
// blocks, and 8 n^2 bytes.
class Elimination {
 public:
  Elimination(const SymmetricRows& rows, std::size_t components);
  ~Elimination();

  // What solves the wanted components. It is not to outlive this.
  std::unique_ptr<const ApproximateInverse> of(const std::vector<char>& is_wanted) const;

 private:
  class DenseComponent;
  class Wanted;

  const SymmetricRows& rows_;
  std::vector<std::vector<std::uint32_t>> members_;  // by component, in the order in which they are eliminated
  std::vector<std::uint32_t> place_;                 // by unknown: among the members of its component
  std::vector<Lazy<DenseComponent>> eliminated_;
};

}  // namespace hottel
