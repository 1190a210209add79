#include "solver/radiosity/elimination.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr Eigen::Index kColumnsAtOnce = 48;  // columns eliminated before the rest is updated

}  // namespace

// One component, eliminated.
class Elimination::DenseComponent {
 public:
  // `place`: of each of these unknowns among them. REQUIRES that the unknowns outlive this.
  DenseComponent(const SymmetricRows& rows, const std::vector<std::uint32_t>& unknowns,
                 const std::vector<std::uint32_t>& place)
      : unknowns_(unknowns) {
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    coupling_ = Eigen::MatrixXd::Zero(n, n);
    defect_.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::uint32_t i = unknowns_[k];
      defect_[k] = rows.defect[i];
      for (std::size_t e = rows.begin[i]; e < rows.begin[i + 1]; ++e) {
        const auto j = static_cast<Eigen::Index>(place[rows.to[e]]);
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
    for (Eigen::Index first = 0; first < n; first += kColumnsAtOnce) {
      throw_if_interrupted();
      const Eigen::Index end = std::min(first + kColumnsAtOnce, n);
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

  const std::vector<std::uint32_t>& unknowns_;
  Eigen::MatrixXd coupling_;
  Eigen::VectorXd defect_, pivot_;
  bool is_done_ = false;  // no pivot was lost to the range of doubles
};

// The components that are wanted.
class Elimination::Wanted : public ApproximateInverse {
 public:
  Wanted(const SymmetricRows& rows, std::vector<const DenseComponent*> components)
      : rows_(rows), components_(std::move(components)) {}

  Correction solve(const std::vector<double>& r) const override {
    Correction x{std::vector<double>(components_.size(), 0), std::vector<double>(r.size(), 0)};
    for (std::uint32_t c = 0; c < components_.size(); ++c)
      if (components_[c]) components_[c]->solve(rows_, r, x, c);
    return x;
  }

 private:
  const SymmetricRows& rows_;
  std::vector<const DenseComponent*> components_;  // null: not wanted
};

Elimination::Elimination(const SymmetricRows& rows, std::size_t components)
    : rows_(rows), members_(components), place_(rows.component.size()), eliminated_(components) {
  for (std::uint32_t i = 0; i < rows.component.size(); ++i) members_[rows.component[i]].push_back(i);
  for (std::vector<std::uint32_t>& members : members_) {
    // The constant is the value at the unknown that is coupled best.
    const auto best = std::max_element(members.begin(), members.end(),
                                       [&](auto a, auto b) { return rows.coupling[a] < rows.coupling[b]; });
    std::swap(*best, members.back());
    for (std::uint32_t k = 0; k < members.size(); ++k) place_[members[k]] = k;
  }
}

Elimination::~Elimination() = default;

std::unique_ptr<const ApproximateInverse> Elimination::of(const std::vector<char>& is_wanted) const {
  std::vector<const DenseComponent*> wanted(members_.size(), nullptr);
  for (std::size_t c = 0; c < members_.size(); ++c)
    if (is_wanted[c])
      wanted[c] = &eliminated_[c].get([&] { return std::make_unique<DenseComponent>(rows_, members_[c], place_); });
  return std::make_unique<Wanted>(rows_, std::move(wanted));
}

}  // namespace hottel
