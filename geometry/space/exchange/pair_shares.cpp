#include "geometry/space/exchange/pair_shares.h"

#include <algorithm>
#include <limits>

#include "geometry/space/unobstructed/unobstructed.h"

namespace hottel {

using Part = ElementTable3::Part;

PairShares3::PairShares3(const ElementTable3& table, const Vertices3& vertices, double tolerance)
    : vertices_(vertices), tolerance_(tolerance), holders_(table.holders() + std::size_t{1}) {
  for (const Part& part : table.parts()) {
    Holder& holder = holders_[part.holder];
    if (!part.patch.is_sky()) holder.of_patches += patch_area(vertices, part.patch).upper;
    ++holder.count;
  }
  std::vector<std::uint32_t> free_count(holders_.size(), 0);
  for (std::uint32_t label = 0; label < table.count(); ++label)
    for (const Part& part : table.free_parts(label)) {
      Holder& holder = holders_[part.holder];
      holder.area += patch_area(vertices, part.patch).lower;
      holder.count = std::max(holder.count, ++free_count[part.holder]);
    }
  if (!table.is_by_group())
    for (std::uint32_t label = 0; label < table.count(); ++label)
      holders_[label].area = table.extent(label).enclosure().lower;
  holders_.back().area = std::numeric_limits<double>::infinity();
}

double PairShares3::least_area(std::uint32_t i, std::uint32_t j) const {
  return std::min(holders_[i].area, holders_[j].area);
}

double PairShares3::allowed(std::uint32_t i, std::uint32_t j) const { return tolerance_ * least_area(i, j); }

double PairShares3::part_of_area(const Part& part) const {
  if (part.patch.is_sky()) return 1;
  return std::min(1.0, patch_area(vertices_, part.patch).lower / holders_[part.holder].of_patches);
}

double PairShares3::share(const Part& a, const Part& b) const {
  const Holder &i = holders_[a.holder], &j = holders_[b.holder];
  const double all = allowed(a.holder, b.holder);
  if (i.count == 1 && j.count == 1) return all;
  const double alike = 1 / (static_cast<double>(i.count) * static_cast<double>(j.count));
  return all * (part_of_area(a) * part_of_area(b) + alike) / 2;
}

}  // namespace hottel
