// View factors by any method, as they are asked for and with what is to be said of them.
#pragma once

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"

namespace hottel {

template <class Prepared>
class ExchangeMethod;
struct ExchangeRequest;
struct PreparedScene2;

// What a method made of a scene, for a report. Where the method is not exact the notes begin with a sentence about it.
struct ComputedFactors2 {
  ExchangeMatrix matrix;
  MethodReport report;

  double row_defect() const { return report.row_defect; }  // the largest, before rows were divided by their sums
};

// View factors by a method. Throws RequestError naming the scene, and the method unless it is exact, when it cannot be
// run.
ComputedFactors2 factors_by(const ExchangeMethod<PreparedScene2>& method, const PreparedScene2& prepared,
                            const ExchangeRequest& request);

}  // namespace hottel
