#include "geometry/exchange_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw ContractViolation("not an exchange matrix: " + what); }

}  // namespace

void ExchangeMatrix::assign(std::vector<std::size_t> begin, std::vector<FactorEntry> entries,
                            std::vector<double> measures, std::vector<Enclosure> bounds) {
  begin_ = std::move(begin);
  entries_ = std::move(entries);
  measures_ = std::move(measures);
  bounds_ = std::move(bounds);
  require_order();
  require_guarantee();
}

void ExchangeMatrix::require_order() const {
  if (begin_.size() != elements_.size() + 1 || begin_.front() != 0 || begin_.back() != entries_.size())
    refuse(fmt::format("{} rows that begin in {} places, and {} entries", size(), begin_.size(), entries_.size()));
  if (!std::is_sorted(begin_.begin(), begin_.end())) refuse("a row ends before it begins");
  for (std::uint32_t i = 0; i < size(); ++i) {
    const auto entries = row(i);
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (entries[k].to > sky() || (k > 0 && entries[k - 1].to >= entries[k].to))
        refuse(fmt::format("the columns of '{}' do not ascend to {} at most: {}{}", elements_[i].name, sky(),
                           k > 0 ? fmt::format("{}, ", entries[k - 1].to) : "", entries[k].to));
  }
}

void ExchangeMatrix::require_guarantee() const {
  if (!measures_.empty() && measures_.size() != entries_.size())
    refuse(fmt::format("{} entries, and measures of {}", entries_.size(), measures_.size()));
  if (guarantee_ == Guarantee::kEstimated) return;
  if (guarantee_ == Guarantee::kEnclosed && bounds_.size() != entries_.size())
    refuse(fmt::format("{} entries, and bounds of {}", entries_.size(), bounds_.size()));
  for (std::uint32_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < row(i).size(); ++k) {
      const Rounded& factor = row(i)[k].factor;
      if (guarantee_ == Guarantee::kExact) {
        const bool is_positive = factor.value > 0 || (factor.value == 0 && factor.side > 0);
        if (!is_positive || !std::isfinite(factor.value))
          refuse(fmt::format("an exact factor of '{}' is {}", elements_[i].name, factor.value));
      } else {
        const Enclosure within = bounds(i, k);
        if (!(0 <= within.lower && within.contains(factor.value) && std::isfinite(within.upper)))
          refuse(fmt::format("a factor of '{}' is {} within [{}, {}]", elements_[i].name, factor.value, within.lower,
                             within.upper));
      }
    }
}

Enclosure ExchangeMatrix::bounds(std::uint32_t i, std::size_t k) const {
  switch (guarantee_) {
    case Guarantee::kExact:
      return entries_[begin_[i] + k].factor.enclosure();
    case Guarantee::kEnclosed:
      return bounds_[begin_[i] + k];
    case Guarantee::kEstimated:
      break;
  }
  return {0, 1};
}

Rounded ExchangeMatrix::factor(std::uint32_t from, std::uint32_t to) const {
  const auto entries = row(from);
  const auto place = std::lower_bound(entries.begin(), entries.end(), to,
                                      [](const FactorEntry& entry, std::uint32_t column) { return entry.to < column; });
  return place != entries.end() && place->to == to ? place->factor : Rounded{};
}

std::optional<std::uint32_t> ExchangeMatrix::find(const std::string& name) const {
  if (name == "sky") return sky();
  for (std::uint32_t i = 0; i < size(); ++i)
    if (elements_[i].name == name) return i;
  return std::nullopt;
}

std::uint32_t require_element(const ExchangeMatrix& matrix, const std::string& name) {
  if (const auto found = matrix.find(name)) return *found;
  std::vector<std::string> known;
  for (const Element& element : matrix.elements()) known.push_back(element.name);
  known.emplace_back("sky");
  throw UnknownName("there is no face called '" + name + "'", name, known);
}

}  // namespace hottel
