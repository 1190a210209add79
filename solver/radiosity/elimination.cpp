#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "kernel/support/interrupt.h"
#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/symmetric_rows.h"

namespace hottel {
namespace {

constexpr Eigen::Index kBlock = 48;  // columns eliminated before the rest is updated

// One component, eliminated.
class DenseComponent {
 public:
  DenseComponent(const RadiositySystem& system, const SymmetricRows& rows, std::vector<std::uint32_t> unknowns)
      : unknowns_(std::move(unknowns)) {
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    // The constant is the value at the unknown that is coupled best.
    std::swap(*std::max_element(unknowns_.begin(), unknowns_.end(),
                                [&](auto a, auto b) { return rows.coupling[a] < rows.coupling[b]; }),
              unknowns_.back());
    std::vector<Eigen::Index> place(system.size(), -1);
    for (Eigen::Index k = 0; k < n; ++k) place[unknowns_[k]] = k;
    coupling_ = Eigen::MatrixXd::Zero(n, n);
    defect_.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::uint32_t i = unknowns_[k];
      defect_[k] = rows.defect[i];
      for (std::size_t e = rows.begin[i]; e < rows.begin[i + 1]; ++e) {
        const Eigen::Index j = place[rows.to[e]];
        coupling_(std::max(k, j), std::min(k, j)) =
            rows.coupling_of[e];  // the same number, but for roundings, from both
      }
    }
    eliminate();
    is_done_ =
        std::all_of(pivot_.begin(), pivot_.end(), [](double pivot) { return pivot > 0 && std::isfinite(pivot); });
  }

  // weight_i r_i in, corrections out.
  void solve(const SymmetricRows& rows, const std::vector<double>& r, Correction& x, std::uint32_t component) const {
    if (!is_done_) return;
    const Eigen::Index n = pivot_.size();
    Eigen::VectorXd b(n);
    for (Eigen::Index k = 0; k < n; ++k) b[k] = rows.weight[unknowns_[k]] * r[unknowns_[k]];
    for (Eigen::Index k = 0; k + 1 < n; ++k) b.tail(n - k - 1) += coupling_.col(k).tail(n - k - 1) * (b[k] / pivot_[k]);
    const double constant = b[n - 1] / pivot_[n - 1];
    // Differences to the constant; or values: for r >= 0 nothing is subtracted there.
    const Eigen::VectorXd differences = substituted_back(b - defect_ * constant, 0);
    FormOfSolution form;
    for (Eigen::Index k = 0; k < n; ++k) form.meet(constant, differences[k], r[unknowns_[k]]);
    const bool keeps_constant = form.keeps(constant);
    const Eigen::VectorXd values = keeps_constant ? differences : substituted_back(b, constant);
    x.constant[component] = keeps_constant ? constant : 0;
    for (Eigen::Index k = 0; k < n; ++k) x.rest[unknowns_[k]] = values[k];
  }

 private:
  Eigen::VectorXd substituted_back(const Eigen::VectorXd& b, double last) const {
    const Eigen::Index n = pivot_.size();
    Eigen::VectorXd x(n);
    x[n - 1] = last;
    for (Eigen::Index k = n - 2; k >= 0; --k)
      x[k] = (b[k] + coupling_.col(k).tail(n - k - 1).dot(x.tail(n - k - 1))) / pivot_[k];
    return x;
  }

  // Below the diagonal, column k ends as the couplings of k to those eliminated later; the diagonal is never read.
  void eliminate() {
    const Eigen::Index n = coupling_.rows();
    pivot_.setZero(n);
    for (Eigen::Index first = 0; first < n; first += kBlock) {
      throw_if_interrupted();
      const Eigen::Index end = std::min(first + kBlock, n);
      for (Eigen::Index k = first; k < end; ++k) {
        const auto column = coupling_.col(k).tail(n - k - 1);
        pivot_[k] = defect_[k] + column.sum();
        if (!(pivot_[k] > 0)) return;
        const double share = defect_[k] / pivot_[k];
        defect_.tail(n - k - 1) += column * share;
        for (Eigen::Index j = k + 1; j < end; ++j) {
          const double factor = coupling_(j, k) / pivot_[k];
          if (factor != 0 && j + 1 < n) coupling_.col(j).tail(n - j - 1) += coupling_.col(k).tail(n - j - 1) * factor;
        }
      }
      if (end == n) continue;
      const Eigen::MatrixXd panel = coupling_.block(end, first, n - end, end - first) *
                                    pivot_.segment(first, end - first).cwiseSqrt().cwiseInverse().asDiagonal();
      coupling_.block(end, end, n - end, n - end).selfadjointView<Eigen::Lower>().rankUpdate(panel);
    }
  }

  std::vector<std::uint32_t> unknowns_;
  Eigen::MatrixXd coupling_;
  Eigen::VectorXd defect_, pivot_;
  bool is_done_ = false;  // no pivot was lost to the range of doubles
};

class Elimination : public ApproximateInverse {
 public:
  Elimination(const RadiositySystem& system, const std::vector<char>& is_wanted)
      : rows_(system), components_(system.components().size()) {
    std::vector<std::vector<std::uint32_t>> members(system.components().size());
    for (std::uint32_t i = 0; i < system.size(); ++i) {
      const std::uint32_t c = system.rows()[i].component;
      if (is_wanted[c]) members[c].push_back(i);
    }
    for (std::size_t c = 0; c < members.size(); ++c)
      if (!members[c].empty()) components_[c] = std::make_unique<DenseComponent>(system, rows_, std::move(members[c]));
  }

  Correction solve(const std::vector<double>& r) override {
    Correction x{std::vector<double>(components_.size(), 0), std::vector<double>(r.size(), 0)};
    for (std::uint32_t c = 0; c < components_.size(); ++c)
      if (components_[c]) components_[c]->solve(rows_, r, x, c);
    return x;
  }

 private:
  SymmetricRows rows_;
  std::vector<std::unique_ptr<DenseComponent>> components_;
};

}  // namespace

std::unique_ptr<ApproximateInverse> make_elimination(const RadiositySystem& system,
                                                     const std::vector<char>& is_wanted) {
  return std::make_unique<Elimination>(system, is_wanted);
}

}  // namespace hottel
