#include "io/scene/space/mesh_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/scene/space/obj_reader.h"
#include "io/scene/space/off_reader.h"
#include "io/scene/space/ply_reader.h"
#include "io/scene/space/stl_reader.h"
#include "kernel/support/failure.h"

namespace hottel {

std::optional<MeshFormat3> mesh_format_3(const std::filesystem::path& file) {
  constexpr std::array<std::pair<const char*, MeshFormat3>, 4> kAll{{{".obj", MeshFormat3::kObj},
                                                                     {".ply", MeshFormat3::kPly},
                                                                     {".off", MeshFormat3::kOff},
                                                                     {".stl", MeshFormat3::kStl}}};
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [known, format] : kAll)
    if (ending == known) return format;
  return std::nullopt;
}

Mesh3 parse_mesh_3(MeshFormat3 format, std::string_view bytes, const std::string& file, const TextSource& files) {
  switch (format) {
    case MeshFormat3::kObj:
      return parse_obj_3(bytes, file, files);
    case MeshFormat3::kPly:
      return parse_ply_3(bytes, file);
    case MeshFormat3::kOff:
      return parse_off_3(bytes, file);
    case MeshFormat3::kStl:
      break;
  }
  return parse_stl_3(bytes, file);
}

MeshScene3 read_mesh_scene_3(const std::filesystem::path& file, Triangulator3* triangulator, PassedOver* passed_over) {
  const auto format = mesh_format_3(file);
  HOTTEL_REQUIRE(format.has_value());
  return scene_of(parse_mesh_3(*format, read_text_file(file), file.string()), triangulator, passed_over);
}

}  // namespace hottel
