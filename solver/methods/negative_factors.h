// Matrices that nothing can be solved with.
#pragma once

#include <string>

#include "geometry/exchange_matrix.h"

namespace hottel {

// Throws RequestError, naming file, method and element, where a factor is negative: nothing can be solved then.
void require_not_negative(const ExchangeMatrix& matrix, const std::string& file, const std::string& method);

}  // namespace hottel
