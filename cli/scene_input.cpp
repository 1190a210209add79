#include "cli/scene_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/unknown_name.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {
namespace {

constexpr long kMostExtentsAway = 1'000'000'000;  // from the origin: then a double tells a millionth of a pixel

// What may be named in a scene: the fronts and backs of its surfaces, or its surfaces and groups; and the sky.
std::vector<std::string> names_of(const Scene2& scene, bool of_faces) {
  std::vector<std::string> names;
  for (const Surface2& surface : scene.surfaces) {
    names.push_back(surface.name);
    if (of_faces) names.push_back(surface.name + ":back");
  }
  for (const Group2& group : scene.groups)
    if (!of_faces) names.push_back(group.name);
  names.emplace_back("sky");
  return names;
}

// "window*" for "window3", "room*" for "room[0]".
std::vector<std::string> beginnings(const Scene2& scene) {
  std::vector<std::string> names = names_of(scene, false);
  for (std::string& name : names) {
    name.resize(std::min(name.size(), name.find_last_not_of("0123456789[].") + 1));
    name += '*';
  }
  return names;
}

}  // namespace

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
  if (count)
    for (Surface2& surface : scene.surfaces) surface.elements = *count;
  if (!size) return;
  const auto h = parse_rational(*size);
  if (!h || *h <= 0) throw UsageError("--element-size must be a positive number, not '" + *size + "'");
  for (Surface2& surface : scene.surfaces) {
    const Rational dx = surface.to.x - surface.from.x, dy = surface.to.y - surface.from.y;
    const Rational squared = (dx * dx + dy * dy) / (*h * *h);
    // The least n with n² >= squared.
    Integer whole, n;
    mpz_cdiv_q(whole.get_mpz_t(), squared.get_num_mpz_t(), squared.get_den_mpz_t());
    n = sqrt(whole);
    if (n * n < whole) ++n;
    if (n > kMaxElements)
      throw UsageError("--element-size " + *size + " asks for more than " + std::to_string(kMaxElements) +
                       " elements on '" + surface.name + "'");
    surface.elements = static_cast<std::uint32_t>(n.get_ui());
  }
}

void require_closed(const Scene2& scene, const ExchangeMatrix& matrix) {
  if (!scene.closed) return;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    if (element.is_back || !matrix.has_row(i)) continue;
    const Rounded sky = matrix.factor(i, matrix.sky());
    if (sky.value == 0 && sky.side == 0) continue;
    const Surface2& surface = scene.surfaces[element.surface];
    throw RequestError(
        fmt::format("{}:{}: the scene promises to be closed, but the front of '{}' sees the sky (F = {})", scene.file,
                    surface.line, surface.name, shortest(sky.value)));
  }
}

std::filesystem::path output_folder(const std::string& option, const std::string& scene) {
  if (option == "-") throw UsageError("results are several files: -o takes a folder, not standard output");
  return option.empty() ? std::filesystem::path(scene).stem().string() + "-hottel" : option;
}

void require_drawable(const Scene2& scene) {
  if (scene.surfaces.empty()) return;
  Point2 low = scene.surfaces.front().from, high = low;
  const Surface2* farthest = &scene.surfaces.front();
  Rational largest;
  for (const Surface2& surface : scene.surfaces)
    for (const Point2& p : {surface.from, surface.to}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      const Rational distance = std::max<Rational>(abs(p.x), abs(p.y));
      if (distance <= largest) continue;
      largest = distance;
      farthest = &surface;
    }
  const Rational extent = std::max<Rational>(high.x - low.x, high.y - low.y);
  const char* why = to_double(largest) > kLargestDrawn      ? "larger than 1e300"
                    : to_double(extent) < 1 / kLargestDrawn ? "smaller than 1e-300, all of them"
                    : extent * kMostExtentsAway < largest   ? "too large for the size of the scene"
                                                            : nullptr;
  if (why)
    throw RequestError(
        fmt::format("{}:{}: the coordinates of '{}' are {}: a drawing like this places points by doubles", scene.file,
                    farthest->line, farthest->name, why));
}

Grid2 grid_of(const Scene2& scene, const std::string& option) {
  if (option.empty()) return default_grid(scene);
  const auto x = option.find('x');
  const auto number = [](const std::string& digits) -> std::uint32_t {
    const auto value = parse_rational(digits);
    if (!value || value->get_den() != 1 || *value < 1 || *value > kMaxGridCells) return 0;
    return static_cast<std::uint32_t>(value->get_num().get_ui());
  };
  const std::uint32_t nx = x == std::string::npos ? 0 : number(option.substr(0, x));
  const std::uint32_t ny = x == std::string::npos ? 0 : number(option.substr(x + 1));
  if (nx == 0 || ny == 0)
    throw UsageError(fmt::format("--grid takes NXxNY with numbers from 1 to {}, not '{}'", kMaxGridCells, option));
  return grid_over(scene, nx, ny);
}

std::vector<std::uint32_t> surfaces_matching(const Scene2& scene, const std::string& pattern) {
  const bool is_prefix = !pattern.empty() && pattern.back() == '*';
  const std::string prefix = pattern.substr(0, pattern.size() - (is_prefix ? 1 : 0));
  const auto matches = [&](const std::string& name) { return is_prefix ? name.starts_with(prefix) : name == pattern; };
  std::vector<std::uint32_t> result;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (matches(scene.surfaces[s].name) || matches(scene.groups[scene.surfaces[s].group].name)) result.push_back(s);
  if (result.empty())
    throw UnknownName("no surface of " + scene.file + " is called '" + pattern + "'", pattern,
                      is_prefix ? beginnings(scene) : names_of(scene, false));
  return result;
}

std::uint32_t require_element(const ExchangeMatrix& matrix, const std::string& name) {
  if (const auto found = matrix.find(name)) return *found;
  std::vector<std::string> known;
  for (const Element& element : matrix.elements()) known.push_back(element.name);
  known.emplace_back("sky");
  throw UnknownName("there is no face called '" + name + "'", name, known);
}

Face face_of(const Scene2& scene, const std::string& name) {
  if (const auto surface = scene.find(name)) return {*surface, false};
  if (name.ends_with(":back"))
    if (const auto surface = scene.find(name.substr(0, name.size() - 5))) return {*surface, true};
  throw UnknownName("no face of " + scene.file + " is called '" + name + "'", name, names_of(scene, true));
}

}  // namespace hottel
