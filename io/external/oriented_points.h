// Lists of points with normals that others write, in the plane and in space.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// A small area: where it is, and which way its front looks. In the plane the third numbers are 0.
struct OrientedPoint {
  std::array<Rational, 3> point, normal;  // the normal is not zero, of any length
};

// Whether a text is a csv whose first line names normals: one of its names is nx.
bool names_normals(std::string_view text);

// Returns the points of such a csv, in its order, exactly as typed. Its first line is x,y,nx,ny in the plane and
// x,y,z,nx,ny,nz in space; a number is an integer, a decimal or p/q; blanks about a field do not count.
//
// Throws InputError with file and line for another first line, naming the one that is understood, for a line with
// another number of fields, a number that is none, a normal that is zero, and where there is no point. COST: linear.
std::vector<OrientedPoint> read_oriented_points(std::string_view text, const std::string& name_for_messages,
                                                int dimension);

}  // namespace hottel
