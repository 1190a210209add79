#include "geometry/space/visibility/cosine_quadrature.h"

#include <acb.h>
#include <acb_calc.h>

namespace hottel {
namespace {

// A complex ball for the quadrature.
class Complex {
 public:
  Complex() { acb_init(z); }
  Complex(const Complex&) = delete;
  Complex& operator=(const Complex&) = delete;
  ~Complex() { acb_clear(z); }
  acb_t z;
};

// Sets `out` to (e^z - 1) / z, which is 1 at z = 0.
void set_exponential_slope(acb_t out, const acb_t z, long precision) {
  mag_t size;
  mag_init(size);
  acb_get_mag_lower(size, z);
  const bool is_far = mag_cmp_2exp_si(size, -1) > 0;
  acb_get_mag(size, z);
  if (is_far) {
    Complex grown;
    acb_expm1(grown.z, z, precision);
    acb_div(out, grown.z, z, precision);
  } else if (mag_cmp_2exp_si(size, 1) <= 0) {
    // 1 + z/2 (1 + z/3 (1 + ...)), and the rest: with |z| <= 2 each term is at most 2/3 of the one before it.
    long terms = 4;
    mag_t term;
    mag_init(term);
    mag_mul(term, size, size);
    mag_mul_2exp_si(term, term, -1);
    while (terms < 2 * precision && mag_cmp_2exp_si(term, -precision) > 0) {
      mag_mul(term, term, size);
      mag_div_ui(term, term, static_cast<ulong>(terms));
      ++terms;
    }
    mag_clear(term);
    Complex sum;
    acb_one(sum.z);
    for (long j = terms; j >= 2; --j) {
      acb_mul(sum.z, sum.z, z, precision);
      acb_div_ui(sum.z, sum.z, static_cast<ulong>(j), precision);
      acb_add_ui(sum.z, sum.z, 1, precision);
    }
    // The first term that is left out is z^terms / (terms + 1)!; the sum of all is below three times its size.
    mag_t rest, factorial;
    mag_init(rest);
    mag_init(factorial);
    mag_pow_ui(rest, size, static_cast<ulong>(terms));
    mag_rfac_ui(factorial, static_cast<ulong>(terms + 1));
    mag_mul(rest, rest, factorial);
    mag_mul_ui(rest, rest, 3);
    acb_add_error_mag(sum.z, rest);
    mag_clear(factorial);
    mag_clear(rest);
    acb_swap(out, sum.z);
  } else {
    // It is the mean of e^(x z) over x from 0 to 1.
    arb_t largest, zero;
    arb_init(largest);
    arb_init(zero);
    arb_max(largest, acb_realref(z), zero, precision);
    arb_exp(largest, largest, precision);
    arb_get_mag(size, largest);
    acb_zero(out);
    acb_add_error_mag(out, size);
    arb_clear(zero);
    arb_clear(largest);
  }
  mag_clear(size);
}

struct Integrand {
  arb_srcptr c0;
  arb_srcptr power;
};

// (1 - c^k) / (1 - c^2) at c = c0 cos u, as the quotient of means of powers: k m(k log c) / (m(log c) (1 + c)).
int ratio_at(acb_ptr out, const acb_t u, void* parameters, slong order, slong precision) {
  const auto& integrand = *static_cast<const Integrand*>(parameters);
  Complex c, logarithm, scaled, slope;
  acb_cos(c.z, u, precision);
  acb_mul_arb(c.z, c.z, integrand.c0, precision);
  acb_log_analytic(logarithm.z, c.z, order != 0, precision);
  acb_mul_arb(scaled.z, logarithm.z, integrand.power, precision);
  set_exponential_slope(slope.z, scaled.z, precision);
  acb_mul_arb(slope.z, slope.z, integrand.power, precision);
  set_exponential_slope(scaled.z, logarithm.z, precision);
  acb_add_ui(c.z, c.z, 1, precision);
  acb_mul(scaled.z, scaled.z, c.z, precision);
  acb_div(out, slope.z, scaled.z, precision);
  return 0;
}

}  // namespace

Real integral_of_power_ratio_3(const Real& c0, const Real& k, const Real& low, const Real& high) {
  const long precision = c0.precision();
  Complex from, to, integral;
  acb_set_arb(from.z, low.x);
  acb_set_arb(to.z, high.x);
  Integrand integrand{c0.x, k.x};
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -4 * precision);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  acb_calc_integrate(integral.z, ratio_at, &integrand, from.z, to.z, precision, tolerance, options, precision);
  mag_clear(tolerance);
  Real result(precision);
  arb_set(result.x, acb_realref(integral.z));
  return result;
}

}  // namespace hottel
