#include "solver/dividing/sampled_elements.h"

#include <random>

#include "kernel/support/failure.h"

namespace hottel {

std::vector<SampledElement> sampled_elements(const ExchangeMatrix& matrix, std::span<const double> importance,
                                             std::uint32_t most) {
  HOTTEL_REQUIRE(importance.size() == matrix.size());
  std::vector<SampledElement> rows;
  double all = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const double area = matrix.elements()[i].area.value;
    if (!matrix.has_row(i) || !(area > 0)) continue;
    rows.push_back({i, area});
    all += area * importance[i];
  }
  if (rows.size() <= most) return rows;
  std::vector<SampledElement> samples;
  if (!(all > 0)) return samples;
  std::mt19937_64 random(1);
  std::size_t row = 0;
  const auto share = [&] { return rows[row].weight * importance[rows[row].element]; };
  double passed = share();  // with that row
  for (std::uint32_t k = 0; k < most; ++k) {
    const double within = static_cast<double>(random() >> 11) * 0x1p-53;
    const double place = (k + within) / most * all;
    while (passed <= place && row + 1 < rows.size()) {
      ++row;
      passed += share();
    }
    if (!(share() > 0)) continue;  // by rounding, at the end
    const SampledElement sample{rows[row].element, all / most / importance[rows[row].element]};
    if (!samples.empty() && samples.back().element == sample.element)
      samples.back().weight += sample.weight;
    else
      samples.push_back(sample);
  }
  return samples;
}

}  // namespace hottel
