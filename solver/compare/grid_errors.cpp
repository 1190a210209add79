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

// How a grid may lie: its rows, its columns the other way round, then the axes exchanged.
struct Turn {
  bool turns_x, turns_y, exchanges;
  const char* words;
};

constexpr std::array kTurns = {
    Turn{false, false, false, ""},
    Turn{false, true, false, "upside down: row 0 is the highest, not the lowest"},
    Turn{true, false, false, "left for right: column 0 is the rightmost"},
    Turn{true, true, false, "turned about: rows and columns run the other way"},
    Turn{false, false, true, "that of exchanged axes: its first index runs along x, not along y"},
    Turn{false, true, true, "turned by a quarter"},
    Turn{true, false, true, "turned by a quarter"},
    Turn{true, true, true, "that of exchanged axes, and turned about"},
};

// Calls visit(value, exact) for each place in which both are finite, the found one turned.
template <class Visit>
void for_each_place(const GridValues& found, const GridValues& exact, const Turn& turn, const Visit& visit) {
  for (std::uint32_t y = 0; y < exact.ny; ++y)
    for (std::uint32_t x = 0; x < exact.nx; ++x)
      for (std::uint32_t c = 0; c < exact.channels; ++c) {
        const std::uint32_t ix = turn.turns_x ? exact.nx - 1 - x : x, iy = turn.turns_y ? exact.ny - 1 - y : y;
        const double right = exact.at(x, y, c), value = turn.exchanges ? found.at(iy, ix, c) : found.at(ix, iy, c);
        if (std::isfinite(right) && std::isfinite(value)) visit(value, right);
      }
}

struct Fit {
  std::uint64_t cells = 0;
  double plain = 0, scaled = 0;  // sums of squares
  double ratio = 1;
};

Fit fit(const GridValues& found, const GridValues& exact, const Turn& turn) {
  Fit result;
  double products = 0, squares = 0;
  for_each_place(found, exact, turn, [&](double value, double right) {
    ++result.cells;
    result.plain += (value - right) * (value - right);
    products += value * right;
    squares += right * right;
  });
  if (!(squares > 0)) return result;
  result.ratio = products / squares;
  const auto distance = [ratio = result.ratio](const NamedFactor& named) { return std::abs(ratio / named.value - 1); };
  const NamedFactor& nearest =
      *std::min_element(kNamedFactors.begin(), kNamedFactors.end(),
                        [&](const NamedFactor& a, const NamedFactor& b) { return distance(a) < distance(b); });
  if (distance(nearest) < 1e-2) result.ratio = nearest.value;
  for_each_place(found, exact, turn, [&](double value, double right) {
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

std::vector<GridErrors> grid_errors(const GridValues& found, const GridValues& exact, double beyond,
                                    const WrittenDigits& digits) {
  require_alike(found, exact);
  std::vector<GridErrors> all;
  for (std::uint32_t c = 0; c < exact.channels; ++c) {
    GridErrors& errors = all.emplace_back();
    long double squares = 0, sum = 0, exact_sum = 0;
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
        sum += value - right;
        exact_sum += right;
        if (errors.cells++ > 0 && error <= errors.max) continue;
        errors.max = error;
        errors.ix = x;
        errors.iy = y;
        errors.value = value;
        errors.exact = right;
      }
    for (std::uint32_t y = 0; y < exact.ny; ++y)
      for (std::uint32_t x = 0; x < exact.nx; ++x) {
        const double value = found.at(x, y, c), error = std::abs(value - exact.at(x, y, c));
        errors.off += std::isfinite(error) && error > beyond * errors.largest + digits.rounding(value);
      }
    errors.rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(errors.cells)));
    errors.bias = static_cast<double>(sum / static_cast<long double>(errors.cells));
    errors.mean = static_cast<double>(exact_sum / static_cast<long double>(errors.cells));
    if (errors.cells == 0)
      errors.max = errors.rms = errors.bias = errors.mean = std::numeric_limits<double>::quiet_NaN();
  }
  return all;
}

std::string grid_reading(const GridValues& found, const GridValues& exact) {
  require_alike(found, exact);
  double best = fit(found, exact, kTurns[0]).plain / 100;
  std::string words;
  for (std::size_t k = 0; k < kTurns.size(); ++k) {
    if (kTurns[k].exchanges && exact.nx != exact.ny) continue;
    const Fit each = fit(found, exact, kTurns[k]);
    if (each.cells == 0) continue;
    if (k > 0 && each.plain < best) {
      best = each.plain;
      words = kTurns[k].words;
    }
    if (each.ratio != 1 && each.scaled < best / 4) {
      best = each.scaled;
      words = std::string(kTurns[k].words) + (k > 0 ? ", and " : "") + ratio_words(each.ratio);
    }
  }
  return words;
}

}  // namespace hottel
