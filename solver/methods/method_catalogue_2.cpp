#include "solver/methods/method_catalogue_2.h"

#include <cmath>

#include "kernel/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kNormalised = ":normalised";

// Rows of another method, each divided by its sum.
class Normalised2 final : public ExchangeMethod2 {
 public:
  explicit Normalised2(std::unique_ptr<ExchangeMethod2> raw) : raw_(std::move(raw)), info_(raw_->info()) {
    info_.name += kNormalised;
    info_.family += kNormalised;
    info_.guarantee = Guarantee::kEstimated;
  }
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene2& prepared) const override;
  ExchangeMatrix compute(const PreparedScene2& prepared, MethodReport& report) const override;

 private:
  std::unique_ptr<ExchangeMethod2> raw_;
  MethodInfo info_;
};

// Rows that sum to zero are left as they are.
ExchangeMatrix Normalised2::compute(const PreparedScene2& prepared, MethodReport& report) const {
  const ExchangeMatrix raw = raw_->compute(prepared, report);
  std::vector<std::size_t> begin(raw.size() + 1, 0);
  std::vector<FactorEntry> entries;
  entries.reserve(raw.entry_count());
  for (std::uint32_t i = 0; i < raw.size(); ++i) {
    double sum = 0;
    for (const FactorEntry& entry : raw.row(i)) sum += entry.factor.value;
    for (FactorEntry entry : raw.row(i)) {
      if (sum > 0) entry.factor = {entry.factor.value / sum, 0};
      entries.push_back(entry);
    }
    begin[i + 1] = entries.size();
  }
  ExchangeMatrix normalised(raw.elements(), Guarantee::kEstimated);
  normalised.assign(std::move(begin), std::move(entries));
  return normalised;
}

// With errors of at most e in n factors a row sum is off by n e, so that a factor F <= 1 moves by at most n e / (1 - n
// e) more.
std::optional<double> Normalised2::declared_error(const PreparedScene2& prepared) const {
  const std::optional<double> error = raw_->declared_error(prepared);
  if (!error || *error == 0) return error;
  const double defect = *error * (static_cast<double>(prepared.arrangement.side_count()) + 1);
  return defect < 0.5 ? std::optional(*error + 2 * (defect + *error)) : std::nullopt;
}

}  // namespace

std::unique_ptr<ExchangeMethod2> MethodCatalogue2::make(const std::string& name) const {
  if (name.ends_with(kNormalised))
    return std::make_unique<Normalised2>(make(name.substr(0, name.size() - kNormalised.size())));
  const std::string family = name.substr(0, name.find(':'));
  for (const MethodFamily& each : families_)
    if (each.name == family) return each.make(std::string_view(name).substr(family.size()));
  std::string patterns;
  for (const MethodFamily& each : families_) patterns += (patterns.empty() ? "" : ", ") + each.pattern;
  throw UsageError("there is no method called '" + name + "': " + patterns);
}

}  // namespace hottel
