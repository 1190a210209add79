// What is worth keeping of the approximate inverses of one radiosity system.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/elimination.h"
#include "solver/radiosity/lazy.h"

namespace hottel {

// Approximate inverses for the components that are wanted. Made when they are asked for; what takes long is kept: each
// component that was eliminated; the symmetric rows of conjugate gradients; and where rows are not symmetric, which are
// factored all at once, what belongs to the components that were wanted last.
//
//   (1) what is returned is a function of the system and of what is asked for, never of what was asked before
//   (2) may be called by many threads at once
// The inverses are not to outlive this. `others`: as make_conjugate_gradient() and certify() have them. REQUIRES that
// the system outlives it.
class CachedInverses {
 public:
  explicit CachedInverses(const RadiositySystem& system) : system_(system) {}

  // For rows that are closed.
  std::shared_ptr<const ApproximateInverse> elimination(const std::vector<char>& is_wanted) const;
  std::shared_ptr<const ApproximateInverse> conjugate_gradient(const std::vector<char>& is_wanted, CgLimits limits = {},
                                                               std::vector<double>* history = nullptr,
                                                               SharedRows* others = nullptr) const;
  // For any rows.
  std::shared_ptr<const PlainSystem> plain(const std::vector<char>& is_wanted) const;
  std::shared_ptr<const ApproximateInverse> lu(const std::vector<char>& is_wanted) const;
  // Null where rows lose too little light for it (single_precision_lu.h).
  std::shared_ptr<const ApproximateInverse> single_precision_lu(const std::vector<char>& is_wanted) const;
  std::shared_ptr<const ApproximateInverse> bicgstab(const std::vector<char>& is_wanted, CgLimits limits = {},
                                                     std::vector<double>* history = nullptr,
                                                     SharedRows* others = nullptr) const;
  // What spectral_radius_is_below_one() says (certificate.h), by lu(), single_precision_lu() where there is one, or
  // bicgstab() without limits.
  bool light_dies_out(const std::vector<char>& is_wanted, const ApproximateInverse& inverse,
                      SharedRows* others = nullptr) const;

 private:
  struct Plain;
  const SymmetricRows& rows() const;
  std::shared_ptr<Plain> last(const std::vector<char>& is_wanted) const;

  const RadiositySystem& system_;
  Lazy<SymmetricRows> rows_;
  Lazy<Elimination> elimination_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<Plain> last_;
};

}  // namespace hottel
