// Cases of polygons in space, read from a file like occluded.json.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

struct SpaceCase {
  std::string name;
  std::vector<SpacePolygon> polygons;
  double value = 0;  // of F from polygon 0 to polygon 1
};

// Coordinates are the doubles that the file's numbers are nearest to, or the fractions of its strings.
std::vector<SpaceCase> read_space_cases(const std::string& file);

}  // namespace hottel::oracle
