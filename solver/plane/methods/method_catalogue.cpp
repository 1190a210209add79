#include "solver/plane/methods/method_catalogue.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/near_names.h"
#include "geometry/plane/exchange/element_table.h"
#include "solver/radiosity/double_double_ball.h"

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
  ClaimedErrors claimed_errors(const PreparedScene2& prepared) const override;
  ExchangeMatrix compute(const PreparedScene2& prepared, MethodReport& report) const override;

 private:
  std::unique_ptr<ExchangeMethod2> raw_;
  MethodInfo info_;
};

// See MethodCatalogue2.
void normalise(std::span<FactorEntry> row) {
  double total = 0;
  for (const FactorEntry& entry : row) total += entry.factor.value;
  if (!(total > 0)) return;
  for (FactorEntry& entry : row) entry.factor = {entry.factor.value / total, 0};
  Rounded& largest = std::max_element(row.begin(), row.end(), [](const FactorEntry& a, const FactorEntry& b) {
                       return a.factor.value < b.factor.value;
                     })->factor;
  DoubleDoubleBall rest{1, 0, 0};
  for (const FactorEntry& entry : row)
    if (&entry.factor != &largest) rest = difference(rest, {entry.factor.value, 0, 0});
  largest.value = rest.lo < 0 ? std::nextafter(rest.hi, 0) : rest.hi;
}

ExchangeMatrix Normalised2::compute(const PreparedScene2& prepared, MethodReport& report) const {
  const ExchangeMatrix raw = raw_->compute(prepared, report);
  std::vector<std::size_t> begin(raw.size() + 1, 0);
  std::vector<FactorEntry> entries;
  entries.reserve(raw.entry_count());
  for (std::uint32_t i = 0; i < raw.size(); ++i) {
    entries.insert(entries.end(), raw.row(i).begin(), raw.row(i).end());
    normalise(std::span(entries).subspan(begin[i]));
    begin[i + 1] = entries.size();
  }
  ExchangeMatrix normalised(raw.elements(), Guarantee::kEstimated);
  normalised.assign(std::move(begin), std::move(entries));
  return normalised;
}

// With factors F off by e, and a row that should sum to 1 off by d, F / sum is off by (e + F d) / (1 - d) at most.
double error_after_division(double error, double row_error) {
  return row_error < 1 ? (error + row_error) / (1 - row_error) : std::numeric_limits<double>::infinity();
}

constexpr double kRounding = 0x1p-53;  // of a factor, and of a sum

std::optional<double> Normalised2::declared_error(const PreparedScene2& prepared) const {
  const std::optional<double> error = raw_->declared_error(prepared);
  if (!error) return error;
  const double entries = static_cast<double>(prepared.arrangement.side_count()) + 1;
  const double divided = error_after_division(*error, entries * (*error + 2 * kRounding));
  return std::isfinite(divided) ? std::optional(divided) : std::nullopt;
}

ExchangeMethod2::ClaimedErrors Normalised2::claimed_errors(const PreparedScene2& prepared) const {
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kElement);
  const ClaimedErrors raw = raw_->claimed_errors(prepared);
  std::vector<double> row_error(table.count(), 0.0);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= table.sky(); ++j) row_error[i] += raw(i, j) + 2 * kRounding;
  }
  return [raw, row_error](std::uint32_t from, std::uint32_t to) {
    return error_after_division(raw(from, to), row_error[from]);
  };
}

}  // namespace

std::string family_of_2(const std::string& name) { return name.substr(0, name.find(':')); }

SplitMethodName2 split_method_name_2(const std::string& name) {
  const std::string_view normalised = name.ends_with(kNormalised) ? kNormalised : "";
  return {name.substr(0, name.size() - normalised.size()), std::string(normalised)};
}

std::unique_ptr<ExchangeMethod2> MethodCatalogue2::make(const std::string& name) const {
  if (const SplitMethodName2 split = split_method_name_2(name); !split.normalised.empty())
    return std::make_unique<Normalised2>(make(split.raw));
  const std::string family = family_of_2(name);
  for (const MethodFamily2& each : families_)
    if (each.name == family) return each.make(std::string_view(name).substr(family.size()));
  std::string patterns;
  std::vector<std::string> known;
  for (const MethodFamily2& each : families_) {
    patterns += (patterns.empty() ? "" : ", ") + each.pattern;
    known.push_back(each.name);
  }
  throw UnknownName("there is no method called '" + name + "': " + patterns, family, known);
}

}  // namespace hottel
