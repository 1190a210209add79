// What a method told of a run, kept with its factors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"
#include "solver/store.h"

namespace hottel {

// The row of the sky that holds the report of a matrix: row defect, standard error and notes.
CachedRow report_to_keep(const ExchangeMatrix& matrix, const MethodReport& report);

// The report that is kept of rows of the same elements: what report_to_keep() wrote, and the pairs of the matrix.
// Nothing where it is missing.
std::optional<MethodReport> cached_report(const std::vector<CachedRows>& kept, const ExchangeMatrix& matrix);

// Unordered pairs of the matrix that exchange light, those with the sky among them.
std::uint64_t pair_count(const ExchangeMatrix& matrix);

}  // namespace hottel
