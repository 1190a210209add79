#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "solver/radiosity/approximate_inverse.h"

namespace hottel {
namespace {

constexpr std::size_t kMostDense = 20000;  // unknowns: 3.2 GB

class Lu : public ApproximateInverse {
 public:
  Lu(const PlainSystem& system, std::size_t components) : components_(components) {
    const std::size_t n = system.area.size();
    if (n > kMostDense)
      throw RequestError(fmt::format("lu holds {} unknowns at most, here are {}; use bicgstab", kMostDense, n));
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = system.begin[i]; k < system.begin[i + 1]; ++k)
        a(static_cast<Eigen::Index>(i), system.to[k]) -= system.scatter[k];
    lu_.compute(a);
  }

  Correction solve(const std::vector<double>& r) const override {
    Correction x{std::vector<double>(components_, 0), std::vector<double>(r.size(), 0)};
    if (r.empty()) return x;
    const auto n = static_cast<Eigen::Index>(r.size());
    Eigen::Map<Eigen::VectorXd>(x.rest.data(), n) = lu_.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), n));
    return x;
  }

 private:
  std::size_t components_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

double largest(const std::vector<double>& v) {
  double result = 0;
  for (const double value : v) result = std::max(result, std::abs(value));
  return result;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// van der Vorst 1992. The diagonal of I - rho F is 1 (or near it), so there is nothing to precondition with it.
class Bicgstab : public ApproximateInverse {
 public:
  Bicgstab(std::shared_ptr<const PlainSystem> system, std::size_t components, CgLimits limits,
           std::vector<double>* history, SharedRows* others)
      : system_(std::move(system)), components_(components), limits_(limits), history_(history), others_(others) {}

  Correction solve(const std::vector<double>& b) const override {
    const std::size_t n = b.size();
    Correction result{std::vector<double>(components_, 0), std::vector<double>(n, 0)};
    std::vector<double>& x = result.rest;
    const std::vector<double> zero(n, 0);
    std::vector<double> r = b, shadow = b, p(n, 0), v(n, 0), s(n);
    const double right_side = std::max(largest(b), 0x1p-1000);
    double rho = 1, alpha = 1, omega = 1;
    for (int iteration = 0;; ++iteration) {
      throw_if_interrupted();
      const double residual = largest(r) / right_side;
      if (history_) history_->push_back(residual);
      if (iteration == limits_.iterations || residual <= limits_.until || !std::isfinite(residual)) break;
      double next = dot(shadow, r);
      if (std::abs(next) < 0x1p-60 * dot(r, r)) {  // the shadow has turned away: begin anew from here
        shadow = r;
        next = dot(r, r);
        std::fill(p.begin(), p.end(), 0);
        std::fill(v.begin(), v.end(), 0);
        rho = alpha = omega = 1;
      }
      const double beta = next / rho * (alpha / omega);
      for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + beta * (p[i] - omega * v[i]);
      v = times(p, zero);
      const double along = dot(shadow, v);
      if (along == 0) break;
      alpha = next / along;
      for (std::size_t i = 0; i < n; ++i) s[i] = r[i] - alpha * v[i];
      const std::vector<double> t = times(s, zero);
      const double tt = dot(t, t);
      omega = tt > 0 ? dot(t, s) / tt : 0;
      for (std::size_t i = 0; i < n; ++i) {
        x[i] += alpha * p[i] + omega * s[i];
        r[i] = s[i] - omega * t[i];
      }
      rho = next;
      if (omega == 0) break;
    }
    return result;
  }

 private:
  std::vector<double> times(const std::vector<double>& x, const std::vector<double>& zero) const {
    std::vector<double> result = system_->residual(zero, x, others_);
    for (double& value : result) value = -value;
    return result;
  }

  std::shared_ptr<const PlainSystem> system_;
  std::size_t components_;
  CgLimits limits_;
  std::vector<double>* history_;
  SharedRows* others_;
};

}  // namespace

std::unique_ptr<const ApproximateInverse> make_lu(const PlainSystem& system, std::size_t components) {
  return std::make_unique<Lu>(system, components);
}

std::unique_ptr<const ApproximateInverse> make_bicgstab(std::shared_ptr<const PlainSystem> system,
                                                        std::size_t components, CgLimits limits,
                                                        std::vector<double>* history, SharedRows* others) {
  return std::make_unique<Bicgstab>(std::move(system), components, limits, history, others);
}

}  // namespace hottel
