#include "kernel/legendre_rule.h"

#include <arb.h>
#include <arb_hypgeom.h>
#include <arf.h>
#include <mpfr.h>

#include <array>
#include <limits>

#include "kernel/flint_memory.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

constexpr long kPrecision = kWideBits + 128;

// The number nearest to the middle of a ball that is far narrower than its last bit: what is left after each double is
// less than half a unit of its last place.
template <class Real>
Real nearest(const arb_t ball) {
  arf_t rest, part;
  arf_init(rest);
  arf_init(part);
  arf_set_round(rest, arb_midref(ball), std::numeric_limits<Real>::digits, ARF_RND_NEAR);
  Real sum = 0;
  while (!arf_is_zero(rest)) {
    const double leading = arf_get_d(rest, ARF_RND_DOWN);
    sum += static_cast<Real>(leading);
    arf_set_d(part, leading);
    arf_sub(rest, rest, part, ARF_PREC_EXACT, ARF_RND_DOWN);
  }
  arf_clear(part);
  arf_clear(rest);
  return sum;
}

template <class Real>
Real nearest_by_mpfr(const arb_t ball) {
  Real result;
  arf_get_mpfr(result.backend().data(), arb_midref(ball), MPFR_RNDN);
  return result;
}
template <>
LongerReal nearest<LongerReal>(const arb_t ball) {
  return nearest_by_mpfr<LongerReal>(ball);
}
template <>
WideReal nearest<WideReal>(const arb_t ball) {
  return nearest_by_mpfr<WideReal>(ball);
}

template <class Real>
LegendreRule<Real> make_rule(int n) {
  LegendreRule<Real> rule;
  arb_t node, weight;
  arb_init(node);
  arb_init(weight);
  for (int k = 0; k < n; ++k) {
    // Arb numbers the nodes of [-1, 1] from the largest one.
    arb_hypgeom_legendre_p_ui_root(node, weight, static_cast<ulong>(n), static_cast<ulong>(k), kPrecision);
    arb_sub_ui(node, node, 1, kPrecision);
    arb_mul_2exp_si(node, node, -1);
    arb_neg(node, node);
    arb_mul_2exp_si(weight, weight, -1);
    rule.node.push_back(nearest<Real>(node));
    rule.weight.push_back(nearest<Real>(weight));
  }
  arb_clear(weight);
  arb_clear(node);
  return rule;
}

template <class Real>
std::array<LegendreRule<Real>, kMaxLegendreNodes<Real> + 1> make_rules() {
  return_flint_memory_at_thread_end();
  std::array<LegendreRule<Real>, kMaxLegendreNodes<Real> + 1> rules;
  for (int n = 1; n <= kMaxLegendreNodes<Real>; ++n) rules[static_cast<std::size_t>(n)] = make_rule<Real>(n);
  return rules;
}

}  // namespace

template <class Real>
const LegendreRule<Real>& legendre_rule(int n) {
  static const auto kRules = make_rules<Real>();
  return kRules[static_cast<std::size_t>(n)];
}

template const LegendreRule<double>& legendre_rule<double>(int);
template const LegendreRule<long double>& legendre_rule<long double>(int);
template const LegendreRule<LongerReal>& legendre_rule<LongerReal>(int);
template const LegendreRule<WideReal>& legendre_rule<WideReal>(int);

}  // namespace hottel
