// What points and faces of a scene in the plane see.
#pragma once

#include "geometry/plane/visibility/critical_points.h"     // critical_points
#include "geometry/plane/visibility/point_place.h"         // place_of
#include "geometry/plane/visibility/polygons_of_points.h"  // visibility_polygons
