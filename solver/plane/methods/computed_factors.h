// View factors by any method, as they are asked for and with what is to be said of them.
#pragma once

#include "geometry/plane/exchange/exchange.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// What a method made of a scene, for a report.
struct ComputedFactors2 {
  ExchangeMatrix matrix;
  ExchangeReport counts;  // of the scene and the matrix; no tiers, no gaps
  MethodReport report;    // the notes begin with one sentence about the method
};

// View factors by a method that is not `exact`, by elements of `prepared`, or put together per face or group.
//
//   (1) counts.pairs is the number of entries; counts.seconds has "prepare" and "factors", the latter as the method
//       tells it where it does
// Throws RequestError naming scene and method when it cannot be run.
ComputedFactors2 factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared, Granularity granularity);

// Throws RequestError, naming scene, method and element, where a factor is negative: nothing can be solved then.
void require_not_negative(const ExchangeMatrix& matrix, const PreparedScene2& prepared, const ExchangeMethod2& method);

}  // namespace hottel
