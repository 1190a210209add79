// Approximate inverses of a radiosity system, to be refined and certified by others.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// A correction in doubles: x_i = constant[component of i] + rest[i]. The constant is 0 where the rest is as large.
struct Correction {
  std::vector<double> constant, rest;
};

// Solves A x = r about as well as doubles allow, for any number of right sides. Only wanted components are solved;
// the others stay 0.
class ApproximateInverse {
 public:
  virtual ~ApproximateInverse() = default;
  // Returns x for a right side by unknown. REQUIRES one number for each unknown of the system.
  virtual Correction solve(const std::vector<double>& r) = 0;
};

// Elimination without subtraction: off-diagonal magnitudes and row defects only ever grow, and each pivot is the sum
// of its row (Grassmann, Taksar, Heyman 1985). Every entry is right to a few hundred ulps however near to 1 the
// reflectivities are; the last unknown is the constant, found from the sum of all defects.
// solve() may be called by many threads at once.
// A component whose areas, couplings or losses leave the range of doubles is not solved: it stays 0.
// REQUIRES rows that are closed. COST: n^3 / 3 for a component of n unknowns, in dense blocks, and 8 n^2 bytes.
std::unique_ptr<ApproximateInverse> make_elimination(const RadiositySystem& system, const std::vector<char>& is_wanted);

// Conjugate gradients on the symmetric form, preconditioned by the diagonal, the constant of each component deflated.
// `history`, when given, gets max |residual| / max |right side| of the first solve, the start included.
// REQUIRES rows that are closed.
struct CgLimits {
  int iterations = 5000;
  double until = 1e-10;  // relative, of the largest residual
};
std::unique_ptr<ApproximateInverse> make_conjugate_gradient(const RadiositySystem& system,
                                                            const std::vector<char>& is_wanted, CgLimits limits = {},
                                                            std::vector<double>* history = nullptr);

// I - rho F as it is: LU with partial pivoting, or BiCGSTAB, whose diagonal is 1 already.
std::unique_ptr<ApproximateInverse> make_lu(const PlainSystem& system, std::size_t components);
std::unique_ptr<ApproximateInverse> make_bicgstab(const PlainSystem& system, std::size_t components,
                                                  CgLimits limits = {}, std::vector<double>* history = nullptr);

}  // namespace hottel
