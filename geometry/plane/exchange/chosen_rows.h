// View factors of some elements of a scene in the plane alone, in doubles.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

class ElementTable2;

// What an element sends to others: pairs of a column and F, the sky as table.sky().
using PlainRow2 = std::vector<std::pair<std::uint32_t, double>>;

// Returns a row for each element of the table, ascending by column; empty where the table has none
// (ElementTable2::keep_rows).
//
//   (1) F is the double nearest to the real number or a neighbour of that, but for what the fixed point of lengths
//       loses: less than 1e-20 of the largest distance in the scene over the length of the element
//   (2) rows sum to 1, up to the rounding of the sum
//   (3) the same bits for any number of threads
//
// REQUIRES: a table of the prepared scene. Throws RequestError where there are more than most_pairs, and what
// `progress` throws. COST: a sweep about the swept_vertices(), and the pairs of which one has a
// row.
std::vector<PlainRow2> chosen_rows(const PreparedScene2& prepared, const ElementTable2& table, std::uint64_t most_pairs,
                                   const std::function<void(double)>& progress = {});

}  // namespace hottel
