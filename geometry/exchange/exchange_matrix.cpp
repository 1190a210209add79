#include "geometry/exchange/exchange_matrix.h"

#include <algorithm>

namespace hottel {

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

}  // namespace hottel
