#include "solver/method_catalogue.h"

#include <fmt/format.h>

#include "geometry/near_names.h"
#include "solver/normalised_method.h"

namespace hottel {

std::string family_of_method(const std::string& name) { return name.substr(0, name.find(':')); }

SplitMethodName split_method_name(const std::string& name) {
  const std::string_view normalised = name.ends_with(kNormalised) ? kNormalised : "";
  return {name.substr(0, name.size() - normalised.size()), std::string(normalised)};
}

void refuse_method(const std::string& name, const std::string& where, const std::vector<std::string>& families,
                   const std::vector<std::string>& patterns) {
  throw UnknownName(
      fmt::format("there is no method called '{}' {}; there are {}", name, where, fmt::join(patterns, ", ")),
      family_of_method(name), families);
}

}  // namespace hottel
