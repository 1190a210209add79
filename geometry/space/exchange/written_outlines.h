// The outlines of elements in space as files hold them.
#pragma once

#include <array>
#include <vector>

namespace hottel {

class ElementTable3;
class Vertices3;

// What is left of an element: its connected parts, of each an outline and its holes, each a list of corners.
using WrittenLoop3 = std::vector<std::array<double, 3>>;
using WrittenOutline3 = std::vector<std::vector<WrittenLoop3>>;

// Returns the outline of each element in scene coordinates, in the order of the elements; none of groups, and none
// where nothing is left of an element.
//
//   (1) seen from the side of the element outlines go around counter-clockwise, holes clockwise
//   (2) an element of one convex patch has the corners of that, in their order; of others the patches of each plane are
//       joined (joined_outline), where the polygon is not exactly plane each triangle by itself
//   (3) each coordinate is as written_double has it: NaN where its nearest double is 0 and it is not
std::vector<WrittenOutline3> written_outlines(const ElementTable3& table, const Vertices3& vertices);

}  // namespace hottel
