// Direct exchange areas and areas in closed form: sums of square roots.
#pragma once

#include <optional>
#include <vector>

#include "geometry/element.h"
#include "geometry/face.h"
#include "kernel/root_sum.h"

namespace hottel {

class ElementTable2;
struct PreparedScene2;

// One pair in closed form, in scene units: S(i, j), S0(i, j), A_i, A_j as sums of square roots.
//
//   (1) 0 <= exchange <= unobstructed
//   (2) exchange.is_zero() iff neither F(i, j) nor F(j, i) is an entry of the exact exchange matrix
struct ExactPair2 {
  RootSum exchange, unobstructed, area_from, area_to;
};
// Returns the pair of two elements, or of an element and the sky. Of the sky S0 = A_i, and area_to is left 0. Throws
// ContractViolation where `from` is no element, or `to` neither an element nor the sky.
// COST: a table of the elements; then one sweep about the vertices that may lie between the two (exact_sums.h).
ExactPair2 exact_pair(const PreparedScene2& prepared, Granularity granularity, std::uint32_t from, std::uint32_t to);
// The same for those who have the table of that granularity already.
ExactPair2 exact_pair(const PreparedScene2& prepared, const ElementTable2& table, Granularity granularity,
                      std::uint32_t from, std::uint32_t to);

// The same of two faces, of which one (nothing) may be the sky: its area is left 0, and S0 is the area of the other.
// Throws ContractViolation where a face is none of the scene, or both are the sky.
ExactPair2 exact_pair(const PreparedScene2& prepared, const std::optional<Face>& from, const std::optional<Face>& to);

// Returns the closed forms of many direct exchange areas S(i, j) at once, in scene units, in the order of the pairs.
// COST: one sweep for all of them (exact_sums.h).
std::vector<RootSum> exact_exchange_measures(const PreparedScene2& prepared, Granularity granularity,
                                             const std::vector<ElementPair>& pairs);

// Returns the areas of all elements in closed form, in scene units, by their numbers; the sky is left out.
std::vector<RootSum> exact_areas(const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel
