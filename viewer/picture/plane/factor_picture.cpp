#include "viewer/picture/plane/factor_picture.h"

#include <algorithm>

#include "geometry/scene_names.h"
#include "viewer/picture/plane/scene_picture.h"

namespace hottel {
namespace {

FaceColouring2 colouring_toward(const Scene2& scene, const ExchangeMatrix& matrix, const PictureTargets2& targets) {
  std::vector<char> is_target(scene.surfaces.size(), 0);
  for (const std::uint32_t s : targets.surfaces) is_target[s] = 1;
  const auto counts = [&](std::uint32_t to) {
    if (to == matrix.sky()) return targets.is_sky;
    const Element& element = matrix.elements()[to];
    return is_target[element.surface] != 0 && !element.is_back;
  };
  FaceColouring2 colouring;
  colouring.front.resize(is_target.size());
  colouring.back.resize(is_target.size());
  double largest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& from = matrix.elements()[i];
    if (!matrix.has_row(i) || is_target[from.surface]) continue;
    double fraction = 0;
    for (const FactorEntry& entry : matrix.row(i))
      if (counts(entry.to)) fraction += entry.factor.value;
    (from.is_back ? colouring.back : colouring.front)[from.surface] = fraction;
    largest = std::max(largest, fraction);
  }
  colouring.scale = {1e-3, std::max(largest, 2e-3), true};
  for (const auto* side : {&colouring.front, &colouring.back})
    colouring.scale.has_zero = colouring.scale.has_zero || std::ranges::find(*side, std::optional(0.0)) != side->end();
  return colouring;
}

}  // namespace

PictureTargets2 picture_targets(const Scene2& scene, const std::string& name) {
  if (name == "sky") return {.is_sky = true, .label = "sky"};
  return {.surfaces = surfaces_matching(scene, name),
          .label = name.ends_with("*") ? name.substr(0, name.size() - 1) : name};
}

std::string factor_picture_2(const PreparedScene2& prepared, const ExchangeMatrix& matrix,
                             const PictureTargets2& targets, const std::string& quantity, PictureFormat format) {
  ScenePicture2 picture;
  picture.targets = targets.surfaces;
  picture.target_label = targets.is_sky ? "" : targets.label;
  picture.colouring = colouring_toward(prepared.scene, matrix, targets);
  picture.colouring->title = quantity + " to " + (targets.is_sky ? "the sky" : targets.label);
  return scene_picture_2(prepared, picture, format);
}

}  // namespace hottel
