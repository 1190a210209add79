// hottel convert: rewrite a scene, or read one from a drawing or a mesh.
#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/obj_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/naming_file.h"

namespace hottel {
namespace {

struct ConvertOptions {
  std::string in, out;
};

// What a drawing or a mesh does not say, and where the user can say it.
std::string reflectivities(const std::vector<std::string>& materials, const Rational& value, std::string_view input) {
  std::string names;
  for (const std::string& material : materials) names += (names.empty() ? "" : ", ") + one_line(material);
  return fmt::format("reflectivity {} for: {} ({} does not say; edit \"materials\")", shortest(to_double(value)), names,
                     input);
}

void convert_drawing(const ConvertOptions& options, Streams& streams) {
  const Scene2 scene = read_svg_2(options.in);
  streams.write(options.out, naming_file(options.in, [&] { return write_scene_2(scene); }));
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(material.name);
  streams.note(
      fmt::format("{} edges; {}", scene.surfaces.size(), reflectivities(materials, kSvgReflectivity, "a drawing")));
}

void convert_mesh(const ConvertOptions& options, Streams& streams) {
  const ObjScene3 mesh = read_obj_3(options.in);
  streams.write(options.out, naming_file(options.in, [&] { return write_scene_3(mesh.scene); }));
  if (!mesh.invented.empty())
    streams.note(fmt::format("{} polygons; {}", mesh.scene.surfaces.size(),
                             reflectivities(mesh.invented, kObjReflectivity, "the mesh")));
}

void convert_scene(const ConvertOptions& options, Streams& streams) {
  const Scene scene = read_scene(options.in);
  streams.write(options.out, naming_file(options.in, [&] {
                  const auto* plane = std::get_if<Scene2>(&scene);
                  return plane ? write_scene_2(*plane) : write_scene_3(std::get<Scene3>(scene));
                }));
}

ExitCode convert(const ConvertOptions& options, Streams& streams) {
  require_scene_ending("convert", options.out);
  const std::filesystem::path ending = std::filesystem::path(options.in).extension();
  if (ending == ".svg")
    convert_drawing(options, streams);
  else if (ending == ".obj")
    convert_mesh(options, streams);
  else if (ending == ".json")
    convert_scene(options, streams);
  else
    throw UsageError("convert reads a drawing (.svg), a mesh (.obj) or a scene (.json), not '" + options.in + "'");
  return ExitCode::kDone;
}

}  // namespace

void add_convert(Commands& commands) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = commands.add(
      "convert",
      "Read a drawing or a mesh as a scene, or rewrite a scene\n\n"
      "From an .svg: lines, polylines, polygons, rects and paths of straight pieces, exactly, y pointing up. The "
      "front\n"
      "of a line is its right side as drawn (a rect is a room); data-front=\"left\" turns it round. Names are ids,\n"
      "materials classes or data-material, data-back is the material of the back. Curves, styles that move, resize or\n"
      "hide, other data- keys and whatever else cannot be read exactly are refused, never dropped.\n"
      "From an .obj: its faces as polygons in space, exactly; groups, and the materials of its .mtl files (Kd, Ke).\n"
      "From a .json, in the plane or in space: the same scene in normal form, numbers shortest, one surface a line.",
      {"hottel convert scenes/drawings/two_rooms.svg /tmp/two_rooms.json",
       "hottel convert scenes/space/room_boxes.obj /tmp/room_boxes.json",
       "hottel convert scenes/analytic/triangle_345.json -"},
      [options](Streams& streams) { return convert(*options, streams); });
  command.add_option("IN", options->in, "drawing (.svg), mesh (.obj) or scene (.json)")->required();
  command.add_option("OUT", options->out, "the scene to write (.json); - is standard output")->required();
}

}  // namespace hottel
