#include "geometry/space/exchange/rest_for_sky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What the pairs of each element with others leave of its area.
std::vector<PairSum3> rest_of_rows(const ElementTable3& table, const std::vector<PairSum3>& pairs) {
  constexpr double kRounding = 0x1p-48;
  std::vector<PairSum3> rest(table.count());
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    const Rounded& area = table.extent(i);
    rest[i] = {.i = i, .j = table.sky(), .measure = area.value, .error = kRounding * area.value};
    rest[i].bounds = area.enclosure();
  }
  const auto take = [](PairSum3& left, const PairSum3& pair) {
    left.measure -= pair.measure;
    left.error += pair.error;
    left.bounds = {std::nextafter(left.bounds.lower - pair.bounds.upper, -kInfinity),
                   std::nextafter(left.bounds.upper - pair.bounds.lower, kInfinity)};
  };
  for (const PairSum3& pair : pairs) {
    if (pair.j == table.sky()) continue;
    take(rest[pair.i], pair);
    if (pair.j != pair.i) take(rest[pair.j], pair);
  }
  return rest;
}

}  // namespace

void enclose_sky(const ElementTable3& table, std::vector<PairSum3>& pairs) {
  const std::vector<PairSum3> rest = rest_of_rows(table, pairs);
  for (PairSum3& pair : pairs) {
    if (pair.j != table.sky()) continue;
    const Enclosure& left = rest[pair.i].bounds;
    const Enclosure both{std::max(pair.bounds.lower, left.lower), std::min(pair.bounds.upper, left.upper)};
    if (!(both.lower <= both.upper && both.upper > 0)) continue;
    pair.bounds = both;
    pair.measure = std::clamp(pair.measure, both.lower, both.upper);
  }
}

void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums) {
  std::vector<char> has_other_failure(table.count(), 0), wants(table.count(), 0);
  for (const FailedPair3& failure : sums.failures) {
    if (failure.j == table.sky()) {
      wants[failure.i] = 1;
      continue;
    }
    has_other_failure[failure.i] = has_other_failure[failure.j] = 1;
  }
  if (std::find(wants.begin(), wants.end(), 1) == wants.end()) return;
  std::vector<PairSum3> rest = rest_of_rows(table, sums.pairs);
  const auto is_known = [&](std::uint32_t i) {
    const PairSum3& left = rest[i];
    return wants[i] != 0 && has_other_failure[i] == 0 && left.measure > left.error &&
           left.error <= tolerance * table.extent(i).value;
  };
  std::erase_if(sums.failures, [&](const FailedPair3& f) { return f.j == table.sky() && is_known(f.i); });
  std::erase_if(sums.pairs, [&](const PairSum3& pair) { return pair.j == table.sky() && is_known(pair.i); });
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!is_known(i)) continue;
    rest[i].bounds.lower = std::max(0.0, rest[i].bounds.lower);
    const auto place = std::upper_bound(
        sums.pairs.begin(), sums.pairs.end(), rest[i],
        [](const PairSum3& a, const PairSum3& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
    sums.pairs.insert(place, rest[i]);
  }
}

}  // namespace hottel
