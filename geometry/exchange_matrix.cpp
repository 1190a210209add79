#include "geometry/exchange_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw ContractViolation("not an exchange matrix: " + what); }

}  // namespace

void ExchangeMatrix::assign(std::vector<std::size_t> begin, FactorEntries entries, std::vector<double> measures,
                            std::vector<Enclosure> bounds, std::vector<Guarantee> guarantees) {
  begin_ = std::move(begin);
  entries_ = std::move(entries);
  memory_ = entries_.columns_.get_allocator().memory();
  if (std::ranges::all_of(entries_.sides_, [](signed char side) { return side == 0; }))
    entries_.sides_ = PlacedArray<signed char>();
  measures_ = std::move(measures);
  bounds_ = std::move(bounds);
  guarantees_ = std::move(guarantees);
  require_order();
  require_lists();
  if (!guarantees_.empty()) {
    const auto [strongest, weakest] = std::minmax_element(guarantees_.begin(), guarantees_.end());
    const bool are_alike = *strongest == *weakest;
    guarantee_ = *weakest;
    if (are_alike) guarantees_ = {};
  }
  if (guarantee_ == Guarantee::kExact) bounds_ = {};
  for (std::uint32_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < row(i).size(); ++k) require_guarantee(i, k);
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

void ExchangeMatrix::require_lists() const {
  const auto require = [this](std::size_t members, const char* what) {
    if (members != 0 && members != entries_.size())
      refuse(fmt::format("{} entries, and {} of {}", entries_.size(), what, members));
  };
  require(measures_.size(), "measures");
  require(bounds_.size(), "bounds");
  require(guarantees_.size(), "guarantees");
}

void ExchangeMatrix::require_guarantee(std::uint32_t i, std::size_t k) const {
  const Rounded factor = row(i)[k].factor;
  const Guarantee guaranteed = guarantee(i, k);
  if (guaranteed == Guarantee::kExact) {
    const bool is_positive = factor.value > 0 || (factor.value == 0 && factor.side > 0);
    if (!is_positive || !std::isfinite(factor.value))
      refuse(fmt::format("an exact factor of '{}' is {}", elements_[i].name, factor.value));
    return;
  }
  if (bounds_.empty() && guaranteed == Guarantee::kEstimated) return;
  if (bounds_.empty()) refuse(fmt::format("{} entries, and bounds of 0", entries_.size()));
  const Enclosure within = bounds(i, k);
  const bool is_fitting = guaranteed == Guarantee::kEstimated || within.contains(factor.value);
  if (!(0 <= within.lower && within.lower <= within.upper && std::isfinite(within.upper) && is_fitting))
    refuse(fmt::format("a factor of '{}' is {} within [{}, {}]", elements_[i].name, factor.value, within.lower,
                       within.upper));
}

Enclosure ExchangeMatrix::bounds(std::uint32_t i, std::size_t k) const {
  if (guarantee(i, k) == Guarantee::kExact) return row(i)[k].factor.enclosure();
  return bounds_.empty() ? Enclosure{0, 1} : bounds_[begin_[i] + k];
}

Rounded ExchangeMatrix::factor(std::uint32_t from, std::uint32_t to) const {
  const auto entry = row(from).find(to);
  return entry ? entry->factor : Rounded{};
}

Rounded ExchangeMatrix::factor(const std::string& from, const std::string& to) const {
  const std::uint32_t i = require_element(*this, from), j = require_element(*this, to);
  if (i == sky()) throw UsageError("there are no view factors from the sky");
  if (!has_row(i))
    throw UsageError("there are no view factors from " + quoted_name(from) + ": it has " +
                     (elements_[i].material ? "no area" : "no material"));
  return factor(i, j);
}

const std::string& ExchangeMatrix::name(std::uint32_t column) const {
  static const std::string kSky = "sky";
  HOTTEL_REQUIRE(column <= sky());
  return column == sky() ? kSky : elements_[column].name;
}

std::optional<std::uint32_t> ExchangeMatrix::find(const std::string& name) const {
  if (name == this->name(sky())) return sky();
  for (std::uint32_t i = 0; i < size(); ++i)
    if (elements_[i].name == name) return i;
  return std::nullopt;
}

std::uint32_t require_element(const ExchangeMatrix& matrix, const std::string& name) {
  if (const auto found = matrix.find(name)) return *found;
  std::vector<std::string> known;
  for (const Element& element : matrix.elements()) known.push_back(element.name);
  known.push_back(matrix.name(matrix.sky()));
  throw UnknownName("there is no face called '" + name + "'", name, known);
}

}  // namespace hottel
