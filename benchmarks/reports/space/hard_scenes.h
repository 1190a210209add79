// Scenes in space that come near to degeneracy, by a parameter, with one factor of each known to 60 digits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/reports/space/contour_measure.h"
#include "geometry/element.h"
#include "kernel/rational.h"

namespace hottel {

struct HardScene3 {
  std::string name, title, story, closed_form;
  Granularity granularity = Granularity::kFace;
  std::string from, to;                                    // faces or groups; "sky"
  std::function<std::string(const Rational& d)> polygons;  // JSON: the list without brackets, the material is "m"
  std::function<LongReal(const Rational& d)> factor;
  int direction = -1;    // d is 10^-1, 10^-2, ..., 10^-31; or +1: 10, 100, ..., 10^31
  bool has_end = false;  // at d = 0 it is a scene too, and the factor is 0
};

inline constexpr int kHardDecades = 31;

// The scenes; 10^(direction k) for 1 <= k <= kHardDecades.
const std::vector<HardScene3>& hard_scenes_3();
Rational hard_parameter(const HardScene3& scene, int k);
std::string hard_scene_json(const HardScene3& scene, const Rational& d);

// |value - F| / F and |value - F|.
struct HardErrors {
  double relative = 0, absolute = 0;
};
HardErrors hard_errors(double value, const LongReal& factor);

}  // namespace hottel
