// The corners of elements in space as files hold them.
#pragma once

#include <array>
#include <vector>

namespace hottel {

class ElementTable3;
class Vertices3;

// Returns what element_corners does, each coordinate as written_double has it: NaN where its nearest double is 0 and it
// is not.
std::vector<std::vector<std::array<double, 3>>> written_corners(const ElementTable3& table, const Vertices3& vertices);

}  // namespace hottel
