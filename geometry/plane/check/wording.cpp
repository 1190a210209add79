#include "geometry/plane/check/wording.h"

#include "kernel/decimal.h"

namespace hottel {
std::string place_text(const Point2& point) { return "(" + short_text(point.x) + ", " + short_text(point.y) + ")"; }

}  // namespace hottel
