// View factors as a picture: a plan whose faces are coloured by their factor to some of them.
#pragma once

#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "viewer/picture/cairo_canvas.h"

namespace hottel {

// What the factors go to.
struct PictureTargets2 {
  std::vector<std::uint32_t> surfaces{};
  bool is_sky = false;
  std::string label{};  // for the legend
};

// A surface, a polyline, all whose names begin with NAME*, or "sky". Throws UnknownName when there is none.
PictureTargets2 picture_targets(const Scene2& scene, const std::string& name);

// Returns the bytes of a picture in which each face with a row has the colour of the sum of its factors to the fronts
// of the targets; the targets themselves are marked instead. quantity: what the factors are, for the legend.
//
//   (1) the scale of colours is logarithmic, and goes from 0.001 to the largest sum, 0.002 at least
// REQUIRES a matrix whose elements are faces.
std::string factor_picture_2(const PreparedScene2& prepared, const ExchangeMatrix& matrix,
                             const PictureTargets2& targets, const std::string& quantity, PictureFormat format);

}  // namespace hottel
