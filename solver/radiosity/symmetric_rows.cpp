#include "solver/radiosity/symmetric_rows.h"

#include <algorithm>

namespace hottel {
namespace {

constexpr double kSmallestReflectivity = 0x1p-800;  // below it the weight stays finite; what is left is refined

}  // namespace

SymmetricRows::SymmetricRows(const RadiositySystem& system)
    : to(PlacingAllocator<std::uint32_t>(system.matrix().memory())),
      coupling_of(PlacingAllocator<double>(system.matrix().memory())) {
  const ExchangeMatrix& matrix = system.matrix();
  const std::size_t n = system.size();
  std::vector<double> largest(system.components().size(), 0);
  for (const SystemRow& row : system.rows())
    largest[row.component] = std::max(largest[row.component], matrix.elements()[row.element].area.value);
  coupling.assign(n, 0);
  defect.assign(n, 0);
  weight.assign(n, 0);
  begin.push_back(0);
  std::size_t entries = 0;
  for (const SystemRow& row : system.rows()) entries += matrix.row(row.element).size();
  to.reserve(entries);  // at once: growing would copy what may be on disk
  coupling_of.reserve(entries);
  for (std::size_t i = 0; i < n; ++i) {
    const SystemRow& row = system.rows()[i];
    const double area = matrix.elements()[row.element].area.value / largest[row.component];
    const double reflectivity = std::max(row.reflectivity.hi, kSmallestReflectivity);
    weight[i] = area / reflectivity;
    component.push_back(row.component);
    double to_known = 0;
    for (const FactorEntry& entry : matrix.row(row.element)) {
      const std::int32_t j = system.unknown(entry.to);
      if (j < 0) {
        to_known += entry.factor.value;
        continue;
      }
      if (static_cast<std::size_t>(j) == i) continue;
      to.push_back(static_cast<std::uint32_t>(j));
      coupling_of.push_back(area * entry.factor.value);
      coupling[i] += coupling_of.back();
    }
    begin.push_back(to.size());
    defect[i] = weight[i] * row.loss.hi + area * to_known;
  }
}

}  // namespace hottel
