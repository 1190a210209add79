// View factors in space by any method, with what is to be said of them.
#pragma once

#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/exchange/exchange_report.h"

namespace hottel {

// View factors and how they came about.
struct ComputedFactors3 {
  ExchangeMatrix matrix;
  ExchangeReport3 report;
  std::vector<std::string> notes;  // where the method is not exact: the first is a sentence about it

  double row_defect() const { return report.max_defect; }  // the largest, before rows were divided by their sums
};

}  // namespace hottel
