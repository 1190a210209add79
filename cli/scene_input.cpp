#include "cli/scene_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/command.h"
#include "geometry/plane/scene/division.h"
#include "geometry/space/scene/division.h"
#include "io/files/text_file.h"
#include "io/scene/plane/map_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/trimmed.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {

void PolygonOptions::add_to(CLI::App& command) {
  command.add_flag("--triangulate", triangulates,
                   "in space: read polygons that are not plane as triangles NAME[k], each a surface");
  add_front_to(command);
}

void PolygonOptions::add_front_to(CLI::App& command) {
  command
      .add_option("--front", front,
                  "of the polygons of a map: inside, they are rooms with solid holes; outside, solid with courtyards")
      ->check(CLI::IsMember({"inside", "outside"}))
      ->capture_default_str();
}

void PolygonOptions::require_sense_for(const std::string& file) const {
  if (front != "inside" && !is_map_2(file) && file != kStandardInput)
    throw UsageError("--front is for the polygons of a map (.geojson, .wkt)");
}

void note_passed_over(const PassedOver& passed_over, const Streams& streams) {
  if (const std::string note = passed_over.note(); !note.empty()) streams.note(note);
}

void note_cuts(const Triangulator3& triangulator, const Streams& streams) {
  if (const std::string note = triangulator.note(); !note.empty()) streams.note(note);
}

namespace {

void note_unused(const DeckOutput3& output, const Streams& streams) {
  std::string names;
  for (const auto& [name, is_set] : {std::pair{"row", output.row.has_value()},
                                     {"col", output.column.has_value()},
                                     {"out", output.out.has_value()},
                                     {"list", output.list != 0},
                                     {"emit", output.wants_script_f}})
    if (is_set) names += (names.empty() ? "" : ", ") + std::string(name);
  if (!names.empty()) streams.note(names + ": obeyed by `hottel factors` only");
}

}  // namespace

namespace {

// The same, but prints nothing of how it was read.
ValidScene read_any(const std::string& file, Triangulator3* triangulator, PassedOver& passed_over, MapSide2 side) {
  return file == kStandardInput
             ? parse_any_scene(read_standard_input(), kStandardInputName, triangulator, &passed_over, side)
             : read_scene(file, triangulator, &passed_over, side);
}

}  // namespace

ValidScene read_scene_noting(const std::string& file, const PolygonOptions& options, const Streams& streams,
                             DeckOutput3* output) {
  options.require_sense_for(file);
  Triangulator3 triangulator;
  Triangulator3* const used = options.triangulates ? &triangulator : nullptr;
  const auto tell_cuts = [&] { note_cuts(triangulator, streams); };
  if (is_vs3(file)) {
    Vs3Scene3 deck = read_vs3_3(file, used);
    for (const std::string& note : deck.notes) streams.note(note);
    if (output != nullptr)
      *output = deck.output;
    else
      note_unused(deck.output, streams);
    tell_cuts();
    return std::move(deck.scene);
  }
  PassedOver passed_over;
  ValidScene scene = read_any(file, used, passed_over, options.side());
  note_passed_over(passed_over, streams);
  if (options.triangulates && std::holds_alternative<ValidScene2>(scene))
    throw UsageError("--triangulate cuts polygons in space; " + file + " is in the plane");
  tell_cuts();
  return scene;
}

void ElementOptions::add_to(CLI::App& command) {
  CLI::Option* element_size = command.add_option(
      "--element-size", size, "divide every edge, or side of a polygon, into equal parts no longer than H");
  element_size->type_name("H");
  command.add_option("--elements", count, "divide every edge, or side of a polygon, into N equal parts")
      ->type_name("N")
      ->transform(whole_number(1, kMaxElements))
      ->excludes(element_size);
}

namespace {

const Scene2& plain(const Scene2& scene) { return scene; }
const Scene3& plain(const Scene3& scene) { return scene; }
const Scene2& plain(const ValidScene2& scene) { return *scene; }
const Scene3& plain(const ValidScene3& scene) { return *scene; }

template <class AnyScene>
void divide(AnyScene& scene, const ElementOptions& options) {
  if (options.count) divide_into(scene, *options.count);
  if (!options.size) return;
  const auto h = parse_rational(*options.size);
  if (!h || *h <= 0) throw UsageError("--element-size must be a positive number, not '" + *options.size + "'");
  if (const auto surface = divide_by_length(scene, *h, kMaxElements))
    throw UsageError("--element-size " + *options.size + " asks for more than " + std::to_string(kMaxElements) +
                     " elements on '" + plain(scene).surfaces[*surface].name + "'");
}

}  // namespace

void ElementOptions::apply_to(Scene2& scene) const { divide(scene, *this); }
void ElementOptions::apply_to(Scene3& scene) const { divide(scene, *this); }
void ElementOptions::apply_to(ValidScene2& scene) const { divide(scene, *this); }
void ElementOptions::apply_to(ValidScene3& scene) const { divide(scene, *this); }

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code missing;
  return std::filesystem::equivalent(a, b, missing) && !missing;
}

void require_not_read(const std::string& output, const std::filesystem::path& written, const std::string& reader,
                      const std::filesystem::path& read) {
  if (is_same_file(written, read))
    throw UsageError(output + " is a file that " + reader + " reads: give the output another name");
}

std::filesystem::path output_folder(const std::string& option, const std::string& scene) {
  if (option == "-") throw UsageError("results are several files: -o takes a folder, not standard output");
  if (!option.empty()) return option;
  return scene == kStandardInput ? "stdin-hottel" : std::filesystem::path(scene).stem().string() + "-hottel";
}

Rational number_of(const std::string& text, const std::string& option) {
  const auto value = parse_rational(text);
  if (!value) throw UsageError(option + " takes numbers such as 0.25 or 1/3, not '" + text + "'");
  return *value;
}

double tolerance_of(const std::optional<std::string>& option, double usual) {
  if (!option) return usual;
  const Rational exact = number_of(*option, "--tolerance");
  if (exact <= 0) throw UsageError("--tolerance must be a positive number, not '" + *option + "'");
  const double tolerance = to_double(exact);
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw UsageError("--tolerance is beyond the range of doubles: '" + *option + "'");
  return tolerance;
}

std::vector<std::string> parts_at_commas(const std::string& text) {
  const auto between = [&text](std::size_t begin, std::size_t end) {
    return std::string(trimmed(std::string_view(text).substr(begin, end - begin), " \t"));
  };
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(','); end != std::string::npos; end = text.find(',', begin)) {
    parts.push_back(between(begin, end));
    begin = end + 1;
  }
  parts.push_back(between(begin, text.size()));
  return parts;
}

namespace {

// The number that a text is; 0 for anything but whole ones from 1 to `most`.
std::uint32_t count_of(const std::string& digits, std::uint32_t most) {
  const auto value = parse_rational(digits);
  if (!value || value->get_den() != 1 || *value < 1 || *value > most) return 0;
  return static_cast<std::uint32_t>(value->get_num().get_ui());
}

// So many numbers with an x between two of them.
template <std::size_t kCount>
std::array<std::uint32_t, kCount> numbers_of(const std::string& option, const std::string& pattern,
                                             const std::string& text, std::uint32_t most) {
  std::array<std::uint32_t, kCount> numbers{};
  std::size_t begin = 0;
  for (std::size_t k = 0; k < kCount && begin <= text.size(); ++k) {
    const std::size_t end = k + 1 == kCount ? text.size() : std::min(text.find('x', begin), text.size());
    numbers[k] = count_of(text.substr(begin, end - begin), most);
    begin = end + 1;
  }
  if (std::ranges::find(numbers, 0U) == numbers.end()) return numbers;
  throw UsageError(fmt::format("{} takes {} with numbers from 1 to {}, not '{}'", option, pattern, most, text));
}

}  // namespace

std::array<std::uint32_t, 2> two_numbers(const std::string& option, const std::string& pattern, const std::string& text,
                                         std::uint32_t most) {
  return numbers_of<2>(option, pattern, text, most);
}

TexelOption texel_option(const std::string& text) {
  const auto end = text.rfind('=');
  if (end == std::string::npos)
    throw UsageError("--texels takes NAME=NXxNY, a face and how many it has, not '" + text + "'");
  const auto [nu, nv] = two_numbers("--texels", "NAME=NXxNY", text.substr(end + 1), kMaxGridCells3);
  return {text.substr(0, end), nu, nv};
}

std::vector<Grid2> grids_of(const Scene2& scene, const std::string& option) {
  std::vector<Grid2> grids = scene.grids;
  if (option.empty()) return grids.empty() ? std::vector{default_grid(scene)} : grids;
  const auto [nx, ny] = two_numbers("--grid", "NXxNY", option, kMaxGridCells);
  if (grids.empty()) return {grid_over(scene, nx, ny)};
  for (Grid2& grid : grids) {
    grid.nx = nx;
    grid.ny = ny;
  }
  return grids;
}

namespace {

void divide_planar_grids(std::vector<Grid3>& grids, const std::string& option) {
  const auto [nu, nv] = two_numbers("--grid", "NXxNY", option, kMaxGridCells3);
  for (Grid3& grid : grids) {
    if (grid.is_volume()) continue;
    grid.nu = nu;
    grid.nv = nv;
  }
}

void divide_volumes(std::vector<Grid3>& grids, const std::string& option) {
  const auto [nu, nv, nw] = numbers_of<3>("--grid", "NXxNYxNZ", option, kMaxGridCells3);
  for (Grid3& grid : grids) {
    if (!grid.is_volume()) continue;
    grid.nu = nu;
    grid.nv = nv;
    grid.nw = nw;
  }
}

}  // namespace

std::vector<Grid3> grids_of(const Scene3& scene, const std::string& option) {
  std::vector<Grid3> grids = scene.grids;
  if (option.empty()) return grids;
  if (grids.empty())
    throw UsageError(
        "--grid divides the grid of a scene in space, and this scene has none: add \"grid\": {\"origin\": [x, y, z], "
        "\"u\": [x, y, z], \"v\": [x, y, z], \"cells\": [N, N]} to it, which says where light is wanted");
  const bool is_of_volumes = std::ranges::count(option, 'x') == 2;
  if (std::ranges::none_of(grids, [&](const Grid3& grid) { return grid.is_volume() == is_of_volumes; }))
    throw UsageError(
        is_of_volumes
            ? "--grid NXxNYxNZ divides volumes, and the scene has planar grids alone"
            : "--grid NXxNY divides planar grids, and the scene has volumes alone, which --grid NXxNYxNZ divides");
  is_of_volumes ? divide_volumes(grids, option) : divide_planar_grids(grids, option);
  return grids;
}

std::string cells_text(const Grid2& grid) { return fmt::format("{} x {}", grid.nx, grid.ny); }

std::string cells_text(const Grid3& grid) {
  const std::string planar = fmt::format("{} x {}", grid.nu, grid.nv);
  return grid.is_volume() ? fmt::format("{} x {}", planar, grid.nw) : planar;
}

}  // namespace hottel
