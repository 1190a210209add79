#include "python/bindings/picture_names.h"

#include <cmath>
#include <vector>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"

namespace hottel::python {

Tone tone_named(const std::optional<std::string>& name, bool is_plane) {
  if (!name) return is_plane ? kUsualTone2 : kUsualTone3;
  const auto tone = tone_of(*name);
  if (!tone)
    throw UnknownName("tone is one of 'linear', 'reinhard', 'log', 'max', not '" + *name + "'", *name,
                      std::vector<std::string>{"linear", "reinhard", "log", "max"});
  return *tone;
}

Shading shading_named(const std::string& name) {
  const auto shading = shading_of(name);
  if (!shading)
    throw UnknownName("shading is one of 'flat', 'smooth', 'parents', 'gathered', not '" + name + "'", name,
                      std::vector<std::string>{"flat", "smooth", "parents", "gathered"});
  return *shading;
}

void require_exposure(double exposure) {
  if (!(exposure > 0 && std::isfinite(exposure))) throw UsageError("exposure is a positive number");
}

}  // namespace hottel::python
