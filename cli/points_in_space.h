// visibility --points of points in space without normals: how large each sees which faces.
#pragma once

#include <string>
#include <vector>

#include "cli/streams.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Writes a csv `point,x,y,z,face,fraction,solid_angle` to `out` (empty or "-": standard output): for each point a line
// for each face that it sees, in the order of faces, and one for the sky; the fraction is of all directions, the angle
// in steradians. What is seen is exact, the numbers are doubles. A point in a solid has no line, and one on the border
// of solids has none for the directions into these. A note says how many points are in solids. Where it `proves`,
// `lower,upper` follow the fraction: its proven bounds (PointBounds3). Throws UsageError where the file is no csv.
// COST: that of a map a point; of an exact one where it proves.
void write_seen_faces(const std::vector<Point3>& points, const Scene3& scene, const std::string& out, bool proves,
                      Streams& streams);

}  // namespace hottel
