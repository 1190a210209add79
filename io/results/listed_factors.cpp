#include "io/results/listed_factors.h"

#include <cmath>

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "kernel/support/failure.h"

namespace hottel {

std::vector<std::string> csv_names(const ExchangeMatrix& matrix) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) names.push_back(csv_field(matrix.name(i)));
  return names;
}

void require_double(double value, const std::string& what) {
  if (!std::isfinite(value)) throw RequestError(what + " is beyond the range of doubles");
}

std::string area_of(const ExchangeMatrix& matrix, std::uint32_t label) {
  return "the area of '" + matrix.name(label) + "'";
}

}  // namespace hottel
