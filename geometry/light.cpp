#include "geometry/light.h"

#include "geometry/name.h"

namespace hottel {

std::string light_problem(const Light& light) {
  if (const auto problem = name_problem(light.name); !problem.empty()) return "has a name that " + std::string(problem);
  if (light.focus <= 0 || light.focus > 180) return "focus must be greater than 0 and at most 180 degrees";
  if (light.falloff < 0) return "falloff must not be below 0";
  if (light.falloff > kMaxFalloff) return "falloff must not be above " + std::to_string(kMaxFalloff);
  if (light.type == LightType::kPoint && !light.is_round()) return "is a point light: it has no focus and no falloff";
  if (light.is_sun() && (light.falloff != 0 || light.focus != 180)) return "is a sun: it has no focus and no falloff";
  if (const auto problem = spectrum_problem(light.power, SpectrumKind::kQuantity); !problem.empty())
    return (light.is_sun() ? "irradiance " : "power ") + std::string(problem);
  return "";
}

}  // namespace hottel
