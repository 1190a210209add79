// visibility --points of points in the plane without normals: the polygon that each sees.
#pragma once

#include <string>
#include <vector>

#include "cli/streams.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/external/plane/point_list.h"
#include "io/results/plane/polygon_files.h"

namespace hottel {

class Simulation2;

// A list of points as it was given, where what they see goes, and what of it.
struct SeenRequest2 {
  std::string text, name;    // what messages call it
  std::string out;           // .csv, .geojson, .wkt or .npz; empty or "-": standard output, csv
  std::string range;         // nothing beyond; empty: of any distance
  bool is_exact = false;     // coordinates as p/q
  bool has_light = false;    // the mean irradiance at each point
  bool fronts_only = false;  // a point on an outline sees what its front sees
};

// The same, once it is found to make sense.
struct PolygonRequest2 {
  std::vector<Point2> points{};
  PolygonFormat2 format = PolygonFormat2::kCsv;
  PolygonsOptions2 wanted{};
  std::string out{};
  bool has_light = false;
  PassedOver passed_over{};  // of the list
};

// Throws UsageError for other endings, and for what a format has no place for; InputError for what is no list of points
// in the plane.
PolygonRequest2 polygon_request(const SeenRequest2& asked);

// Writes what each point sees, a note of points in solids and of those that see the sky. RequestErrors name the scene's
// file. COST: parallel over points, of which memory holds a thousand at a time; with light one solution.
void write_polygons(const PolygonRequest2& request, const Simulation2& simulation, Streams& streams);

}  // namespace hottel
