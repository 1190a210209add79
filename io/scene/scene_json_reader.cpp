#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "io/scene/binary_scene.h"
#include "io/scene/exact_json.h"
#include "io/scene/json_fields.h"
#include "io/scene/plane/map_reader.h"
#include "io/scene/plane/scene_reader.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "io/scene/space/scene_reader.h"
#include "io/scene/space/stl_reader.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr const char* kInThePlaneOnly = "the scene is in space (dimension 3); one in the plane is wanted";
constexpr const char* kInSpaceOnly = "the scene is in the plane (dimension 2); one in space is wanted";

// The value of a member of the scene, one of those allowed.
JsonValue version(const JsonValue& root, std::string_view key, std::initializer_list<const char*> allowed) {
  for (const auto [k, value] : root.members()) {
    if (k.text() != key) continue;
    require_kind(value, JsonKind::kNumber, {key});
    const Rational number = read_number(value, {key});
    std::string known;
    for (const char* a : allowed) {
      if (number == Rational(a)) return value;
      known += (known.empty() ? "" : " and ") + std::string(a);
    }
    refuse(value, std::string(key) + " is " + quoted_name(value.text()) + "; this version reads " + known);
  }
  refuse(root, "the scene has no \"" + std::string(key) + "\"", {"a scene begins { \"hottel\": 1, \"dimension\": 2,"});
}

// Returns the scene of a text. Refuses one of another dimension than `wanted`, if there is one.
ValidScene parse(std::string_view text, const std::string& name, const TextSource& files, std::optional<int> wanted,
                 Triangulator3* triangulator = nullptr, PassedOver* passed_over = nullptr) {
  const JsonDocument document(text, name);
  const JsonValue root = document.root();
  require_kind(root, JsonKind::kObject, {"the scene"});
  version(root, "hottel", {"1"});
  const JsonValue dimension = version(root, "dimension", {"2", "3"});
  if (read_number(dimension, {"dimension"}) == 2) {
    if (wanted == 3) refuse(dimension, kInSpaceOnly);
    return read_document_2(root, name);
  }
  if (wanted == 2) refuse(dimension, kInThePlaneOnly);
  return read_document_3(root, name, files, triangulator, passed_over);
}

// How a file is read, and what is wanted of it.
struct Reading {
  std::optional<int> wanted;  // dimension
  Triangulator3* triangulator = nullptr;
  PassedOver* passed_over = nullptr;
  MapSide2 side = MapSide2::kInside;
};

void require_plane(const Reading& reading, const std::string& name) {
  if (reading.wanted == 3) throw InputError({name, 0}, kInSpaceOnly);
}
void require_space(const Reading& reading, const std::string& name) {
  if (reading.wanted == 2) throw InputError({name, 0}, kInThePlaneOnly);
}

void require_wanted(const ValidScene& scene, const Reading& reading, const std::string& name) {
  std::holds_alternative<ValidScene2>(scene) ? require_plane(reading, name) : require_space(reading, name);
}

// Of a text with numbers that are read, or of bytes with those that were.
ValidScene read_scene_file(std::string_view text, const std::string& name, const Reading& reading) {
  if (!is_binary_scene(text))
    return parse(text, name, read_text_file, reading.wanted, reading.triangulator, reading.passed_over);
  ValidScene scene = parse_binary_scene(text, name);
  require_wanted(scene, reading, name);
  return scene;
}

ValidScene read_by_ending(const std::filesystem::path& file, const Reading& reading) {
  const std::string name = file.string();
  if (is_map_2(file) || is_svg_2(file)) {
    require_plane(reading, name);
    return is_svg_2(file) ? read_svg_2(file, reading.passed_over) : read_map_2(file, reading.side, reading.passed_over);
  }
  if (!is_vs3(file) && !mesh_format_3(file)) return read_scene_file(read_text_file(file), name, reading);
  require_space(reading, name);
  return is_vs3(file) ? read_vs3_3(file, reading.triangulator).scene
                      : read_mesh_scene_3(file, reading.triangulator, reading.passed_over).scene;
}

// Whether the first line that is no comment has a statement of OBJ.
bool begins_as_obj(std::string_view text) {
  while (text.starts_with('#')) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
  constexpr std::array<std::string_view, 9> kWords{"v", "vn", "vt", "f", "o", "g", "s", "mtllib", "usemtl"};
  return std::ranges::find(kWords, word) != kWords.end();
}

// The format of a mesh that begins with a word of its own, or is binary STL. `start`: the text without leading blanks.
std::optional<MeshFormat3> mesh_format_of(std::string_view text, std::string_view start) {
  if (is_binary_stl_3(text) ||
      (start.starts_with("solid") && start.substr(0, 4096).find("facet") != std::string_view::npos))
    return MeshFormat3::kStl;
  if (begins_as_obj(start)) return MeshFormat3::kObj;
  if (start.starts_with("ply")) return MeshFormat3::kPly;
  if (start.substr(0, 8).find("OFF") != std::string_view::npos) return MeshFormat3::kOff;
  return std::nullopt;
}

// What a file is by its beginning, where that is not what its ending says; empty where it is, or is not certain.
std::string other_format_hint(const std::filesystem::path& file, std::string_view text) {
  if (is_vs3(file)) return "";
  const std::string_view start = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto by_ending = mesh_format_3(file);
  if (start.starts_with('{'))
    return by_ending || is_svg_2(file) ? "it begins as JSON does: a scene is called .json, a map .geojson" : "";
  if (start.starts_with("<svg") || start.starts_with("<?xml"))
    return is_svg_2(file) ? "" : "it begins as SVG does: call it .svg";
  const auto format = mesh_format_of(text, start);
  if (!format || format == by_ending || (format == MeshFormat3::kOff && start.starts_with('#'))) return "";
  const auto [name, ending] = *format == MeshFormat3::kObj   ? std::pair("OBJ", ".obj")
                              : *format == MeshFormat3::kPly ? std::pair("PLY", ".ply")
                              : *format == MeshFormat3::kOff ? std::pair("OFF", ".off")
                                                             : std::pair("STL", ".stl");
  return std::string("it begins as ") + name + " does: call it " + ending;
}

// Where the file is refused it is told if it seems to be of another format. A pipe cannot be read again.
ValidScene read(const std::filesystem::path& file, const Reading& reading) {
  try {
    return read_by_ending(file, reading);
  } catch (const MissingFile&) {
    throw;
  } catch (const InputError& error) {
    std::error_code unknown;
    std::vector<std::string> hints = error.hints();
    if (error.where().file != file.string() || hints.size() > 2 || !std::filesystem::is_regular_file(file, unknown))
      throw;
    const std::string hint = other_format_hint(file, read_text_file(file));
    if (hint.empty()) throw;
    hints.push_back(hint);
    throw InputError(error.where(), std::string(error.what()).substr(error.where().text().size() + 2), hints);
  }
}

// Whether an object of JSON is no scene, but has a "type".
bool is_geojson(std::string_view text, const std::string& name) {
  const JsonDocument document(text, name);
  const JsonValue root = document.root();
  if (root.kind() != JsonKind::kObject) return false;
  bool has_type = false, has_version = false;
  for (const auto [key, value] : root.members()) {
    has_type |= key.text() == "type";
    has_version |= key.text() == "hottel";
  }
  return has_type && !has_version;
}

}  // namespace

Scene changeable(ValidScene scene) {
  if (auto* const plane = std::get_if<ValidScene2>(&scene)) return Scene2(std::move(*plane));
  return Scene3(std::get<ValidScene3>(std::move(scene)));
}

ValidScene parse_scene(std::string_view text, const std::string& name_for_messages, const TextSource& files) {
  return parse(text, name_for_messages, files, std::nullopt);
}

ValidScene read_scene(const std::filesystem::path& file, Triangulator3* triangulator, PassedOver* passed_over,
                      MapSide2 side) {
  return read(file, {std::nullopt, triangulator, passed_over, side});
}

ValidScene parse_any_scene(std::string_view text, const std::string& name_for_messages, Triangulator3* triangulator,
                           PassedOver* passed_over, MapSide2 side) {
  if (is_binary_scene(text)) return parse_binary_scene(text, name_for_messages);
  const std::string_view start = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (start.starts_with('<')) return parse_svg_2(text, name_for_messages, passed_over);
  if (const auto format = mesh_format_of(text, start))
    return scene_of(parse_mesh_3(*format, text, name_for_messages), triangulator, passed_over).scene;
  const bool is_word = !start.empty() && std::isalpha(static_cast<unsigned char>(start.front())) != 0;
  if (is_word || (start.starts_with('{') && is_geojson(text, name_for_messages)))
    return parse_map_2(text, name_for_messages, side, passed_over);
  return parse(text, name_for_messages, read_text_file, std::nullopt, triangulator, passed_over);
}

ValidScene2 read_scene_2(const std::filesystem::path& file, PassedOver* passed_over, MapSide2 side) {
  return std::get<ValidScene2>(read(file, {2, nullptr, passed_over, side}));
}

ValidScene2 parse_scene_2(std::string_view text, const std::string& name_for_messages) {
  return std::get<ValidScene2>(parse(text, name_for_messages, read_text_file, 2));
}

ValidScene3 read_scene_3(const std::filesystem::path& file, Triangulator3* triangulator, PassedOver* passed_over) {
  return std::get<ValidScene3>(read(file, {3, triangulator, passed_over}));
}

ValidScene3 parse_scene_3(std::string_view text, const std::string& name_for_messages, const TextSource& files) {
  return std::get<ValidScene3>(parse(text, name_for_messages, files, 3));
}

}  // namespace hottel
