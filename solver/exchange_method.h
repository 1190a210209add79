// What all methods for view factors have in common, exact or approximate, in the plane and in space.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "solver/compare/method_report.h"

namespace hottel {

// A method for the view factors of a prepared scene.
//
//   (1) rows and columns are prepared.elements(request.granularity)->elements(), in that order;
//       the sky is the last column;
//       an element has a row iff it has one in the exact matrix
//   (2) the same call gives the same matrix bit for bit, for any number of threads
//   (3) a matrix that is not kExact does not tell on which side the true values are: FactorEntry::factor.side is 0
//   (4) by elements, |F_ij - exact F_ij| <= claimed_errors(prepared)(i, j) for every pair, and <= declared_error where
//       there is one
//   (5) a method that looks in all directions measures the sky as it does faces
//   (6) a method that looks at pairs only has no entry for the sky in rows of elements inside closed walls; for an
//       element that borders the open space the factor of the sky is max(0, 1 - the sum of the others). So inside
//       closed walls the row defect shows the whole error of a row sum;
//       in the open it shows only whether the sum is above 1
//   (7) factors_of_pairs(), if there are any, are the entries of compute() by elements, bit for bit
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

  // The factors F(from, to) of two different elements, the first of which has a row; several threads may ask at once. A
  // factor that is not above 0 is no entry. Null if the factors of the method depend on more than the two elements and
  // what stands between them. REQUIRES that the method and `prepared` outlive what is returned. COST: linear, and then
  // what the method takes for each pair that is asked for.
  using FactorsOfPairs = std::function<double(std::uint32_t from, std::uint32_t to)>;
  virtual FactorsOfPairs factors_of_pairs(const Prepared&) const { return nullptr; }

  // True iff rows of faces and groups are sums of rows of the elements into which the scene divides its surfaces. Then
  // the scene must be prepared with these elements, whatever rows are asked for.
  virtual bool works_by_elements() const { return false; }

  // True iff memory does not grow with the pairs: they are on disk, before and after they are a matrix.
  virtual bool keeps_pairs_on_disk() const { return false; }

  // A bound on the largest error of the method on a scene, known before it runs: it follows from the method's reference
  // and the scene's geometry. Nothing if the method claims nothing.
  virtual std::optional<double> declared_error(const Prepared& prepared) const = 0;

  // The same for every factor F(from, to), the sky included; infinity if nothing is claimed. By default it is
  // declared_error() for all. REQUIRES that the method and `prepared` outlive what is returned.
  using ClaimedErrors = std::function<double(std::uint32_t from, std::uint32_t to)>;
  virtual ClaimedErrors claimed_errors(const Prepared& prepared) const {
    const double of_all = declared_error(prepared).value_or(std::numeric_limits<double>::infinity());
    return [of_all](std::uint32_t, std::uint32_t) { return of_all; };
  }
};

}  // namespace hottel
