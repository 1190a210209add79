// Radiosities where doubles give no bounds, or wide ones: elimination in high precision.
#pragma once

#include <vector>

#include "kernel/enclosure.h"
#include "solver/radiosity/certificate.h"
#include "solver/radiosity/lazy.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

inline constexpr std::uint32_t kMostEliminatedUnknowns = 2000;

// Bounds that need no certificate, for whatever losses, areas and conditioning. With a_ij = rho_i F_ij and l_i what row
// i loses, B = N / D, where D is a sum of products, all positive, with one a_ij or l_i from each row, and N one of
// products with none from one row and one from each other (matrix-tree theorem). If all a_ij and l_i of row i are known
// within (1 +- e_i) and s = sum e_i < 1, B is known within (1 - s)^2 to (1 - s)^-2; sources only add.
//
// Components are eliminated without subtraction, in numbers of 256 bits with exponents of 64, whose roundings are
// counted in s.
//
//   (1) the bounds hold; they are about n 2^-52 wide, relatively, for n unknowns whose factors are no denormal doubles
//   (2) those of components with a factor that underflows are [0, infinity], as are those of more than
//       kMostEliminatedUnknowns
// narrow() may be called by many threads at once. REQUIRES rows that are closed.
// COST: for each component that needs it n^3 / 3 wide products, once (2 s for 500 unknowns, 2 min for 2000), and 64 n^2
// bytes.
class HighPrecisionElimination {
 public:
  explicit HighPrecisionElimination(const RadiositySystem& system);
  ~HighPrecisionElimination();

  // Narrows the bounds in lit components in which an upper one is infinite or, if wanted, any is wider than 2^-44 of
  // itself (n 2^-50 for many unknowns), however small that is. They are then in units of their own. A value outside is
  // replaced by the middle, or kept and enclosed too.
  struct Wanted {
    bool narrow = true;        // not only open bounds are narrowed
    bool keeps_value = false;  // bounds are widened to hold the value
  };
  void narrow(const Sources& sources, const Wanted& wanted, CertifiedBounds& bounds) const;

 private:
  class Component;
  const Component& eliminated(std::uint32_t component) const;

  const RadiositySystem& system_;
  std::vector<Lazy<Component>> components_;
};

// Throws RequestError, naming a face, where an upper bound is infinite.
void require_bounds(const RadiositySystem& system, const CertifiedBounds& bounds);

}  // namespace hottel
