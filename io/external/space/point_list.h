// Lists of points in space that others write.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

// Whether a text is a csv whose first line has three fields.
bool are_points_3(std::string_view text);

// Returns the points of a csv of lines x,y,z, in its order, exactly as typed: a number is an integer, a decimal or p/q,
// blanks about it do not count, and a first line x,y,z is allowed.
//
// Throws InputError with file and line for a line with another number of fields, a number that is none, and where there
// is no point. COST: linear.
std::vector<Point3> read_points_3(std::string_view text, const std::string& name_for_messages);

}  // namespace hottel
