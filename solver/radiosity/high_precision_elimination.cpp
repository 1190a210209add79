#include "solver/radiosity/high_precision_elimination.h"

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/doubles.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr unsigned kBits = 256;
constexpr double kOperationError = 0x1p-240;  // of one operation, relative: more than truncation to kBits loses

// From where on elimination in high precision is worth it for a component of n unknowns: relative width.
double much(std::uint32_t n) { return std::max(0x1p-44, n * 0x1p-50); }

mpf_class precise(double value) { return mpf_class(finite(value), kBits); }

// REQUIRES value >= 0.
double rounded_down(const mpf_class& value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return value >= kLargest ? kLargest : value.get_d();  // which truncates
}

double rounded_up(const mpf_class& value) { return std::nextafter(rounded_down(value), kInfinity); }

// value 2^exponent
mpf_class scaled(const mpf_class& value, long exponent) {
  mpf_class result(0, kBits);
  if (exponent >= 0)
    mpf_mul_2exp(result.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpf_div_2exp(result.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

// Two numbers >= 0 of any size, one not above, one not below the real one.
struct ScaledEnclosure {
  mpf_class lower, upper;

  // The exponent that brings the upper one to between 1/2 and 1; 0 for 0.
  int exponent() const {
    long result = 0;
    mpf_get_d_2exp(&result, upper.get_mpf_t());
    return static_cast<int>(result);
  }
  Enclosure in_unit(int unit) const {
    return {rounded_down(scaled(lower, -long{unit})), rounded_up(scaled(upper, -long{unit}))};
  }
};

}  // namespace

class HighPrecisionElimination::Component {
 public:
  Component(const RadiositySystem& system, std::uint32_t component) : system_(system) {
    for (std::uint32_t i = 0; i < system.size(); ++i)
      if (system.rows()[i].component == component) unknowns_.push_back(i);
    const std::size_t n = unknowns_.size();
    if (n > kMostEliminatedUnknowns) return;
    std::vector<std::size_t> place(system.size());
    for (std::size_t k = 0; k < n; ++k) place[unknowns_[k]] = k;
    coupling_.assign(n * n, precise(0));
    loss_.assign(n, precise(0));
    spread_ = 4 * same_bits::pow(static_cast<double>(n) + 8, 3) * kOperationError;
    for (std::size_t k = 0; k < n; ++k) read_row(k, place);
    if (is_known()) eliminate();
  }

  bool is_known() const { return spread_ < 0.5; }
  const std::vector<std::uint32_t>& unknowns() const { return unknowns_; }

  // Bounds of all unknowns of the component, in their order. REQUIRES is_known().
  std::vector<ScaledEnclosure> bounds(const Sources& sources) const {
    const std::vector<mpf_class> least = solved(sources, &DoubleDoubleBall::lower),
                                 most = solved(sources, &DoubleDoubleBall::upper);
    const mpf_class part = pow2(mpf_class(1 - precise(spread_), kBits));
    std::vector<ScaledEnclosure> result;
    for (std::size_t k = 0; k < least.size(); ++k)
      result.push_back({mpf_class(least[k] * part, kBits), mpf_class(most[k] / part, kBits)});
    return result;
  }

 private:
  static mpf_class pow2(const mpf_class& value) { return mpf_class(value * value, kBits); }

  mpf_class& coupling(std::size_t i, std::size_t j) { return coupling_[i * unknowns_.size() + j]; }
  const mpf_class& coupling(std::size_t i, std::size_t j) const { return coupling_[i * unknowns_.size() + j]; }

  mpf_class reflectivity(const SystemRow& row) const {
    return mpf_class(Rational(1 - system_.absorptivity(row)), kBits);
  }

  void read_row(std::size_t k, const std::vector<std::size_t>& place) {
    const SystemRow& row = system_.rows()[unknowns_[k]];
    const mpf_class rho = reflectivity(row);
    loss_[k] = mpf_class(system_.absorptivity(row), kBits);
    double spread = 0;
    for (const FactorEntry& entry : system_.matrix().row(row.element)) {
      const std::int32_t j = system_.unknown(entry.to);
      if (j >= 0 && static_cast<std::uint32_t>(j) == unknowns_[k]) continue;
      const DoubleDoubleBall factor = DoubleDoubleBall::of(entry.factor);
      if (factor.radius > 0)
        spread = std::max(spread, factor.radius / std::max(0.0, factor.hi - 2 * factor.radius) * kOutward);
      mpf_class& sum = j < 0 ? loss_[k] : coupling(k, place[static_cast<std::size_t>(j)]);
      sum += rho * (precise(factor.hi) + precise(factor.lo));
    }
    spread_ += spread;
  }

  void eliminate() {
    const std::size_t n = unknowns_.size();
    mpf_class share = precise(0), product = precise(0);
    for (std::size_t k = 0; k < n; ++k) {
      throw_if_interrupted();
      pivot_.push_back(loss_[k]);
      for (std::size_t j = k + 1; j < n; ++j) pivot_[k] += coupling(k, j);
      if (pivot_[k] <= 0) {  // nothing is lost
        spread_ = kInfinity;
        return;
      }
      for (std::size_t i = k + 1; i < n; ++i) {
        if (coupling(i, k) == 0) continue;
        share = coupling(i, k) / pivot_[k];
        for (std::size_t j = k + 1; j < n; ++j) {
          if (j == i) continue;
          mpf_mul(product.get_mpf_t(), share.get_mpf_t(), coupling(k, j).get_mpf_t());
          mpf_add(coupling(i, j).get_mpf_t(), coupling(i, j).get_mpf_t(), product.get_mpf_t());
        }
        loss_[i] += share * loss_[k];
      }
    }
  }

  // The solution for one end of all sources, which it ascends with.
  std::vector<mpf_class> solved(const Sources& sources, double (DoubleDoubleBall::*end)() const) const {
    const std::size_t n = unknowns_.size();
    std::vector<mpf_class> x;
    for (const std::uint32_t u : unknowns_) {
      const SystemRow& row = system_.rows()[u];
      const auto emission = [&](std::uint32_t element) {
        const ScaledBall& e = sources.emission[element];
        return scaled(precise(std::max(0.0, (e.mantissa.*end)())), e.exponent);
      };
      mpf_class received = precise(0);
      for (const FactorEntry& entry : system_.matrix().row(row.element))
        if (system_.unknown(entry.to) < 0) {
          DoubleDoubleBall factor = DoubleDoubleBall::of(entry.factor);
          received += emission(entry.to) * precise(std::max(0.0, (factor.*end)()));
        }
      x.push_back(mpf_class(emission(row.element) + reflectivity(row) * received, kBits));
    }
    for (std::size_t k = 0; k < n; ++k) {
      const mpf_class share(x[k] / pivot_[k], kBits);
      for (std::size_t i = k + 1; i < n; ++i) x[i] += coupling(i, k) * share;
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) x[k] += coupling(k, j) * x[j];
      x[k] /= pivot_[k];
    }
    return x;
  }

  const RadiositySystem& system_;
  std::vector<std::uint32_t> unknowns_;
  std::vector<mpf_class> coupling_, loss_, pivot_;
  double spread_ = kInfinity;
};

HighPrecisionElimination::HighPrecisionElimination(const RadiositySystem& system)
    : system_(system), components_(system.components().size()) {}
HighPrecisionElimination::~HighPrecisionElimination() = default;

const HighPrecisionElimination::Component& HighPrecisionElimination::eliminated(std::uint32_t component) const {
  return components_[component].get([&] { return std::make_unique<Component>(system_, component); });
}

void HighPrecisionElimination::narrow(const Sources& sources, const Wanted& wanted, CertifiedBounds& bounds) const {
  std::vector<char> is_eliminated(system_.components().size(), 0);
  for (std::size_t u = 0; u < system_.size(); ++u) {
    const std::uint32_t c = system_.rows()[u].component;
    const double width = bounds.upper[u] - bounds.lower[u];
    const double least = std::ldexp(1.0, -1074 - bounds.exponent[u]);  // what a double can tell
    if (bounds.upper[u] == kInfinity ||
        (wanted.narrow && width > much(system_.components()[c].size) * bounds.upper[u] + least))
      is_eliminated[c] = 1;
  }
  for (std::uint32_t c = 0; c < is_eliminated.size(); ++c) {
    if (!is_eliminated[c]) continue;
    const Component& component = eliminated(c);
    if (!component.is_known()) continue;
    const std::vector<ScaledEnclosure> narrowed = component.bounds(sources);
    for (std::size_t k = 0; k < narrowed.size(); ++k) {
      const std::uint32_t u = component.unknowns()[k];
      double &lower = bounds.lower[u], &upper = bounds.upper[u];
      DoubleDoubleBall& value = bounds.value[u];
      const bool is_kept = wanted.keeps_value && std::isfinite(value.hi) && value.hi >= 0;
      // From here on in a unit of its own.
      int unit = narrowed[k].upper > 0 ? narrowed[k].exponent() : bounds.exponent[u];
      if (is_kept && value.hi > 0) unit = std::max(unit, bounds.exponent[u] + std::ilogb(value.hi));
      const Enclosure within = narrowed[k].in_unit(unit);
      const int shift = bounds.exponent[u] - unit;
      lower = std::max(lower_scaled(lower, shift), within.lower);
      upper = std::max(lower, std::min(upper_scaled(upper, shift), within.upper));
      value = scaled(value, shift);
      bounds.exponent[u] = unit;
      if (is_kept) {
        lower = std::min(lower, value.hi);
        upper = std::max(upper, value.hi);
      } else if (!(value.hi >= lower && value.hi <= upper)) {
        value = {lower + (upper - lower) / 2, 0, 0};
      }
    }
  }
}

void require_bounds(const RadiositySystem& system, const CertifiedBounds& bounds) {
  for (std::size_t u = 0; u < bounds.upper.size(); ++u)
    if (bounds.upper[u] == kInfinity)
      throw RequestError(fmt::format(
          "no bounds of the radiosity near '{}' can be proven: its component loses next to no light, or exchanges less "
          "than doubles can tell",
          system.matrix().elements()[system.rows()[u].element].name));
}

}  // namespace hottel
