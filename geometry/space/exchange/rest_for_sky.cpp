#include "geometry/space/exchange/rest_for_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/space/vectors/local_vector.h"
#include "kernel/doubles.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What an element's pairs with others leave of its area.
struct Rest {
  PairSum3 sky;                // as its pair with the sky
  CompensatedSum<double> sum;  // its measure
  double allowed = 0;          // what the pairs may be off together: the tolerance of the smaller area each

  void take(const PairSum3& pair, double may_be_off) {
    sum.add(-pair.measure);
    sky.error += pair.error;
    allowed += may_be_off;
    sky.bounds = {std::nextafter(sky.bounds.lower - pair.bounds.upper, -kInfinity),
                  std::nextafter(sky.bounds.upper - pair.bounds.lower, kInfinity)};
  }
};

// By label. The numbers do not depend on the order of the pairs.
std::vector<Rest> rest_of_rows(const ElementTable3& table, double tolerance, std::span<const PairSum3> pairs) {
  constexpr double kRounding = 0x1p-48;
  std::vector<Rest> rest(table.count());
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    const Rounded& area = table.extent(i);
    rest[i].sky = {.i = i, .j = table.sky(), .error = kRounding * area.value};
    rest[i].sum.add(area.value);
    rest[i].sky.bounds = area.enclosure();
  }
  const auto take = [&](const PairSum3& pair) {
    if (pair.j == table.sky() || pair.is_zero()) return;
    const double allowed =
        tolerance * std::min(table.extent(pair.i).enclosure().lower, table.extent(pair.j).enclosure().lower);
    rest[pair.i].take(pair, allowed);
    if (pair.j != pair.i) rest[pair.j].take(pair, allowed);
  };
  const auto key = [](const PairSum3& pair) { return std::pair(pair.i, pair.j); };
  if (std::ranges::is_sorted(pairs, {}, key)) {
    for (const PairSum3& pair : pairs) take(pair);
  } else {
    std::vector<const PairSum3*> sorted;
    sorted.reserve(pairs.size());
    for (const PairSum3& pair : pairs) sorted.push_back(&pair);
    std::ranges::sort(sorted, {}, [&](const PairSum3* pair) { return key(*pair); });
    for (const PairSum3* const pair : sorted) take(*pair);
  }
  for (Rest& left : rest) left.sky.measure = left.sum.value();
  return rest;
}

// Whether what is left is the sky's beyond doubt.
bool is_told(const ElementTable3& table, const Rest& left) {
  const PairSum3& sky = left.sky;
  return table.has_row(sky.i) && sky.measure > std::max(left.allowed, sky.error) && sky.bounds.upper > 0;
}

// A number of elements to be told of, over an area.
double over_area(const ElementTable3& table, const Rest& left, double measure) {
  return measure / table.extent(left.sky.i).value;
}

// Gives some rows what is left in place of their pairs with the sky, or of failures to measure these.
void put_rest(const ElementTable3& table, const std::vector<Rest>& rest, const std::vector<char>& of_rows,
              PairSums3& sums) {
  std::vector<PairSum3>& pairs = sums.pairs;
  const auto is_replaced = [&](const auto& pair) { return pair.j == table.sky() && of_rows[pair.i] != 0; };
  std::erase_if(sums.failures, is_replaced);
  std::erase_if(pairs, is_replaced);
  const auto middle = static_cast<std::ptrdiff_t>(pairs.size());
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (of_rows[i] == 0) continue;
    pairs.push_back(rest[i].sky);
    pairs.back().bounds.lower = std::max(0.0, pairs.back().bounds.lower);
  }
  std::inplace_merge(pairs.begin(), pairs.begin() + middle, pairs.end(),
                     [](const PairSum3& a, const PairSum3& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
}

// Compares what is left of a checked row with its integral; nothing stands for S = 0.
void compare(const ElementTable3& table, double tolerance, const Rest& left, const PairSum3* integral,
             SkyByClosure& told) {
  const double measure = integral == nullptr ? 0 : integral->measure, error = integral == nullptr ? 0 : integral->error;
  const double difference = std::fabs(left.sky.measure - measure);
  const double allowed = left.allowed + tolerance * table.extent(left.sky.i).value;
  const std::string& name = table.elements()[left.sky.i].name;
  if (!(difference <= std::max(allowed, left.sky.error + error)))
    throw RequestError(fmt::format(
        "the row of {} leaves {} to the sky, which is {} by integration: they differ by {:.2g}, and may by {:.2g}. "
        "Without --sky closure the sky is integrated",
        quoted_name(name), shortest(over_area(table, left, left.sky.measure)),
        shortest(over_area(table, left, measure)), over_area(table, left, difference),
        over_area(table, left, allowed)));
  ++told.checked;
  told.beyond += difference > left.sky.error + error ? 1 : 0;
  if (const double off = over_area(table, left, difference); off > told.max_difference) {
    told.max_difference = off;
    told.farthest = name;
  }
}

}  // namespace

void enclose_sky(const ElementTable3& table, std::vector<PairSum3>& pairs) {
  const std::vector<Rest> rest = rest_of_rows(table, 0, pairs);
  for (PairSum3& pair : pairs) {
    if (pair.j != table.sky()) continue;
    const Enclosure& left = rest[pair.i].sky.bounds;
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
  const std::vector<Rest> rest = rest_of_rows(table, tolerance, sums.pairs);
  std::vector<char> is_known(table.count(), 0);
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    const PairSum3& left = rest[i].sky;
    is_known[i] = wants[i] != 0 && has_other_failure[i] == 0 && left.measure > left.error &&
                          left.error <= tolerance * table.extent(i).value
                      ? 1
                      : 0;
  }
  put_rest(table, rest, is_known, sums);
}

std::vector<char> checks_of_sky(const ElementTable3& table) {
  std::vector<char> result(table.count() + std::size_t{1}, 0);
  std::uint32_t rows = 0;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    if (table.has_row(i)) result[i] = rows++ % kRowsOfASkyCheck == 0 ? 1 : 0;
  return result;
}

std::vector<char> skies_to_integrate(const ElementTable3& table, double tolerance, std::span<const PairSum3> pairs) {
  std::vector<char> result = checks_of_sky(table);
  const std::vector<Rest> rest = rest_of_rows(table, tolerance, pairs);
  for (std::uint32_t i = 0; i < table.count(); ++i)
    result[i] = table.has_row(i) && result[i] == 0 && !is_told(table, rest[i]) ? 1 : 0;
  return result;
}

SkyByClosure take_sky_by_closure(const ElementTable3& table, double tolerance, PairSums3& sums,
                                 const std::vector<char>* is_chosen) {
  const std::vector<Rest> rest = rest_of_rows(table, tolerance, sums.pairs);
  const std::vector<char> is_checked = checks_of_sky(table);
  std::vector<const PairSum3*> integrals(table.count(), nullptr);
  for (const PairSum3& pair : sums.pairs)
    if (pair.j == table.sky()) integrals[pair.i] = &pair;
  std::vector<char> has_failed(table.count(), 0), has_rest(table.count(), 0);
  for (const FailedPair3& failure : sums.failures)
    if (failure.j == table.sky()) has_failed[failure.i] = 1;
  SkyByClosure told;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i) || (is_chosen != nullptr && (*is_chosen)[i] == 0)) continue;
    if (is_checked[i] != 0) {
      if (has_failed[i] == 0) compare(table, tolerance, rest[i], integrals[i], told);
    } else if (!is_told(table, rest[i])) {
      ++told.integrated;
    } else {
      has_rest[i] = 1;
      ++told.told;
      told.max_error = std::max(told.max_error, over_area(table, rest[i], rest[i].sky.error));
      told.within = std::max({told.within, told.max_error, over_area(table, rest[i], rest[i].allowed)});
    }
  }
  put_rest(table, rest, has_rest, sums);
  return told;
}

}  // namespace hottel
