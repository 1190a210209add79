// View factors of scenes in space that are kept in a store.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

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

// Keeps pairs by (i, j), and that the others of `known` exchange nothing. Returns how many exchange light. REQUIRES
// that all are of `known`.
std::uint64_t keep_pairs(FactorStore& store, const StoreTable& table, const ExchangeRequest& request,
                         std::span<const PairSum3> pairs, const PairRanges& known);

// The factors by a method that is not exact, as `compute` returns them: from the store where all are there, bit for
// bit; else computed and kept.
ComputedFactors3 cached_factors_3(FactorStore& store, const ExchangeMethod3& method, const PreparedScene3& prepared,
                                  const ExchangeRequest& request, const std::function<ComputedFactors3()>& compute);

}  // namespace hottel
