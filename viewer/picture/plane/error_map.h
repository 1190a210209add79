// Where a method gets the light wrong, on the plan of the scene.
#pragma once

#include <string>

#include "solver/plane/compare/method_comparison.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/plane/scene_picture.h"

namespace hottel {

// Each face coloured by the largest error of the radiosity of its elements, the floor by the error of the mean
// irradiance there, both in fractions of the largest radiosity, on one logarithmic scale of at most four decades.
//
//   (1) the light of both is made of the same rows of what is seen: what differs is the radiosities alone
//   (2) the largest over the channels counts
// A method without radiosities (see MethodResult::solution), or a scene without any, gives the plan and says so.
ScenePicture2 error_map_picture_2(const MethodComparison2& comparison, const MethodResult& result);

// Returns the bytes of the picture file.
std::string error_map_2(const MethodComparison2& comparison, const MethodResult& result, PictureFormat format);

}  // namespace hottel
