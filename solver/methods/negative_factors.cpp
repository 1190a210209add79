#include "solver/methods/negative_factors.h"

#include <fmt/format.h>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

void require_not_negative(const ExchangeMatrix& matrix, const std::string& file, const std::string& method) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.factor.value < 0)
        throw RequestError(fmt::format("{}: the method {}: a factor of '{}' is negative ({}): nothing can be solved",
                                       file, method, matrix.elements()[i].name, shortest(entry.factor.value)));
}

}  // namespace hottel
