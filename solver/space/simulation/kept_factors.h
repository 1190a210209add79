// View factors of scenes in space that are kept in a store.
#pragma once

#include <functional>

#include "geometry/space/exchange/exchange_rows.h"
#include "solver/space/methods/computed_factors.h"
#include "solver/space/methods/exchange_method.h"
#include "solver/store.h"

namespace hottel {

// What is kept of a scene's exact factors: each pair serves whatever run has both of its elements, and the tolerance.
StoreTable store_table_3(const ExchangeRows3& rows, const PreparedScene3& prepared, const ExchangeRequest& request);
// What is kept of its factors by another method: they serve runs with the same elements.
StoreTable store_table_3(const ExchangeMethod3& method, const PreparedScene3& prepared, const ExchangeRequest& request);

// Takes pairs that are kept into rows of which none has come yet. Returns how many exchange light.
std::uint64_t take_kept(FactorStore& store, const StoreTable& table, const ExchangeRequest& request,
                        ExchangeRows3& rows);

// Keeps pairs that have come, but those that were taken, and those of elements whose pair with the sky could not be
// measured. REQUIRES that none is missing, and what take_kept() returned.
void keep_rows(FactorStore& store, const StoreTable& table, const ExchangeRequest& request, const ExchangeRows3& rows,
               std::uint64_t taken);

// The factors by a method that is not exact, as `compute` returns them: from the store where all are there, bit for
// bit; else computed and kept.
ComputedFactors3 kept_factors_3(FactorStore& store, const ExchangeMethod3& method, const PreparedScene3& prepared,
                                const ExchangeRequest& request, const std::function<ComputedFactors3()>& compute);

}  // namespace hottel
