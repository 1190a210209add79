#include "io/external/external_method.h"

namespace hottel {

bool is_external(const std::string& method) {
  const std::string family = family_of_method(method);
  return family == "file" || family == "run";
}

std::string after_colon(std::string_view variant, const char* what) {
  if (variant.size() < 2) throw UsageError(what);
  return std::string(variant.substr(1));
}

}  // namespace hottel
