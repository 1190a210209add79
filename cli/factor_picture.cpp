#include "cli/factor_picture.h"

#include <algorithm>

#include "cli/scene_input.h"
#include "viewer/picture/plane/scene_picture.h"

namespace hottel {
namespace {

FaceColouring colouring_toward(const Scene2& scene, const ExchangeMatrix& matrix, const PictureTargets& targets) {
  std::vector<char> is_target(scene.surfaces.size(), 0);
  for (const std::uint32_t s : targets.surfaces) is_target[s] = 1;
  const auto counts = [&](std::uint32_t to) {
    if (to == matrix.sky()) return targets.is_sky;
    const Element& element = matrix.elements()[to];
    return is_target[element.surface] != 0 && !element.is_back;
  };
  FaceColouring colouring;
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
  return colouring;
}

}  // namespace

PictureTargets picture_targets(const Scene2& scene, const std::string& toward) {
  if (toward == "sky") return {.is_sky = true, .label = "sky"};
  return {.surfaces = surfaces_matching(scene, toward),
          .label = toward.ends_with("*") ? toward.substr(0, toward.size() - 1) : toward};
}

std::string factor_picture(const PreparedScene2& prepared, const ExchangeMatrix& matrix, const PictureTargets& targets,
                           const std::string& quantity, PictureFormat format) {
  ScenePicture2 picture;
  picture.targets = targets.surfaces;
  picture.target_label = targets.is_sky ? "" : targets.label;
  picture.colouring = colouring_toward(prepared.scene, matrix, targets);
  picture.colouring->title = quantity + " to " + (targets.is_sky ? "the sky" : targets.label);
  return scene_picture_2(prepared, picture, format);
}

}  // namespace hottel
