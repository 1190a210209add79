// What all ways to compute view factors have in common, exact or approximate, in whatever dimension.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "solver/compare/method_report.h"

namespace hottel {

// A way to compute the view factors of a prepared scene.
//
//   (1) rows and columns are prepared.elements(request.granularity)->elements(), in that order; a row is there iff the
//   exact
//       matrix has it; the sky is a column
//   (2) the same call gives the same matrix bit for bit, for any number of threads
//   (3) a matrix that is not kExact says nothing of its factors' true values: FactorEntry::factor.side is 0
//   (4) by elements, |F_ij - exact F_ij| <= claimed_errors(prepared)(i, j) for every pair, and <= declared_error where
//       there is one
//   (5) a method that looks into every direction says how much of the sky it sees
//   (6) a method that looks at pairs only has no entry for the sky in the rows of elements inside closed walls; where
//       an element borders the open space the sky gets max(0, 1 - the sum of its other factors). So the row defect
//       shows all that is wrong with the sum of a row inside closed walls, and of one in the open whether it sums to
//       more than 1
//   (7) factors_of_pairs(), where there are any, are the entries of compute() by elements, bit for bit
template <class Prepared>
class ExchangeMethod {
 public:
  virtual ~ExchangeMethod() = default;
  // Name, family, guarantee and reference: what the method says of itself, on any scene.
  virtual const MethodInfo& info() const = 0;

  // Computes the view factors, and fills `report`. Throws RequestError when the method cannot be run on the scene, and
  // passes on what the request's progress throws.
  virtual ExchangeMatrix compute(const Prepared& prepared, const ExchangeRequest& request,
                                 MethodReport& report) const = 0;

  // The factors F(from, to) of two different elements, of which the first has a row, for several threads at once; one
  // that is not above 0 is no entry. Nothing of a method whose factors depend on more than the two elements and what
  // stands between them. REQUIRES that the method and `prepared` outlive what is returned. COST: linear, and then what
  // the method takes for each pair that is asked for.
  using FactorsOfPairs = std::function<double(std::uint32_t from, std::uint32_t to)>;
  virtual FactorsOfPairs factors_of_pairs(const Prepared&) const { return nullptr; }

  // True iff rows of faces and groups are put together from those of the elements that the scene asks for: then the
  // scene is to be prepared with them, whatever rows are asked for.
  virtual bool works_by_elements() const { return false; }

  // True iff memory does not grow with the pairs: they are on disk, before and after they are a matrix.
  virtual bool keeps_pairs_on_disk() const { return false; }

  // What the method claims of its largest error on a scene, before it is run: a bound that follows from its reference
  // and the scene's geometry. Nothing where the method claims nothing.
  virtual std::optional<double> declared_error(const Prepared& prepared) const = 0;

  // The same for every factor F(from, to), the sky included; infinity where nothing is claimed. Unless a method knows
  // better it claims of each what it claims of all. REQUIRES that the method and `prepared` outlive what is returned.
  using ClaimedErrors = std::function<double(std::uint32_t from, std::uint32_t to)>;
  virtual ClaimedErrors claimed_errors(const Prepared& prepared) const {
    const double of_all = declared_error(prepared).value_or(std::numeric_limits<double>::infinity());
    return [of_all](std::uint32_t, std::uint32_t) { return of_all; };
  }
};

}  // namespace hottel
