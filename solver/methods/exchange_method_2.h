// What all ways to compute view factors have in common, exact or approximate.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange/exchange_2.h"
#include "kernel/enclosure.h"

namespace hottel {

// What a method says of itself.
struct MethodInfo {
  std::string name;      // in full, variant and parameter included: "gauss:4:normalised"
  std::string family;    // what a sweep of the parameter belongs to: "gauss"
  double parameter = 0;  // points, pixels, rays; 0 when there is none
  Guarantee guarantee = Guarantee::kEstimated;
  std::string reference;  // who described it, and where
};

// How a matrix came about.
struct MethodReport {
  double row_defect = 0;                 // max |sum_j F_ij - 1| as computed, before any normalisation
  std::optional<double> standard_error;  // of the worst factor, where the method is random
  std::optional<double> seconds;         // where the method knows better than who called it (an outside command)
  std::vector<std::string> notes;        // e.g. the seed
};

// A way to compute the view factors of the elements of a prepared scene.
//
//   (1) the elements are those of Labels2(scene, arrangement, division, Per::kElement), in that order; a row is there
//       iff the exact matrix has it; the sky is a column
//   (2) the same call gives the same matrix bit for bit, for any number of threads
//   (3) a matrix that is not kExact says nothing of its factors' true values: FactorEntry::factor.side is 0
//   (4) max |F - exact F| <= declared_error, on scenes for which one is declared
class ExchangeMethod2 {
 public:
  virtual ~ExchangeMethod2() = default;
  virtual const MethodInfo& info() const = 0;

  // Throws RequestError when the method cannot be run on the scene.
  virtual ExchangeMatrix compute(const PreparedScene2& prepared, MethodReport& report) const = 0;

  // What the method claims of its largest error on a scene, before it is run: a bound that follows from its reference
  // and the scene's geometry. Nothing where the method claims nothing.
  virtual std::optional<double> declared_error(const PreparedScene2& prepared) const = 0;
};

}  // namespace hottel
