// What hottel visibility answers, as text and drawn.
#pragma once

#include <functional>
#include <string>

#include "io/results/visibility_answer.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

// What is answered, and a drawing of it on demand: the bytes of a picture file.
struct ShownAnswer {
  VisibilityAnswer answer;
  std::function<std::string(PictureFormat)> draw;
};

}  // namespace hottel
