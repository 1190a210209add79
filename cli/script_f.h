// --script-f of hottel factors: gray-body exchange factors in place of view factors.
#pragma once

#include <vector>

#include "cli/factors_options.h"
#include "cli/streams.h"
#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "io/results/gray_report.h"

namespace hottel {

struct GrayFactors {
  ExchangeMatrix matrix;
  int channel = 0;  // whose reflectivities these are
  GrayReport report;
};

// Returns script-F of the view factors of a scene. Throws RequestError where materials of faces are not gray and no
// channel is chosen, and as gray_exchange() does, naming the scene's file.
GrayFactors gray_factors(const FactorsOptions& options, const ExchangeMatrix& matrix,
                         const std::vector<Material>& materials, const Streams& streams);

}  // namespace hottel
