// A value by successive divisions: with which order it converges, and to what.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hottel {

// Returns the order p with which two changes, of a value by n0, n1 and n2 elements, fit one error c n^-p: the changes
// from n0 to n1 and from n1 to n2 have the ratio (n0^-p - n1^-p) / (n1^-p - n2^-p). Below 0 where the error grows.
//
//   (1) where each division is r times the one before: log(change / next) / log(r)
//   (2) nothing where one of them is 0 or no number, where their signs differ, or where p is not from -20 to 20
// REQUIRES 0 < n0 < n1 < n2.
std::optional<double> order_of_changes(double change, double next, std::uint32_t n0, std::uint32_t n1,
                                       std::uint32_t n2);

// How a value goes on as elements are divided.
enum class Convergence {
  kUnknown,      // fewer than two orders, and nothing that speaks against it
  kSettled,      // the last two changes are below the resolution
  kRegular,      // the orders are within 1/2 of each other, and above 0
  kOfBothSigns,  // changes have different signs
  kGrowing,      // changes do not get smaller
  kUneven,       // the orders differ by more
};
bool is_irregular(Convergence convergence);

// A value by divisions, the coarsest first, and what that tells.
//
//   (1) orders: one for each division, of it and the two before; nothing for the first two, and where a change is below
//       the resolution or order_of_changes() has none
//   (2) extrapolated: the value without error where the error is c n^-p, of the last order (Richardson); the last value
//       itself where it is settled; nothing without an order above 0
struct DivisionOrders {
  std::vector<std::optional<double>> orders{};
  std::optional<double> extrapolated{};
  Convergence convergence = Convergence::kUnknown;
};
// resolution: what a value is known to. REQUIRES as many divisions, ascending, as values.
DivisionOrders division_orders(std::span<const std::uint32_t> divisions, std::span<const double> values,
                               double resolution);

// In words: "regular", "settled", "irregular: changes of both signs", "irregular: changes grow",
// "irregular: orders from 0.9 to 2.6"; empty for kUnknown.
std::string convergence_text(const DivisionOrders& orders);

}  // namespace hottel
