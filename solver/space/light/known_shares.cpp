#include "solver/space/light/known_shares.h"

#include <cstddef>
#include <utility>

#include "solver/space/light/tested_shares.h"

namespace hottel {
namespace {

const LightShares* known_of(const KnownShares3& known, const Light& light, const LightPlace3& place) {
  if (known.shares == nullptr) return nullptr;
  for (std::size_t k = 0; k < known.lights.size(); ++k)
    if (is_lit_alike_3(known.lights[k], known.places[k], light, place)) return &(*known.shares)[k];
  return nullptr;
}

}  // namespace

bool is_lit_alike_3(const Light& a, const LightPlace3& at, const Light& b, const LightPlace3& there) {
  if (a.type != b.type || at.position != there.position) return false;
  return a.type == LightType::kPoint ||
         (a.focus == b.focus && a.falloff == b.falloff && at.direction == there.direction);
}

std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity, LightTest test,
                                      const KnownShares3& known) {
  const Scene3& scene = prepared.scene;
  std::vector<const LightShares*> found;
  PreparedScene3 rest = prepared;
  rest.scene.lights.clear();
  rest.scene.light_places.clear();
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    found.push_back(known_of(known, scene.lights[k], scene.light_places[k]));
    if (found.back() == nullptr) rest.scene.add_light(scene.lights[k], scene.light_places[k]);
  }
  std::vector<LightShares> made = light_shares(rest, granularity, test), result;
  for (std::size_t k = 0, next = 0; k < found.size(); ++k)
    result.push_back(found[k] != nullptr ? *found[k] : std::move(made[next++]));
  return result;
}

}  // namespace hottel
