// Approximate inverses of a radiosity system, to be refined and certified by others.
#pragma once

#include <memory>
#include <vector>

#include "solver/radiosity/radiosity_system.h"
#include "solver/radiosity/symmetric_rows.h"

namespace hottel {

// A correction in doubles: x_i = constant[component of i] + rest[i]. The constant is 0 where the rest is as large.
struct Correction {
  std::vector<double> constant, rest;
};

// Solves A x = r about as well as doubles allow, for any number of right sides. Only wanted components are solved;
// the others stay 0.
//
//   (1) solve() may be called by many threads at once, unless there is a history
//   (2) components whose right sides are 0 do not change what becomes of the others
class ApproximateInverse {
 public:
  virtual ~ApproximateInverse() = default;
  // Returns x for a right side by unknown. REQUIRES one number for each unknown of the system.
  virtual Correction solve(const std::vector<double>& r) const = 0;
};

// Conjugate gradients on the symmetric form, preconditioned by the diagonal, the constant of each component deflated.
// `history`, when given, gets max |residual| / max |right side| of each solve, the start included. `others` multiply
// some rows (null: none do): the same bits with and without.
// REQUIRES rows that are closed; these and the others outlive it.
struct CgLimits {
  int iterations = 5000;
  double until = 1e-10;  // relative, of the largest residual
};
std::unique_ptr<const ApproximateInverse> make_conjugate_gradient(const SymmetricRows& rows,
                                                                  const std::vector<char>& is_wanted,
                                                                  CgLimits limits = {},
                                                                  std::vector<double>* history = nullptr,
                                                                  SharedRows* others = nullptr);

// I - rho F as it is: LU with partial pivoting, which needs the system no more, or BiCGSTAB, whose diagonal is 1
// already.
std::unique_ptr<const ApproximateInverse> make_lu(const PlainSystem& system, std::size_t components);
std::unique_ptr<const ApproximateInverse> make_bicgstab(std::shared_ptr<const PlainSystem> system,
                                                        std::size_t components, CgLimits limits = {},
                                                        std::vector<double>* history = nullptr,
                                                        SharedRows* others = nullptr);

}  // namespace hottel
