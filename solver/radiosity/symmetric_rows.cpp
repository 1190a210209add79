#include "solver/radiosity/symmetric_rows.h"

#include <algorithm>
#include <numeric>

#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kGrain = 64;                  // rows a task
constexpr double kSmallestReflectivity = 0x1p-800;  // below it the weight stays finite; what is left is refined

double area_of(const RadiositySystem& system, const SystemRow& row) {
  return system.matrix().elements()[row.element].area.value;
}

// How many other unknowns a row sees.
std::size_t couplings(const RadiositySystem& system, std::size_t i) {
  return static_cast<std::size_t>(
      std::ranges::count_if(system.matrix().row(system.rows()[i].element).columns(), [&](std::uint32_t column) {
        const std::int32_t j = system.unknown(column);
        return j >= 0 && static_cast<std::size_t>(j) != i;
      }));
}

}  // namespace

SymmetricRows::SymmetricRows(const RadiositySystem& system)
    : to(UnsetAllocator<std::uint32_t>(system.matrix().memory())),
      coupling_of(UnsetAllocator<double>(system.matrix().memory())) {
  const std::size_t n = system.size();
  std::vector<double> largest(system.components().size(), 0);
  for (const SystemRow& row : system.rows()) {
    component.push_back(row.component);
    largest[row.component] = std::max(largest[row.component], area_of(system, row));
  }
  begin.resize(n + 1);
  parallel_for(
      n, [&](std::size_t i) { begin[i + 1] = couplings(system, i); }, kGrain);
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  to.resize(begin.back());
  coupling_of.resize(begin.back());
  coupling.resize(n);
  defect.resize(n);
  weight.resize(n);
  parallel_for(
      n, [&](std::size_t i) { set_row(system, i, largest[component[i]]); }, kGrain);
}

void SymmetricRows::set_row(const RadiositySystem& system, std::size_t i, double largest) {
  const SystemRow& row = system.rows()[i];
  const double area = area_of(system, row) / largest;
  weight[i] = area / std::max(row.reflectivity.hi, kSmallestReflectivity);
  double to_known = 0, to_unknown = 0;
  std::size_t k = begin[i];
  for (const FactorEntry& entry : system.matrix().row(row.element)) {
    const std::int32_t j = system.unknown(entry.to);
    if (j < 0) {
      to_known += entry.factor.value;
    } else if (static_cast<std::size_t>(j) != i) {
      to[k] = static_cast<std::uint32_t>(j);
      coupling_of[k] = area * entry.factor.value;
      to_unknown += coupling_of[k++];
    }
  }
  coupling[i] = to_unknown;
  defect[i] = weight[i] * row.loss.hi + area * to_known;
}

void SymmetricRows::multiply(const WorkRange& unknowns, const std::vector<double>& x,
                             std::vector<double>& result) const {
  parallel_ranges(unknowns.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = unknowns.begin + first; i < unknowns.begin + last; ++i) {
      double sum = 0;
      for (std::size_t e = begin[i]; e < begin[i + 1]; ++e) sum += coupling_of[e] * (x[i] - x[to[e]]);
      result[i] = sum + defect[i] * x[i];
    }
  });
}

}  // namespace hottel
