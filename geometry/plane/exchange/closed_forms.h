// Exchange measures and areas in closed form: sums of square roots.
#pragma once

#include <optional>
#include <vector>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/exchange/element_table.h"
#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/scene_names.h"
#include "kernel/root_sum.h"

namespace hottel {

// One pair in closed form, in scene units: S(i, j), S0(i, j), A_i, A_j as sums of square roots.
struct ExactPair2 {
  RootSum exchange, unobstructed, area_from, area_to;
};
ExactPair2 exact_pair(const PreparedScene2& prepared, Granularity granularity, std::uint32_t from, std::uint32_t to);
// The same for those who have the labels of `per` already.
ExactPair2 exact_pair(const PreparedScene2& prepared, const ElementTable2& table, Granularity granularity,
                      std::uint32_t from, std::uint32_t to);

// Of two faces, of which one (nothing) may be the sky, whose area is left 0 and which takes all there is: S0 = A.
ExactPair2 exact_pair(const PreparedScene2& prepared, const std::optional<Face>& from, const std::optional<Face>& to);

// Closed forms of many exchange measures S(i, j) at once, in scene units.
std::vector<RootSum> exact_exchange_measures(const PreparedScene2& prepared, Granularity granularity,
                                             const std::vector<ElementPair>& pairs);

// Areas of all labels in closed form, in scene units.
std::vector<RootSum> exact_areas(const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel
