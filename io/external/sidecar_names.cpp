#include "io/external/sidecar_names.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/files/text_file.h"

namespace hottel {

std::vector<std::string> sidecar_names(const std::string& sidecar) {
  std::error_code ignored;
  if (!std::filesystem::exists(sidecar, ignored)) return {};
  const auto json = nlohmann::json::parse(read_text_file(sidecar), nullptr, false);
  if (!json.is_object()) return {};
  const auto found = json.find("names");
  if (found == json.end() || !found->is_array()) return {};
  std::vector<std::string> names;
  for (const auto& name : *found) {
    if (!name.is_string()) return {};
    names.push_back(name.get<std::string>());
  }
  return names;
}

}  // namespace hottel
