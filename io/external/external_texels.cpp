#include "io/external/external_texels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Json = nlohmann::json;

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
  const std::string beside = name_beside(file);
  const std::optional<Json> json = facts_beside(file);
  if (!json) return texels;
  if (!json->is_object()) throw InputError({beside, 0}, "is no JSON object that says what the texels are");
  require_shape(*json, texels.values, beside);
  texels.facts = {beside, text_in(*json, "face"), text_in(*json, "quantity"), region_in_space(*json)};
  return texels;
}

}  // namespace hottel
