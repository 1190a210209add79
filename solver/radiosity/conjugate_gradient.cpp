
#include <algorithm>
#include <cmath>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/block_sums.h"
#include "solver/radiosity/row_crew.h"
#include "solver/radiosity/symmetric_rows.h"

namespace hottel {
namespace {

constexpr std::size_t kGrainOfOne = 4096;  // rows a task, where a row is a few additions

template <class F>
void of_each(std::size_t n, const F& f) {
  parallel_for(n, f, kGrainOfOne);
}

double inner_product(const std::vector<double>& a, const std::vector<double>& b) {
  return block_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

class ConjugateGradient : public ApproximateInverse {
 public:
  ConjugateGradient(const SymmetricRows& rows, const std::vector<char>& is_wanted, CgLimits limits,
                    std::vector<double>* history, SharedRows* others)
      : rows_(rows),
        is_wanted_(is_wanted),
        limits_(limits),
        history_(history),
        others_(others),
        defects_(is_wanted.size(), 0) {
    for (std::size_t i = 0; i < rows.defect.size(); ++i) defects_[rows_.component[i]] += rows_.defect[i];
  }

  Correction solve(const std::vector<double>& r_of_rows) const override {
    const std::size_t n = rows_.weight.size();
    Correction x{constants(r_of_rows), std::vector<double>(n, 0)};
    std::vector<double> r(n, 0), z(n), p(n, 0), kp(n);
    of_each(n, [&](std::size_t i) {
      if (wanted(i)) r[i] = rows_.weight[i] * r_of_rows[i] - x.constant[rows_.component[i]] * rows_.defect[i];
    });
    const double right_side = block_largest(n, [&](std::size_t i) { return std::abs(r_of_rows[i]); });
    double before = 0;
    for (int iteration = 0;; ++iteration) {
      throw_if_interrupted();
      const double residual = largest(r) / (right_side > 0 ? right_side : 1);
      if (history_) history_->push_back(residual);
      if (iteration == limits_.iterations || residual <= limits_.until) break;
      of_each(n, [&](std::size_t i) { z[i] = r[i] == 0 ? 0 : r[i] / (rows_.coupling[i] + rows_.defect[i]); });
      deflate(z);
      const double now = inner_product(r, z);
      if (!(now > 0)) break;
      const double beta = iteration == 0 ? 0 : now / before;
      of_each(n, [&](std::size_t i) { p[i] = z[i] + beta * p[i]; });
      before = now;
      multiply(p, kp);
      const double curvature = inner_product(p, kp);
      if (!(curvature > 0)) break;
      const double step = now / curvature;
      of_each(n, [&](std::size_t i) {
        x.rest[i] += step * p[i];
        r[i] -= step * kp[i];
      });
    }
    fold(r_of_rows, x);
    return x;
  }

 private:
  // The constant is a mean by defects. Where it is huge it is moved to the value at the unknown that is coupled best,
  // so that what most unknowns have in common drops out of their differences even if the defects are elsewhere.
  void centre(const std::vector<double>& right_side, Correction& x) const {
    const std::size_t components = x.constant.size();
    std::vector<double> largest(components, 0), best(components, 0), shift(components, 0);
    for (std::size_t i = 0; i < x.rest.size(); ++i) {
      const std::uint32_t c = rows_.component[i];
      largest[c] = std::max(largest[c], std::abs(right_side[i]));
      if (rows_.coupling[i] <= best[c]) continue;
      best[c] = rows_.coupling[i];
      shift[c] = x.rest[i];
    }
    for (std::size_t c = 0; c < components; ++c)
      if (!is_huge(x.constant[c], largest[c])) shift[c] = 0;
    for (std::size_t c = 0; c < components; ++c) x.constant[c] += shift[c];
    for (std::size_t i = 0; i < x.rest.size(); ++i) x.rest[i] -= shift[rows_.component[i]];
  }

  // Values instead of differences to the constant, where that is better.
  void fold(const std::vector<double>& right_side, Correction& x) const {
    centre(right_side, x);
    std::vector<FormOfSolution> form(x.constant.size());
    for (std::size_t i = 0; i < x.rest.size(); ++i) {
      const std::uint32_t c = rows_.component[i];
      form[c].meet(x.constant[c], x.rest[i], right_side[i]);
    }
    for (std::size_t i = 0; i < x.rest.size(); ++i) {
      const std::uint32_t c = rows_.component[i];
      if (!form[c].keeps(x.constant[c])) x.rest[i] += x.constant[c];
    }
    for (std::size_t c = 0; c < x.constant.size(); ++c)
      if (!form[c].keeps(x.constant[c])) x.constant[c] = 0;
  }

  bool wanted(std::size_t i) const { return is_wanted_[rows_.component[i]] != 0; }

  // The multiple of 1 in each component after which the residuals of its rows sum to 0.
  std::vector<double> constants(const std::vector<double>& r) const {
    std::vector<double> result = block_sums(rows_.component, defects_.size(),
                                            [&](std::size_t i) { return wanted(i) ? rows_.weight[i] * r[i] : 0; });
    for (std::size_t c = 0; c < result.size(); ++c)
      if (defects_[c] > 0) result[c] /= defects_[c];
    return result;
  }

  // Makes z orthogonal to the constant of each component in the sense of K.
  void deflate(std::vector<double>& z) const {
    std::vector<double> mean = block_sums(rows_.component, defects_.size(),
                                          [&](std::size_t i) { return wanted(i) ? rows_.defect[i] * z[i] : 0; });
    for (std::size_t c = 0; c < mean.size(); ++c)
      if (defects_[c] > 0) mean[c] /= defects_[c];
    of_each(z.size(), [&](std::size_t i) {
      if (wanted(i)) z[i] -= mean[rows_.component[i]];
    });
  }

  double largest(const std::vector<double>& r) const {
    return block_largest(r.size(), [&](std::size_t i) { return std::abs(r[i]) / rows_.weight[i]; });
  }

  void multiply(const std::vector<double>& p, std::vector<double>& kp) const {
    const auto here = [&](const WorkRange& unknowns) { rows_.multiply(unknowns, p, kp); };
    if (others_ != nullptr)
      others_->multiply(RowProduct::kSymmetric, p, here, kp);
    else
      here({0, p.size()});
  }

  const SymmetricRows& rows_;
  std::vector<char> is_wanted_;
  CgLimits limits_;
  std::vector<double>* history_;
  SharedRows* others_;
  std::vector<double> defects_;  // by component
};

}  // namespace

std::unique_ptr<const ApproximateInverse> make_conjugate_gradient(const SymmetricRows& rows,
                                                                  const std::vector<char>& is_wanted, CgLimits limits,
                                                                  std::vector<double>* history, SharedRows* others) {
  return std::make_unique<ConjugateGradient>(rows, is_wanted, limits, history, others);
}

}  // namespace hottel
