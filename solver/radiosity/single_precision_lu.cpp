#include "solver/radiosity/single_precision_lu.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

using Eigen::Index;

constexpr Index kBlock = 64;          // columns eliminated before the rest is updated
constexpr Index kChunk = 128;         // rows or columns a task
constexpr std::size_t kSolved = 256;  // unknowns a task
constexpr Index kSolvedAtOnce = 128;  // unknowns before the others are updated

// Calls f(first, count) for the chunks of [begin, end), the same whatever the number of threads.
template <class F>
void for_each_chunk(Index begin, Index end, const F& f) {
  if (end <= begin) return;
  parallel_for(static_cast<std::size_t>((end - begin + kChunk - 1) / kChunk), [&](std::size_t k) {
    const Index first = begin + static_cast<Index>(k) * kChunk;
    f(first, std::min(kChunk, end - first));
  });
}

class SinglePrecisionLu : public ApproximateInverse {
 public:
  SinglePrecisionLu(const PlainSystem& system, std::size_t components) : system_(system), components_(components) {
    const auto n = static_cast<Index>(system.area.size());
    lu_ = Eigen::MatrixXf::Identity(n, n);
    for (Index i = 0; i < n; ++i)
      for (std::size_t k = system.begin[i]; k < system.begin[i + 1]; ++k)
        lu_(i, system.to[k]) -= static_cast<float>(system.scatter[k]);
    for (Index begin = 0; begin < n; begin += kBlock) {
      throw_if_interrupted();
      eliminate(begin, std::min(kBlock, n - begin));
    }
  }

  Correction solve(const std::vector<double>& r) const override {
    Correction result{std::vector<double>(components_, 0), solved(r)};
    const std::vector<double> missing = solved(system_.residual(r, result.rest));
    for (std::size_t i = 0; i < missing.size(); ++i) result.rest[i] += missing[i];
    return result;
  }

 private:
  std::vector<double> solved(std::vector<double> x) const {
    const Index n = lu_.rows();
    for (Index begin = 0; begin < n; begin += kSolvedAtOnce) {
      const Index end = std::min(begin + kSolvedAtOnce, n);
      for (Index j = begin; j < end; ++j) subtract(j, j + 1, end, x);
      update(begin, end, end, n, x);
    }
    for (Index end = n; end > 0;) {
      const Index begin = (end - 1) / kSolvedAtOnce * kSolvedAtOnce;
      for (Index j = end - 1; j >= begin; --j) {
        x[j] /= lu_(j, j);
        subtract(j, begin, j, x);
      }
      update(begin, end, 0, begin, x);
      end = begin;
    }
    return x;
  }

  // The columns [begin, begin + count), and what they do to those after them.
  void eliminate(Index begin, Index count) {
    const Index end = begin + count, n = lu_.rows();
    auto diagonal = lu_.block(begin, begin, count, count);
    for (Index k = 0; k < count; ++k) {
      const Index rest = count - k - 1;
      diagonal.col(k).tail(rest) /= diagonal(k, k);
      diagonal.bottomRightCorner(rest, rest).noalias() -= diagonal.col(k).tail(rest) * diagonal.row(k).tail(rest);
    }
    for_each_chunk(end, n, [&](Index first, Index rows) {
      auto below = lu_.block(first, begin, rows, count);
      diagonal.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(below);
    });
    for_each_chunk(end, n, [&](Index first, Index columns) {
      auto right = lu_.block(begin, first, count, columns);
      diagonal.triangularView<Eigen::UnitLower>().solveInPlace(right);
      lu_.block(end, first, n - end, columns).noalias() -= lu_.block(end, begin, n - end, count) * right;
    });
  }

  // Takes what unknown j contributes from the unknowns [begin, end).
  void subtract(Index j, Index begin, Index end, std::vector<double>& x) const {
    const double known = x[j];
    const float* column = lu_.data() + j * lu_.rows();
    for (Index i = begin; i < end; ++i) x[i] -= static_cast<double>(column[i]) * known;
  }

  // The same of the unknowns [first, last), in parallel, some columns at once.
  void update(Index first, Index last, Index begin, Index end, std::vector<double>& x) const {
    parallel_ranges(static_cast<std::size_t>(end - begin), kSolved, [&](std::size_t from, std::size_t to) {
      const Index low = begin + static_cast<Index>(from), high = begin + static_cast<Index>(to);
      Index j = first;
      for (; j + 4 <= last; j += 4) {
        const float* column = lu_.data() + j * lu_.rows();
        const float *second = column + lu_.rows(), *third = second + lu_.rows(), *fourth = third + lu_.rows();
        const double a = x[j], b = x[j + 1], c = x[j + 2], d = x[j + 3];
        for (Index i = low; i < high; ++i)
          x[i] -= (static_cast<double>(column[i]) * a + static_cast<double>(second[i]) * b) +
                  (static_cast<double>(third[i]) * c + static_cast<double>(fourth[i]) * d);
      }
      for (; j < last; ++j) subtract(j, low, high, x);
    });
  }

  const PlainSystem& system_;
  std::size_t components_;
  Eigen::MatrixXf lu_;
};

}  // namespace

std::unique_ptr<const ApproximateInverse> make_single_precision_lu(const PlainSystem& system, std::size_t components) {
  for (std::size_t i = 0; i < system.area.size(); ++i) {
    double sum = 0;
    for (std::size_t k = system.begin[i]; k < system.begin[i + 1]; ++k) sum += std::abs(system.scatter[k]);
    if (!(sum <= 1 - kLeastLossForSinglePrecision)) return nullptr;
  }
  return std::make_unique<SinglePrecisionLu>(system, components);
}

}  // namespace hottel
