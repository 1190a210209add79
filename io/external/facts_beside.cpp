#include "io/external/facts_beside.h"

#include <nlohmann/json.hpp>
#include <system_error>

#include "io/files/text_file.h"

namespace hottel {

std::string name_beside(const std::filesystem::path& file) { return file.string() + ".json"; }

std::optional<nlohmann::json> facts_beside(const std::filesystem::path& file) {
  const std::string beside = name_beside(file);
  std::error_code ignored;
  if (!std::filesystem::exists(beside, ignored)) return std::nullopt;
  return nlohmann::json::parse(read_text_file(beside), nullptr, false);
}

std::optional<std::string> text_in(const nlohmann::json& facts, const char* key) {
  const auto found = facts.find(key);
  return found != facts.end() && found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

std::optional<RegionFacts3> region_in_space(const nlohmann::json& facts) {
  const auto found = facts.find("region");
  if (found == facts.end() || !found->is_object()) return std::nullopt;
  RegionFacts3 region{};
  const std::array<const char*, 3> keys = {"origin", "u", "v"};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto way = found->find(keys[k]);
    if (way == found->end() || !way->is_array() || way->size() != 3) return std::nullopt;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(*way)[c].is_number()) return std::nullopt;
      region[k][c] = (*way)[c].get<double>();
    }
  }
  return region;
}

}  // namespace hottel
