#include "io/results/space/exact_point.h"

#include <nlohmann/json.hpp>

#include "kernel/rational.h"

namespace hottel {

nlohmann::ordered_json exact_point(const Point3& p) {
  return {{"x", to_double(p.x)},
          {"y", to_double(p.y)},
          {"z", to_double(p.z)},
          {"exact", {to_string(p.x), to_string(p.y), to_string(p.z)}}};
}

}  // namespace hottel
