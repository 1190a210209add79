#include "solver/compare/grid_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/support/failure.h"
#include "solver/compare/named_factors.h"

namespace hottel {
namespace {

void require_alike(const GridValues& found, const GridValues& exact) {
  HOTTEL_REQUIRE(found.nx == exact.nx && found.ny == exact.ny && found.channels == exact.channels);
  HOTTEL_REQUIRE(found.values.size() == exact.values.size());
}

// Calls visit(value, exact) for each place in which both are finite, the found one turned.
template <class Visit>
void for_each_place(const GridValues& found, const GridValues& exact, bool turns_x, bool turns_y, const Visit& visit) {
  for (std::uint32_t y = 0; y < exact.ny; ++y)
    for (std::uint32_t x = 0; x < exact.nx; ++x)
      for (std::uint32_t c = 0; c < exact.channels; ++c) {
        const double right = exact.at(x, y, c),
                     value = found.at(turns_x ? exact.nx - 1 - x : x, turns_y ? exact.ny - 1 - y : y, c);
        if (std::isfinite(right) && std::isfinite(value)) visit(value, right);
      }
}

struct Fit {
  std::uint64_t cells = 0;
  double plain = 0, scaled = 0;  // sums of squares
  double ratio = 1;
};

Fit fit(const GridValues& found, const GridValues& exact, bool turns_x, bool turns_y) {
  Fit result;
  double products = 0, squares = 0;
  for_each_place(found, exact, turns_x, turns_y, [&](double value, double right) {
    ++result.cells;
    result.plain += (value - right) * (value - right);
    products += value * right;
    squares += right * right;
  });
  if (!(squares > 0)) return result;
  result.ratio = products / squares;
  for (const NamedFactor& named : kNamedFactors)
    if (std::abs(result.ratio / named.value - 1) < 1e-2) result.ratio = named.value;
  for_each_place(found, exact, turns_x, turns_y, [&](double value, double right) {
    const double rest = (value - result.ratio * right) / result.ratio;  // in the unit of what is right
    result.scaled += rest * rest;
  });
  return result;
}

std::string ratio_words(double ratio) {
  for (const NamedFactor& named : kNamedFactors)
    if (ratio == named.value) return std::string("times ") + named.words;
  return fmt::format("times {:.4g}", ratio);
}

}  // namespace

std::vector<GridErrors> grid_errors(const GridValues& found, const GridValues& exact) {
  require_alike(found, exact);
  std::vector<GridErrors> all;
  for (std::uint32_t c = 0; c < exact.channels; ++c) {
    GridErrors& errors = all.emplace_back();
    long double squares = 0;
    for (std::uint32_t y = 0; y < exact.ny; ++y)
      for (std::uint32_t x = 0; x < exact.nx; ++x) {
        const double right = exact.at(x, y, c), value = found.at(x, y, c);
        const bool has_right = std::isfinite(right), has_value = std::isfinite(value);
        errors.missing += has_right && !has_value;
        errors.extra += has_value && !has_right;
        if (has_right) errors.largest = std::max(errors.largest, right);
        if (!has_right || !has_value) continue;
        const double error = std::abs(value - right);
        squares += static_cast<long double>(error) * error;
        if (errors.cells++ > 0 && error <= errors.max) continue;
        errors.max = error;
        errors.ix = x;
        errors.iy = y;
        errors.value = value;
        errors.exact = right;
      }
    errors.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(errors.cells)));
    if (errors.cells == 0) errors.max = errors.rms = std::numeric_limits<double>::quiet_NaN();
  }
  return all;
}

std::string grid_reading(const GridValues& found, const GridValues& exact) {
  require_alike(found, exact);
  const double as_is = fit(found, exact, false, false).plain;
  double best = as_is / 100;
  std::string words;
  const std::array<std::array<bool, 2>, 4> turns = {{{false, false}, {false, true}, {true, false}, {true, true}}};
  const std::array<const char*, 4> names = {"", "upside down: row 0 is the highest, not the lowest",
                                            "left for right: column 0 is the rightmost",
                                            "turned about: rows and columns run the other way"};
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const Fit each = fit(found, exact, turns[k][0], turns[k][1]);
    if (each.cells == 0) continue;
    if (k > 0 && each.plain < best) {
      best = each.plain;
      words = names[k];
    }
    if (each.ratio != 1 && each.scaled < best / 4) {
      best = each.scaled;
      words = std::string(names[k]) + (k > 0 ? ", and " : "") + ratio_words(each.ratio);
    }
  }
  return words;
}

}  // namespace hottel
