#include "solver/compare/division_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kMostOrder = 20, kMostSpread = 0.5;

// (n0^-p - n1^-p) / (n1^-p - n2^-p), which ascends with p.
double ratio_of(double p, double n0, double n1, double n2) {
  const double first = same_bits::log(n1 / n0), second = same_bits::log(n2 / n1);
  if (std::abs(p) < 1e-9) return first / second;
  return same_bits::expm1(p * first) / -same_bits::expm1(-p * second);
}

// The smallest and the largest of the orders that there are.
std::pair<double, double> range_of(const std::vector<std::optional<double>>& orders) {
  double least = kMostOrder, most = -kMostOrder;
  for (const std::optional<double>& order : orders)
    if (order) {
      least = std::min(least, *order);
      most = std::max(most, *order);
    }
  return {least, most};
}

Convergence convergence_of(std::span<const double> values, double resolution,
                           const std::vector<std::optional<double>>& orders) {
  int rising = 0, falling = 0;
  std::size_t still = 0;  // changes since the last one that is one
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double change = values[k] - values[k - 1];
    ++still;
    if (!(std::abs(change) > resolution)) continue;
    still = 0;
    ++(change > 0 ? rising : falling);
  }
  if (still > 1) return Convergence::kSettled;
  if (rising > 0 && falling > 0) return Convergence::kOfBothSigns;
  const auto [least, most] = range_of(orders);
  if (least > most) return Convergence::kUnknown;
  if (least <= 0) return Convergence::kGrowing;
  if (most - least > kMostSpread) return Convergence::kUneven;
  const auto count = std::ranges::count_if(orders, [](const auto& order) { return order.has_value(); });
  return count > 1 ? Convergence::kRegular : Convergence::kUnknown;
}

}  // namespace

std::optional<double> order_of_changes(double change, double next, std::uint32_t n0, std::uint32_t n1,
                                       std::uint32_t n2) {
  HOTTEL_REQUIRE(0 < n0 && n0 < n1 && n1 < n2);
  const double ratio = change / next;
  if (!(ratio > 0) || !std::isfinite(ratio)) return std::nullopt;
  double low = -kMostOrder, high = kMostOrder;
  if (!(ratio_of(low, n0, n1, n2) <= ratio && ratio <= ratio_of(high, n0, n1, n2))) return std::nullopt;
  for (int k = 0; k < 64; ++k) {
    const double middle = (low + high) / 2;
    (ratio_of(middle, n0, n1, n2) < ratio ? low : high) = middle;
  }
  return (low + high) / 2;
}

bool is_irregular(Convergence convergence) {
  return convergence == Convergence::kOfBothSigns || convergence == Convergence::kGrowing ||
         convergence == Convergence::kUneven;
}

DivisionOrders division_orders(std::span<const std::uint32_t> divisions, std::span<const double> values,
                               double resolution) {
  HOTTEL_REQUIRE(divisions.size() == values.size());
  DivisionOrders result;
  result.orders.resize(values.size());
  for (std::size_t k = 2; k < values.size(); ++k) {
    const double change = values[k - 1] - values[k - 2], next = values[k] - values[k - 1];
    if (std::abs(change) > resolution && std::abs(next) > resolution)
      result.orders[k] = order_of_changes(change, next, divisions[k - 2], divisions[k - 1], divisions[k]);
  }
  result.convergence = convergence_of(values, resolution, result.orders);
  if (result.convergence == Convergence::kSettled) {
    result.extrapolated = values.back();
  } else if (!values.empty() && result.orders.back() && *result.orders.back() > 0) {
    const std::size_t last = values.size() - 1;
    const double ratio = static_cast<double>(divisions[last]) / divisions[last - 1];
    result.extrapolated = values[last] + (values[last] - values[last - 1]) /
                                             same_bits::expm1(*result.orders[last] * same_bits::log(ratio));
  }
  return result;
}

std::string convergence_text(const DivisionOrders& orders) {
  switch (orders.convergence) {
    case Convergence::kUnknown:
      return "";
    case Convergence::kSettled:
      return "settled";
    case Convergence::kRegular:
      return "regular";
    case Convergence::kOfBothSigns:
      return "irregular: changes of both signs";
    case Convergence::kGrowing:
      return "irregular: changes grow";
    case Convergence::kUneven:
      break;
  }
  const auto [least, most] = range_of(orders.orders);
  return fmt::format("irregular: orders from {:.1f} to {:.1f}", least, most);
}

}  // namespace hottel
