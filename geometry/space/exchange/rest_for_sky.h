// What elements see of the sky, told by what they see of all else.
#pragma once

#include <span>
#include <vector>

#include "geometry/exchange_report.h"
#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"

namespace hottel {

// Gives elements whose pair with the sky could not be measured what their other pairs leave of their areas, where that
// is known within the tolerance, and more than its error: their rows then close by definition. REQUIRES all pairs of
// these elements, in order.
void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums);

// Narrows the bounds of what elements see of the sky to what their other pairs leave of their areas: proven as well as
// these are. Numbers that are outside are moved to the nearer bound. REQUIRES all pairs that are not 0.
void enclose_sky(const ElementTable3& table, std::vector<PairSum3>& pairs);

// Where the sky is told by closure, returns whose pair with it is integrated to compare, by label: the first row's, and
// each 32nd after it.
std::vector<char> checks_of_sky(const ElementTable3& table);

// Returns whose pairs with the sky have to be integrated besides, by label: those whose other pairs leave no more of
// the area than they may be off, each by the tolerance of the smaller area, so that signs decide whether they see the
// sky. REQUIRES all pairs of elements with rows; those with the sky are passed over. In any order.
std::vector<char> skies_to_integrate(const ElementTable3& table, double tolerance, std::span<const PairSum3> pairs);

// Gives all other rows what is left of their areas, and compares the integrals of those that are checked; only of those
// that are chosen, by label, where some are. What is integrated of the others is passed over, and so are failures.
// REQUIRES all pairs of these rows, and those with the sky of the rows that were to be integrated, by (i, j). Throws
// RequestError naming the row where what is left differs from an integral by more than all pairs of the row may be off.
SkyByClosure take_sky_by_closure(const ElementTable3& table, double tolerance, PairSums3& sums,
                                 const std::vector<char>* is_chosen = nullptr);

}  // namespace hottel
