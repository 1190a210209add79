// What comparing methods came to, as JSON and as text for people.
#pragma once

#include <span>
#include <string>

#include "solver/compare/work_precision.h"
#include "solver/plane/compare/method_comparison.h"

namespace hottel {

// Everything that is said about one run of `compare`.
struct ComparisonReport2 {
  std::string scene;
  const MethodComparison2& comparison;
  std::span<const MethodResult> results;
  std::span<const WorkReading> readings;  // times at which errors are reached
};

// Returns the report as one JSON object and a final newline.
std::string comparison_json(const ComparisonReport2& report);

// Returns the table with its size above it, notes (each once, with the methods it is said of) and readings below it.
std::string comparison_text(const ComparisonReport2& report);

// Returns an aligned table, a line a method, with the spread of the times.
std::string compare_table(std::span<const MethodResult> results);

// "812 elements, 5852 view factors": elements that have a row, and the factors in these rows.
std::string size_text(const ExchangeMatrix& matrix);

}  // namespace hottel
