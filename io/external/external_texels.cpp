#include "io/external/external_texels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/files/text_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Json = nlohmann::json;

std::optional<std::string> text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

std::optional<std::array<std::array<double, 3>, 3>> region_of(const Json& json) {
  const auto found = json.find("region");
  if (found == json.end() || !found->is_object()) return std::nullopt;
  std::array<std::array<double, 3>, 3> region{};
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

void require_shape(const Json& json, const ExternalGrid& grid, const std::string& beside) {
  if (!json.contains("shape")) return;
  std::vector<std::uint32_t> shape{grid.ny, grid.nx};
  if (grid.has_channels) shape.push_back(grid.channels);
  if (json["shape"] != Json(shape))
    throw InputError({beside, 0}, fmt::format("says that the shape is {}, and that of the array is [{}]",
                                              json["shape"].dump(), fmt::join(shape, ",")));
}

}  // namespace

ExternalTexels read_external_texels(const std::filesystem::path& file) {
  ExternalTexels texels{read_external_cells(file), {}};
  const std::string beside = file.string() + ".json";
  std::error_code ignored;
  if (!std::filesystem::exists(beside, ignored)) return texels;
  const Json json = Json::parse(read_text_file(beside), nullptr, false);
  if (!json.is_object()) throw InputError({beside, 0}, "is no JSON object that says what the texels are");
  require_shape(json, texels.values, beside);
  texels.facts = {beside, text_of(json, "face"), text_of(json, "quantity"), region_of(json)};
  return texels;
}

}  // namespace hottel
