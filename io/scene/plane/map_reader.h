// Maps as scenes: polygons and lines of GeoJSON and of well-known text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/plane/scene/scene.h"
#include "io/scene/passed_over.h"
#include "io/scene/plane/map_defaults.h"

namespace hottel {

// Whether a file name ends as that of a map: .geojson or .wkt.
bool is_map_2(const std::filesystem::path& file);

// Returns the scene of a map. GeoJSON: Polygon, MultiPolygon, LineString, MultiLineString, GeometryCollection, Feature,
// FeatureCollection; well-known text, with or without an SRID: the same geometries in capitals, TRIANGLE as a POLYGON
// and LINEARRING as a line that closes, any number of them, blanks or ';' between.
//
//   (1) every ring and every line is a polyline, in the order of the file; coordinates have exactly the values typed
//   (2) a polygon is a place to be in: its outline looks inward, and its holes, which are solid, look outward, into it.
//       With MapSide2::kOutside, or the property "front": "outside" of a feature, it is a building: the other way
//       round, solid but for its courtyards. The sense in which rings are listed does not matter
//   (3) the front of a line is its right side; its back is black, or the property "back" of a feature
//   (4) the property "material" names the material, "back" that of the back, "elements" divides every piece
//   (5) names are the property "name", a text or a number, or else the "id" of a feature; else polyline[k], k from 0
//       among all polylines. Of several polylines of one name the second is NAME~2, and so on. Other properties and
//       members are passed over
//   (6) rings that are not closed, have fewer than three corners or no area or cross themselves, and curves are refused
//   (7) points that repeat the one before, geometries that are null or empty, points, lines whose points are all the
//       same, third coordinates and measures are counted and passed over; where there is nothing else the first is
//       refused
// Throws InputError with file and line.                                                              COST: linear.
ValidScene2 read_map_2(const std::filesystem::path& file, MapSide2 side = MapSide2::kInside,
                       PassedOver* passed_over = nullptr);

// The same for a text in memory: GeoJSON where it begins with '{'.
ValidScene2 parse_map_2(std::string_view text, const std::string& name_for_messages, MapSide2 side = MapSide2::kInside,
                        PassedOver* passed_over = nullptr);

}  // namespace hottel
