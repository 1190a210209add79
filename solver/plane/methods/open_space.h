// Elements whose enclosing walls do not by themselves exclude a view of the sky.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// Returns for every element, by its place in the table, whether its front borders the open space: whether a way that
// crosses no piece leads from some point before the front to infinity. An element that does not sees no sky; one that
// does may see none.
std::vector<char> borders_open_space(const Arrangement2& arrangement, const ElementTable2& table);

}  // namespace hottel
