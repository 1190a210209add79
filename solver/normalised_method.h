// A method whose rows are divided by their sums.
#pragma once

#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include "solver/exchange_method.h"

namespace hottel {

inline constexpr std::string_view kNormalised = ":normalised";

// Returns the matrix with every row divided by its sum, the sky included.
//
//   (1) what roundings leave is taken from the largest factor of a row: its doubles sum to 1 within an ulp of that
//       factor, and never to more
//   (2) rows that do not sum to more than 0 stay as they are
//   (3) kEstimated, whatever the matrix was
ExchangeMatrix normalised(const ExchangeMatrix& matrix);

// With factors off by `error`, and a row that should sum to 1 off by `row_error`, a factor over its row's sum is off by
// what is returned, at most; infinity where nothing can be said.
double error_after_division(double error, double row_error);

// Rows of another method, each divided by its sum. REQUIRES prepared.elements(granularity)->elements() beside the type
// of the prepared scene.
template <class Prepared>
class NormalisedMethod final : public ExchangeMethod<Prepared> {
 public:
  using Raw = ExchangeMethod<Prepared>;
  using typename Raw::ClaimedErrors;

  explicit NormalisedMethod(std::unique_ptr<Raw> raw) : raw_(std::move(raw)), info_(raw_->info()) {
    info_.name += kNormalised;
    info_.family += kNormalised;
    info_.guarantee = Guarantee::kEstimated;
  }
  const MethodInfo& info() const override { return info_; }
  bool works_by_elements() const override { return raw_->works_by_elements(); }
  ExchangeMatrix compute(const Prepared& prepared, const ExchangeRequest& request,
                         MethodReport& report) const override {
    return normalised(raw_->compute(prepared, request, report));
  }
  std::optional<double> declared_error(const Prepared& prepared) const override {
    const std::optional<double> error = raw_->declared_error(prepared);
    if (!error) return error;
    const double entries = static_cast<double>(prepared.elements(Granularity::kElement)->elements().size()) + 1;
    const double divided = error_after_division(*error, entries * (*error + 2 * kRounding));
    return std::isfinite(divided) ? std::optional(divided) : std::nullopt;
  }
  ClaimedErrors claimed_errors(const Prepared& prepared) const override {
    const std::size_t columns = prepared.elements(Granularity::kElement)->elements().size() + 1;
    const ClaimedErrors raw = raw_->claimed_errors(prepared);
    std::vector<double> row_error(columns, 0.0);
    for (std::uint32_t i = 0; i + 1 < columns; ++i)
      for (std::uint32_t j = 0; j < columns; ++j) row_error[i] += raw(i, j) + 2 * kRounding;
    return [raw, row_error](std::uint32_t from, std::uint32_t to) {
      return error_after_division(raw(from, to), row_error[from]);
    };
  }

 private:
  static constexpr double kRounding = 0x1p-53;  // of a factor, and of a sum

  std::unique_ptr<Raw> raw_;
  MethodInfo info_;
};

template <class Prepared>
std::unique_ptr<ExchangeMethod<Prepared>> normalised_method(std::unique_ptr<ExchangeMethod<Prepared>> raw) {
  return std::make_unique<NormalisedMethod<Prepared>>(std::move(raw));
}

}  // namespace hottel
