// What rows of results are called.
#pragma once

#include "geometry/element.h"

namespace hottel {

// "faces", "elements" or "groups".
inline const char* plural(Granularity granularity) {
  switch (granularity) {
    case Granularity::kFace:
      return "faces";
    case Granularity::kElement:
      return "elements";
    case Granularity::kGroup:
      return "groups";
  }
  return "";
}

}  // namespace hottel
