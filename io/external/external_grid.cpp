#include "io/external/external_grid.h"

#include <nlohmann/json.hpp>

#include "io/external/numpy_array.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::optional<std::array<std::array<double, 2>, 2>> region_in_plane(const nlohmann::json& json) {
  if (!json.contains("region") || !json["region"].is_object()) return std::nullopt;
  std::array<std::array<double, 2>, 2> region{};
  const std::array<const char*, 2> corners = {"min", "max"};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto corner = json["region"].find(corners[c]);
    if (corner == json["region"].end() || !corner->is_array() || corner->size() != 2) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!(*corner)[k].is_number()) return std::nullopt;
      region[c][k] = (*corner)[k].get<double>();
    }
  }
  return region;
}

void require_light_at_centres(const nlohmann::json& facts, const std::string& beside) {
  const std::string quantity = text_in(facts, "quantity").value_or("mean irradiance"),
                    way = text_in(facts, "illumination").value_or("point");
  if (quantity == "mean irradiance" && way == "point") return;
  throw InputError({beside, 0},
                   "says that the numbers are '" + quantity + "'" + (way == "point" ? "" : " by '" + way + "'") +
                       ", and what is compared is the mean irradiance at the centres of cells",
                   {"hottel solve writes that with --illumination point, as it does without it"});
}

}  // namespace

ExternalGrid read_external_cells(const std::filesystem::path& file) {
  const std::string name = file.string(), text = read_text_file(file);
  if (!text.starts_with("\x93NUMPY")) throw InputError({name, 0}, "is no array of NumPy (.npy)");
  const NumpyArray array = parse_numpy(name, text, 3);
  ExternalGrid grid{
      name, array.shape[0], array.shape[1], array.shape.size() == 3 ? array.shape[2] : 1, {}, {}, false, {}, {}};
  grid.has_channels = array.shape.size() == 3;
  grid.digits.relative = array.relative_rounding();
  grid.values.resize(array.count());
  std::size_t k = 0;
  for (std::uint64_t y = 0; y < grid.ny; ++y)
    for (std::uint64_t x = 0; x < grid.nx; ++x)
      for (std::uint64_t c = 0; c < grid.channels; ++c, ++k)
        grid.values[k] = array.number(array.is_by_columns ? y + grid.ny * (x + grid.nx * c) : k);
  return grid;
}

ExternalGrid read_external_grid(const std::filesystem::path& file) {
  ExternalGrid grid = read_external_cells(file);
  const std::optional<nlohmann::json> facts = facts_beside(file);
  if (!facts || !facts->is_object()) return grid;
  require_light_at_centres(*facts, name_beside(file));
  grid.region = region_in_plane(*facts);
  grid.region_in_space = region_in_space(*facts);
  return grid;
}

}  // namespace hottel
