// What rows of results are called.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/element.h"
#include "kernel/support/counted.h"

namespace hottel {

// "1 face", "7 elements" or "2 groups".
inline std::string counted(std::uint64_t count, Granularity granularity) {
  switch (granularity) {
    case Granularity::kFace:
      return counted(count, "face");
    case Granularity::kElement:
      return counted(count, "element");
    case Granularity::kGroup:
      return counted(count, "group");
  }
  return "";
}

}  // namespace hottel
