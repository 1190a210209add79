#include "io/scene/passed_over.h"

#include "kernel/support/counted.h"

namespace hottel {

std::string PassedOver::note() const {
  std::string text;
  if (repeated_points > 0) text = counted(repeated_points, "repeated point");
  if (empty_geometries > 0)
    text += (text.empty() ? "" : " and ") + std::to_string(empty_geometries) +
            (empty_geometries == 1 ? " empty geometry" : " empty geometries");
  return text.empty() ? text : text + " passed over";
}

}  // namespace hottel
