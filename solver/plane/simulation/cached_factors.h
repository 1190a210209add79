// View factors of scenes in the plane that are kept in a store.
#pragma once

#include "geometry/exchange_request.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/store.h"

namespace hottel {

// What is kept of a scene's factors by a method.
//
//   (1) exact ones of faces and elements: each pair serves whatever run has both of its elements
//   (2) those of other methods depend on all elements: they serve runs with the same ones
StoreTable store_table_2(const ExchangeMethod2& method, const PreparedScene2& prepared, const ExchangeRequest& request);

// The factors as factors_by() returns them, bit for bit, from the store where all are there. Else they are computed,
// all together, and those that were missing are kept. Of what is read the report has no tiers, gaps and terms. Throws
// as factors_by() and FactorStore do.
ComputedFactors2 cached_factors_2(FactorStore& store, const ExchangeMethod2& method, const PreparedScene2& prepared,
                                  const ExchangeRequest& request);

}  // namespace hottel
