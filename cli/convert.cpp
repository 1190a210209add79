// hottel convert: rewrite a scene, read one from a drawing or a mesh, or write it as a mesh.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "cli/command.h"
#include "cli/mesh_output.h"
#include "cli/scene_input.h"
#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/binary_scene.h"
#include "io/scene/plane/map_reader.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "io/scene/space/vs3_reader.h"
#include "io/scene/space/vs3_writer.h"
#include "io/scene/table_writer.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"

namespace hottel {
namespace {

struct ConvertOptions {
  std::string in, out, per;
  PolygonOptions polygons;
};

// What a drawing or a mesh does not say, and where the user can say it.
std::string reflectivities(const std::vector<std::string>& materials, const Rational& value, std::string_view input) {
  std::string names;
  for (const std::string& material : materials) names += (names.empty() ? "" : ", ") + one_line(material);
  return fmt::format("reflectivity {} for: {} ({} does not say; edit \"materials\")", shortest(to_double(value)), names,
                     input);
}

// Files that the scene is made of stay as they are; the scene itself may be rewritten in its place.
void require_unread_output(const ConvertOptions& options, const SceneTable& scene) {
  for (const std::string& source : scene.sources)
    if (!is_same_file(source, options.in)) require_not_read("OUT " + options.out, options.out, options.in, source);
}

// A scene as the file that is asked for has it: as text, or read already.
template <class AnyScene>
void write_as_scene(const ConvertOptions& options, const AnyScene& scene, const Streams& streams) {
  require_unread_output(options, scene);
  streams.write(options.out, with_file_context(options.in, [&] {
                  if (is_binary_scene_name(options.out)) return binary_scene(scene);
                  if constexpr (std::is_same_v<AnyScene, Scene2>)
                    return write_scene_2(scene);
                  else
                    return write_scene_3(scene);
                }));
}

void convert_drawing(const ConvertOptions& options, Streams& streams) {
  PassedOver passed_over;
  const Scene2 scene = read_svg_2(options.in, &passed_over);
  write_as_scene(options, scene, streams);
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(material.name);
  streams.note(fmt::format("{}; {}", counted(scene.surfaces.size(), "edge"),
                           reflectivities(materials, kSvgReflectivity, "a drawing")));
  note_passed_over(passed_over, streams);
}

void convert_map(const ConvertOptions& options, Streams& streams) {
  PassedOver passed_over;
  const Scene2 scene = read_map_2(options.in, options.polygons.side(), &passed_over);
  write_as_scene(options, scene, streams);
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(material.name);
  streams.note(fmt::format("{}; {}", counted(scene.surfaces.size(), "edge"),
                           reflectivities(materials, kMapReflectivity, "a map")));
  note_passed_over(passed_over, streams);
}

// A scene file has fractions where they are shorter, and a fraction has no last digit.
std::string scene_number(const Rational& value) {
  std::string text = json_number(value);
  std::erase(text, '"');
  return text;
}

// What was plane but for the spacing of binary floats may be too far off for the digits that a scene file has.
void note_lost_planes(const Scene3& scene, Streams& streams) {
  FinestDigit finest;
  for (const Polygon3& polygon : scene.polygons)
    for (const Point3& p : corners_of(polygon))
      for (const Rational* coordinate : {&p.x, &p.y, &p.z}) finest.take(scene_number(*coordinate));
  std::vector<std::string> lost;
  for (std::size_t s = 0; s < scene.polygons.size(); ++s)
    if (Polygon3 polygon = scene.polygons[s]; polygon.is_nearly_plane && !accept_nearly_plane(polygon, finest.unit()))
      lost.push_back(scene.surfaces[s].name);
  if (!lost.empty())
    streams.note(fmt::format("as decimals, which have more digits, these are not plane: {}; --triangulate reads them",
                             listed_names(lost)));
}

void write_as_mesh(const ConvertOptions& options, MeshFormat3 format, const Scene3& scene, Streams& streams) {
  require_unread_output(options, scene);
  with_file_context(options.in, [&] { write_mesh(options.out, format, scene, streams); });
}

void convert_mesh(const ConvertOptions& options, Streams& streams) {
  Triangulator3 triangulator;
  PassedOver passed_over;
  const MeshScene3 mesh =
      read_mesh_scene_3(options.in, options.polygons.triangulates ? &triangulator : nullptr, &passed_over);
  note_passed_over(passed_over, streams);
  note_cuts(triangulator, streams);
  if (const auto format = mesh_format_3(options.out)) return write_as_mesh(options, *format, mesh.scene, streams);
  if (!is_binary_scene_name(options.out)) note_lost_planes(mesh.scene, streams);
  write_as_scene(options, *mesh.scene, streams);
  if (!mesh.invented.empty())
    streams.note(fmt::format("{}; {}", counted(mesh.scene->surfaces.size(), "polygon"),
                             reflectivities(mesh.invented, kMeshReflectivity, "the mesh")));
}

void convert_scene(const ConvertOptions& options, Streams& streams) {
  const ValidScene scene = read_scene_noting(options.in, options.polygons, streams);
  const auto* space = std::get_if<ValidScene3>(&scene);
  if (const auto format = mesh_format_3(options.out)) {
    if (space == nullptr)
      throw InputError({options.in, 0},
                       "the scene is in the plane (dimension 2); a mesh is in space: write .json or .hs");
    return write_as_mesh(options, *format, **space, streams);
  }
  if (space && !is_binary_scene_name(options.out)) note_lost_planes(**space, streams);
  std::visit([&](const auto& any) { write_as_scene(options, *any, streams); }, scene);
}

// Reads the scene of a file, in space, and writes it to a deck, combined per "face" or "group"; empty: a deck per
// group, anything else per face. Remarks tell what the deck does not say. Throws InputError for a scene in the plane.
void write_deck(const ConvertOptions& options, const Streams& streams) {
  const std::string &in = options.in, &per = options.per;
  const ValidScene scene = read_scene_noting(in, options.polygons, streams);
  const auto* const in_space = std::get_if<ValidScene3>(&scene);
  if (in_space == nullptr)
    throw InputError({in, 0}, "the scene is in the plane (dimension 2); a deck (.vs3) is in space");
  require_unread_output(options, **in_space);
  const bool combines_groups = per.empty() ? is_vs3(in) : per == "group";
  const WrittenVs3Deck3 deck = with_file_context(in, [&] { return write_vs3_3(**in_space, combines_groups); });
  streams.write(options.out, deck.text);
  for (const std::string& note : deck.notes) streams.note(one_line(note));
}

ExitCode convert(const ConvertOptions& options, Streams& streams) {
  const std::filesystem::path ending = std::filesystem::path(options.in).extension();
  const bool makes_mesh = mesh_format_3(options.out).has_value(), makes_deck = is_vs3(options.out);
  if (!options.per.empty() && !makes_deck) throw UsageError("--per says what a deck (.vs3) combines, and nothing else");
  const bool makes_scene = options.out == "-" || std::filesystem::path(options.out).extension() == ".json" ||
                           is_binary_scene_name(options.out);
  if (!makes_mesh && !makes_deck && !makes_scene)
    throw UsageError(std::string("convert writes a scene (.json, or - for standard output; .hs), a mesh (") +
                     kMeshEndings3 + ") or a deck of View3D (.vs3), not '" + options.out + "'");
  const bool is_scene = ending == ".json" || is_binary_scene_name(options.in) || options.in == kStandardInput;
  options.polygons.require_sense_for(options.in);
  if (is_map_2(options.in)) {
    if (options.polygons.triangulates) throw UsageError("--triangulate cuts polygons in space; a map is in the plane");
    if (makes_mesh || makes_deck)
      throw UsageError("a map is in the plane and becomes a scene (.json), not a mesh or a deck");
    convert_map(options, streams);
  } else if (is_svg_2(options.in)) {
    if (options.polygons.triangulates)
      throw UsageError("--triangulate cuts polygons in space; a drawing is in the plane");
    if (makes_mesh || makes_deck)
      throw UsageError("a drawing is in the plane and becomes a scene (.json), not a mesh or a deck");
    convert_drawing(options, streams);
  } else if (makes_deck && (mesh_format_3(options.in) || is_vs3(options.in) || is_scene)) {
    write_deck(options, streams);
  } else if (mesh_format_3(options.in)) {
    convert_mesh(options, streams);
  } else if (is_scene || is_vs3(options.in)) {
    convert_scene(options, streams);
  } else {
    throw UsageError(std::string("convert reads a drawing (.svg), a map (.geojson, .wkt), a mesh (") + kMeshEndings3 +
                     "), a deck of View3D (.vs3) or a scene (.json, .hs), not '" + options.in + "'");
  }
  return ExitCode::kDone;
}

}  // namespace

void add_convert(Commands& commands) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = commands.add(
      "convert",
      "Read a drawing, a map or a mesh as a scene, rewrite a scene, or write it as a mesh\n\n"
      "From an .svg: lines, polylines, polygons, rects and paths of straight pieces, exactly, y pointing up. The "
      "front\n"
      "of a line is its right side as drawn (a rect is a room); data-front=\"left\" turns it round. Names are ids,\n"
      "materials classes or data-material, data-back is the material of the back; data-on=\"wall\" makes it a part of\n"
      "the wall, such as a window. Curves, styles that move, resize or hide, other data- keys and whatever else "
      "cannot\n"
      "be read exactly are refused, never dropped.\n"
      "From a .geojson or .wkt: polygons with their holes, and lines, exactly. A polygon is a room and its holes are "
      "solid;\n"
      "--front outside makes it a building with courtyards.\n"
      "From an .obj: its faces as polygons in space, exactly; groups, and the materials of its .mtl files (Kd, Ke).\n"
      "From a .ply, .off or .stl, text or binary (.off: text): its faces, exactly; colours and normals are passed "
      "over.\n"
      "From a .json, in the plane or in space: the same scene in normal form, numbers shortest, one surface a line.\n"
      "To an .obj (its materials in an .mtl beside it), .ply, .off or .stl: the polygons of a scene in space, "
      "decimals\n"
      "exactly; STL has floats and triangles. What the file does not hold, or not exactly, is told on stderr.\n"
      "From a .vs3: a deck of View3D. To a .vs3: a deck for it, with pieces of three or four corners.\n"
      "To an .hs: the scene as it was read, in bytes, which all commands read in a quarter of the time; from it: "
      "any of these.",
      {"hottel convert scenes/drawings/two_rooms.svg /tmp/two_rooms.json",
       "hottel convert scenes/drawings/hall.wkt /tmp/hall.json",
       "hottel convert scenes/space/room_boxes.obj /tmp/room_boxes.json",
       "hottel convert scenes/space/two_boxes.json /tmp/two_boxes.ply",
       "hottel convert scenes/space/partition.vs3 /tmp/partition.json",
       "hottel convert scenes/space/two_boxes.json /tmp/two_boxes.vs3 --per group",
       "hottel convert scenes/showcase/apartment.json /tmp/apartment.hs",
       "hottel convert scenes/analytic/triangle_345.json -"},
      [options](Streams& streams) { return convert(*options, streams); });
  command
      .add_option("IN", options->in,
                  "drawing (.svg), map (.geojson, .wkt), mesh (.obj, .ply, .off, .stl), deck (.vs3) or scene (.json, "
                  ".hs); - is "
                  "a scene, map or drawing on standard input")
      ->required();
  command.add_option("OUT", options->out, "the scene (.json, .hs; - is standard output), mesh or deck to write")
      ->required();
  command
      .add_option("--per", options->per,
                  "of a deck (.vs3): group combines the surfaces of a group (cmb), as is the default where IN is one; "
                  "face does not")
      ->check(CLI::IsMember({"face", "group"}));
  options->polygons.add_to(command);
}

}  // namespace hottel
