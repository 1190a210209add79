// What verdicts ask of the scene behind the exact factors.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/judged_pairs.h"

namespace hottel {

// Factors of the elements of a scene by a method that is not exact, and its name.
struct ApproximateFactors {
  std::string method;
  ExchangeMatrix matrix;
};

inline constexpr std::uint32_t kMostApproximated = 2000;  // elements

// A scene whose factors are judged. Hypotheses that follow from more than the numbers ask it; they know of no
// dimension. Asked only when some pair is off.
class JudgedScene {
 public:
  virtual ~JudgedScene() = default;

  // The name of a surface, to be printed. REQUIRES an index of Element::surface.
  virtual const std::string& surface_name(std::uint32_t surface) const = 0;

  // Returns F(from, to) without any obstacle, by place in judged.pairs(): of pairs that are off and whose second is not
  // the sky; 0 for the others.
  virtual std::vector<double> unobstructed_factors(const JudgedPairs& judged) const = 0;

  // Returns factors of the same elements by methods that are cheap and not exact; none of scenes that are large.
  virtual std::vector<ApproximateFactors> approximate_factors() const = 0;

  // Returns the exact factors of the same surfaces when both sides of each have a material, divided as before. Nothing
  // where backs with a material would make claims that the scene cannot grant.
  virtual std::optional<ExchangeMatrix> factors_of_both_sides() const = 0;
};

}  // namespace hottel
