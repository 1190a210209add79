// The sums of a request, in memory.
#pragma once

#include <cstdint>

#include "geometry/exchange_report.h"
#include "geometry/exchange_request.h"
#include "geometry/plane/exchange/pair_sums.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// Whether a sweep finds them: in a convex room strings do, unless a sweep is asked for.
bool sweeps(const PreparedScene2& prepared, const ExchangeRequest& request);

// Returns what sum_visible_pairs or sum_convex_pairs returns, and sets gaps, terms and seconds of the report.
// Throws RequestError where pairs of so many bytes each take more memory than the request allows: by an estimate before
// the work, and by their number during it. parts: as of sum_visible_pairs().
PairSums2 requested_sums(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request,
                         std::uint64_t bytes_per_pair, ExchangeReport& report, SweepParts2* parts = nullptr);

// Sets what a report says of scene and elements.
void report_scene(const PreparedScene2& prepared, const ElementTable2& table, ExchangeReport& report);

}  // namespace hottel
