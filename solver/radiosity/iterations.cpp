#include "solver/radiosity/iterations.h"

#include <algorithm>
#include <cmath>

#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

bool is_done(const IterationLimits& limits, int iteration, double residual) {
  return iteration >= limits.iterations || residual <= limits.until || !std::isfinite(residual);
}

// Entries by column: who receives from j, and how much of its light.
struct Columns {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> to;
  std::vector<double> share;

  explicit Columns(const PlainSystem& system) : begin(system.area.size() + 1, 0) {
    for (const std::uint32_t j : system.to) ++begin[j + 1];
    for (std::size_t j = 0; j < system.area.size(); ++j) begin[j + 1] += begin[j];
    to.resize(system.to.size());
    share.resize(system.to.size());
    std::vector<std::size_t> next = begin;
    for (std::uint32_t i = 0; i < system.area.size(); ++i)
      for (std::size_t k = system.begin[i]; k < system.begin[i + 1]; ++k) {
        const std::size_t place = next[system.to[k]]++;
        to[place] = i;
        share[place] = system.scatter[k];
      }
  }
};

}  // namespace

IterationResult jacobi(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits) {
  IterationResult result{source.value, {}};
  for (int iteration = 0;; ++iteration) {
    throw_if_interrupted();
    const std::vector<double> r = system.residual(source.value, result.x);
    result.history.push_back(source.relative(r));
    if (is_done(limits, iteration, result.history.back())) return result;
    for (std::size_t i = 0; i < r.size(); ++i) result.x[i] += r[i];
  }
}

IterationResult gauss_seidel(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits) {
  IterationResult result{source.value, {}};
  for (int iteration = 0;; ++iteration) {
    throw_if_interrupted();
    result.history.push_back(source.relative(system.residual(source.value, result.x)));
    if (is_done(limits, iteration, result.history.back())) return result;
    for (std::size_t i = 0; i < result.x.size(); ++i) result.x[i] = source.value[i] + system.gathered(i, result.x);
  }
}

IterationResult shooting(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits) {
  const Columns columns(system);
  IterationResult result{source.value, {}};
  std::vector<double> unshot = source.value;
  for (int shot = 0;; ++shot) {
    if (shot % 64 == 0) throw_if_interrupted();
    std::size_t brightest = 0;
    double most = 0, residual = 0;
    for (std::size_t i = 0; i < unshot.size(); ++i) {
      residual = std::max(residual, unshot[i] * source.per_largest[i]);
      if (unshot[i] * system.area[i] > most) {
        most = unshot[i] * system.area[i];
        brightest = i;
      }
    }
    result.history.push_back(residual);
    if (is_done(limits, shot, result.history.back()) || most == 0) return result;
    const double light = unshot[brightest];
    unshot[brightest] = 0;
    for (std::size_t k = columns.begin[brightest]; k < columns.begin[brightest + 1]; ++k) {
      result.x[columns.to[k]] += columns.share[k] * light;
      unshot[columns.to[k]] += columns.share[k] * light;
    }
  }
}

}  // namespace hottel
