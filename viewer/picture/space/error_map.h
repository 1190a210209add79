// Where a method gets the light wrong, as a camera sees the scene.
#pragma once

#include <string>

#include "solver/space/compare/method_comparison.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

// Each element's error of its radiosity, in fractions of the largest radiosity, the largest over the channels; on a
// logarithmic scale of four decades. No values where the method has no radiosities (MethodResult::solution), or where
// there is no light; the title then says so.
ShownValues error_values_3(const MethodComparison3& comparison, const MethodResult& result);

// Returns the bytes of the picture file: what the scene's camera sees, or default_camera_3. Throws as RenderedView3
// does. REQUIRES a comparison with a solution.
std::string error_map_3(const MethodComparison3& comparison, const MethodResult& result, PictureFormat format);

}  // namespace hottel
