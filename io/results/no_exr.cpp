// In place of exr.cpp where hottel is built without OpenEXR.
#include "io/results/exr.h"
#include "kernel/support/failure.h"

namespace hottel {

void require_exr(std::string_view what) {
  throw UsageError(std::string(what) + " needs OpenEXR, which this hottel was built without (-DHOTTEL_EXR=OFF)");
}

std::string exr_file(const ExrPicture&) {
  require_exr("an .exr file");
  return "";
}

}  // namespace hottel
