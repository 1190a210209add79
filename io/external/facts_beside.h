// What FILE.json says of the array beside it, as hottel writes both.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace hottel {

// A corner and the sides from there: origin, u, v [unit of the scene].
using RegionFacts3 = std::array<std::array<double, 3>, 3>;

// Returns the name of that file.
std::string name_beside(const std::filesystem::path& file);

// Returns what is in that file; nothing without one, and a discarded value where it is no JSON.
std::optional<nlohmann::json> facts_beside(const std::filesystem::path& file);

// Return a member of it; nothing where it is missing or of another type.
std::optional<std::string> text_in(const nlohmann::json& facts, const char* key);
std::optional<RegionFacts3> region_in_space(const nlohmann::json& facts);

}  // namespace hottel
