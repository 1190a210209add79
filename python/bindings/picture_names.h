// How light becomes a picture, by names.
#pragma once

#include <string>

#include "viewer/picture/picture_options.h"
#include "viewer/picture/shading.h"

namespace hottel::python {

// Each throws UsageError for what is none.
Tone tone_named(const std::string& name);
Shading shading_named(const std::string& name);
void require_exposure(double exposure);

}  // namespace hottel::python
