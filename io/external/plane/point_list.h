// Lists of points that others write: csv, GeoJSON and well-known text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/point.h"
#include "io/scene/passed_over.h"

namespace hottel {

// Returns the points of a text, in its order, exactly as typed: a number is an integer, a decimal or p/q, "0.1" is one
// tenth, and nothing is ever rounded. The first character that is no blank decides the format:
//
//   {        GeoJSON: Point, MultiPoint, GeometryCollection, Feature and FeatureCollection
//   a word   well-known text: POINT and MULTIPOINT (with or without the inner parentheses), GEOMETRYCOLLECTION,
//            any number of them one after the other; case does not matter. EMPTY stands for no point. (But words with
//            commas between them, and no '(' before, are the first line of a csv.)
//   else     csv: one point x,y a line, blanks about a number are allowed, and so is a first line x,y
//
// Members of GeoJSON objects that say nothing of places are passed over; so are third coordinates of GeoJSON and
// well-known text, which are counted. Throws InputError with file and line for anything else: another geometry, a
// number that is none, no point at all. COST: linear.
std::vector<Point2> read_points_2(std::string_view text, const std::string& name_for_messages,
                                  PassedOver* passed_over = nullptr);

}  // namespace hottel
