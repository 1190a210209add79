// How values run over the elements of a picture.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/element.h"

namespace hottel {

// kFlat:    each element has its value all over
// kSmooth:  values are blended: over flat surfaces in space (SmoothMesh3), along faces in the plane (RunValues2)
// kParents: the same, of values_from_parents
// kGathered: in space: each point has what arrives there (gathered_view_3)
enum class Shading : unsigned char { kFlat, kSmooth, kParents, kGathered };

// "flat", "smooth", "parents", "gathered"; nothing for other names.
std::optional<Shading> shading_of(std::string_view name);

// Returns values by element and channel in which the finest elements have that of their parent: the mean of its
// children by their areas (lengths). The finest are those at the deepest level of the tree under a part of a face; so
// the children of a parent are all finest, and all active. Where light ends, values of the finest go up and down as its
// border cuts them; those of parents do so less, at the price of one level.
//
//   (1) elements above the deepest level, and all of a part without a tree, keep their values
//   (2) the mean of a face's elements by their areas stays, and so does its light
//   (3) no value leaves the range of those of its siblings; equal ones stay, exactly
//   (4) what has no value (NaN) has none, and counts for nothing
// REQUIRES elements as the tables have them: siblings follow each other. COST: linear.
std::vector<double> values_from_parents(std::span<const Element> elements, std::span<const double> values,
                                        std::size_t channels);

}  // namespace hottel
