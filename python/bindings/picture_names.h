// How light becomes a picture, by names.
#pragma once

#include <optional>
#include <string>

#include "viewer/picture/picture_options.h"
#include "viewer/picture/shading.h"

namespace hottel::python {

// Each throws UsageError for what is none. Of no tone: the usual one.
Tone tone_named(const std::optional<std::string>& name, bool is_plane);
Shading shading_named(const std::string& name);
void require_exposure(double exposure);

}  // namespace hottel::python
