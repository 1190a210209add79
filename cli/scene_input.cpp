#include "cli/scene_input.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "geometry/plane/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {

void ElementOptions::add_to(CLI::App& command) {
  CLI::Option* element_size =
      command.add_option("--element-size", size, "divide every edge into equal parts no longer than H");
  element_size->type_name("H");
  command.add_option("--elements", count, "divide every edge into N equal parts")
      ->type_name("N")
      ->transform(whole_number(1, kMaxElements))
      ->excludes(element_size);
}

void ElementOptions::apply_to(Scene2& scene) const {
  if (count) divide_into(scene, *count);
  if (!size) return;
  const auto h = parse_rational(*size);
  if (!h || *h <= 0) throw UsageError("--element-size must be a positive number, not '" + *size + "'");
  if (const auto surface = divide_by_length(scene, *h, kMaxElements))
    throw UsageError("--element-size " + *size + " asks for more than " + std::to_string(kMaxElements) +
                     " elements on '" + scene.surfaces[*surface].name + "'");
}

std::filesystem::path output_folder(const std::string& option, const std::string& scene) {
  if (option == "-") throw UsageError("results are several files: -o takes a folder, not standard output");
  return option.empty() ? std::filesystem::path(scene).stem().string() + "-hottel" : option;
}

std::array<std::uint32_t, 2> two_numbers(const std::string& option, const std::string& pattern, const std::string& text,
                                         std::uint32_t most) {
  const auto x = text.find('x');
  const auto number = [most](const std::string& digits) -> std::uint32_t {
    const auto value = parse_rational(digits);
    if (!value || value->get_den() != 1 || *value < 1 || *value > most) return 0;
    return static_cast<std::uint32_t>(value->get_num().get_ui());
  };
  const std::uint32_t first = x == std::string::npos ? 0 : number(text.substr(0, x));
  const std::uint32_t second = x == std::string::npos ? 0 : number(text.substr(x + 1));
  if (first == 0 || second == 0)
    throw UsageError(fmt::format("{} takes {} with numbers from 1 to {}, not '{}'", option, pattern, most, text));
  return {first, second};
}

Grid2 grid_of(const Scene2& scene, const std::string& option) {
  if (option.empty()) return default_grid(scene);
  const auto [nx, ny] = two_numbers("--grid", "NXxNY", option, kMaxGridCells);
  return grid_over(scene, nx, ny);
}

}  // namespace hottel
