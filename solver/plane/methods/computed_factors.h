// View factors by any method, as they are asked for and with what is to be said of them.
#pragma once

#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// What a method made of a scene, for a report. Where the method is not exact the notes begin with a sentence about it.
struct ComputedFactors2 {
  ExchangeMatrix matrix;
  MethodReport report;

  double row_defect() const { return report.row_defect; }  // the largest, before rows were divided by their sums
};

// View factors by a method. Throws RequestError naming the scene, and the method unless it is exact, when it cannot be
// run.
ComputedFactors2 factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared,
                            const ExchangeRequest& request);

}  // namespace hottel
