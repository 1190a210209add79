// A point of space as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "geometry/space/point.h"

namespace hottel {

// {"x", "y", "z"}: the nearest doubles; "exact": the three as they are.
nlohmann::ordered_json exact_point(const Point3& p);

}  // namespace hottel
