// View factors in space by any method: what is asked for, and what was computed, with what is to be said of it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "geometry/space/exchange/exchange_report.h"

namespace hottel {

template <class Prepared>
class ExchangeMethod;
class FactorStore;
class RowWatch3;
struct PreparedScene3;

// Which view factors are asked for, with the defaults.
struct FactorsRequest3 {
  // The method; null means "exact". Only the exact method has visibilities, measures and hidden pairs, and keeps to
  // `memory`.
  std::shared_ptr<const ExchangeMethod<PreparedScene3>> method = nullptr;
  // Not chosen by the scene, unlike in the plane: with kFace surfaces are whole, whatever Surface::elements says.
  Granularity granularity = Granularity::kFace;
  bool wants_visibility = false, wants_measures = false;  // beside the factors
  double tolerance = 1e-9;                                // as ExchangeRequest takes it
  SkyBy sky = SkyBy::kIntegral;                           // how factors of the sky are computed
  bool must_be_enclosed = false;                          // each pair within the tolerance; else RequestError
  // As ExchangeRequest takes them, for factors() and hidden() alone: system(), radiosities() and what is computed from
  // them throw UsageError unless all rows are chosen.
  RowChoice rows = {};
  // Bytes that factors may take; 0: four fifths of what is free when they are computed. Where they need more, factors()
  // throws RequestError.
  std::uint64_t memory = 0;
  // Chooses which rows are computed first, and is called as they are done, on the thread that computes them. Only the
  // exact method uses it. It changes no result, so requests that differ in it alone are equal.
  std::shared_ptr<RowWatch3> watch = nullptr;
  // Factors that it has are read from it, others are written to it once they are computed. No result depends on it. For
  // the program, as `watch` is: no installed header has these types.
  std::shared_ptr<FactorStore> store = nullptr;

  friend bool operator==(const FactorsRequest3& a, const FactorsRequest3& b) {
    return a.method == b.method && a.granularity == b.granularity && a.wants_visibility == b.wants_visibility &&
           a.wants_measures == b.wants_measures && a.tolerance == b.tolerance && a.sky == b.sky &&
           a.must_be_enclosed == b.must_be_enclosed && a.rows == b.rows && a.memory == b.memory;
  }
};

// View factors and how they came about.
struct ComputedFactors3 {
  ExchangeMatrix matrix;
  ExchangeReport3 report;
  std::vector<std::string> notes;  // where the method is not exact: the first is a sentence about it

  double row_defect() const { return report.max_defect; }  // the largest, before rows were divided by their sums
};

}  // namespace hottel
