// hottel convert: rewrite a scene, or read one from a drawing.
#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/naming_file.h"

namespace hottel {
namespace {

struct ConvertOptions {
  std::string in, out;
};

// What a drawing does not say, and where the user can say it.
void note_materials(const Scene2& scene, const Streams& streams) {
  std::string names;
  for (const Material& material : scene.materials) names += (names.empty() ? "" : ", ") + one_line(material.name);
  streams.note(fmt::format("{} edges; reflectivity {} for: {} (a drawing does not say; edit \"materials\")",
                           scene.surfaces.size(), shortest(to_double(kSvgReflectivity)), names));
}

ExitCode convert(const ConvertOptions& options, Streams& streams) {
  const std::filesystem::path in = options.in;
  require_scene_ending("convert", options.out);
  const bool is_drawing = in.extension() == ".svg";
  if (!is_drawing && in.extension() != ".json")
    throw UsageError("convert reads a drawing (.svg) or a scene (.json), not '" + options.in + "'");
  const Scene2 scene = is_drawing ? read_svg_2(in) : read_scene_2(in);
  streams.write(options.out, naming_file(options.in, [&] { return write_scene_2(scene); }));
  if (is_drawing) note_materials(scene, streams);
  return ExitCode::kDone;
}

}  // namespace

void add_convert(Commands& commands) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = commands.add(
      "convert",
      "Read a drawing as a scene, or rewrite a scene\n\n"
      "From an .svg: lines, polylines, polygons, rects and paths of straight pieces, exactly, y pointing up. The "
      "front\n"
      "of a line is its right side as drawn (a rect is a room); data-front=\"left\" turns it round. Names are ids,\n"
      "materials classes or data-material, data-back is the material of the back. Curves, styles that move, resize or\n"
      "hide, other data- keys and whatever else cannot be read exactly are refused, never dropped.\n"
      "From a .json: the same scene in normal form, numbers shortest, one surface a line.",
      {"hottel convert scenes/drawings/two_rooms.svg /tmp/two_rooms.json",
       "hottel convert scenes/analytic/triangle_345.json -"},
      [options](Streams& streams) { return convert(*options, streams); });
  command.add_option("IN", options->in, "drawing (.svg) or scene (.json)")->required();
  command.add_option("OUT", options->out, "the scene to write (.json); - is standard output")->required();
}

}  // namespace hottel
