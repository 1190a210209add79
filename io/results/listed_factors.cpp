#include "io/results/listed_factors.h"

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"

namespace hottel {

std::vector<std::string> csv_names(const ExchangeMatrix& matrix) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) names.push_back(csv_field(matrix.name(i)));
  return names;
}

std::string area_of(const ExchangeMatrix& matrix, std::uint32_t label) {
  return "the area of '" + matrix.name(label) + "'";
}

}  // namespace hottel
