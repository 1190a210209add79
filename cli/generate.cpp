// hottel generate: scenes made to order.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "cli/mesh_output.h"
#include "geometry/near_names.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/space/generate/generators.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_reader.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct GenerateOptions {
  std::string kind;
  std::optional<std::uint64_t> n;
  std::uint64_t seed = 0;
  bool no_bottoms = false;
  std::optional<int> digits;
  std::optional<std::uint64_t> k;
  std::optional<std::string> view, length;
  std::string out;
};

constexpr std::uint64_t kLargestLattice = 100'000;  // as generate_2 has it

// Of clutter, in mean distances, as generate_2 has it.
std::uint64_t room_side(std::uint64_t n) {
  return n < 2 ? 1 : static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n - 1))) + 1;
}

std::string description() {
  std::string text =
      "Make a scene: seeded, the same on every machine.\n\nKinds in the plane, and how many edges come out:";
  for (const GeneratorKind2& kind : generator_kinds_2())
    text += fmt::format("\n  {:<9}{}\n           ({})", kind.name, kind.description, kind.count);
  text += "\n\nKinds in space, what --n N counts, and how many polygons come out:";
  for (const GeneratorKind3& kind : generator_kinds_3())
    text += fmt::format("\n  {:<16}{}\n                  ({}; without --n N is {})", kind.name, kind.description,
                        kind.count, kind.usual_n);
  return text +
         "\nScenes in space are written as .json, or as meshes; an .obj has its materials in an .mtl file beside it.";
}

const GeneratorKind3* kind_in_space(const std::string& name) {
  const auto& kinds = generator_kinds_3();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const GeneratorKind3& known) { return known.name == name; });
  return kind == kinds.end() ? nullptr : &*kind;
}

void require_kind_of_scene(const std::string& name) {
  std::vector<std::string> kinds;
  for (const GeneratorKind2& kind : generator_kinds_2()) kinds.push_back(kind.name);
  for (const GeneratorKind3& kind : generator_kinds_3()) kinds.push_back(kind.name);
  if (std::find(kinds.begin(), kinds.end(), name) == kinds.end())
    throw UnknownName(
        fmt::format("there is no kind of scene called '{}'; the kinds are {}", name, fmt::join(kinds, ", ")), name,
        kinds);
}

GeneratorRequest2 request_of(const GenerateOptions& options) {
  GeneratorRequest2 request;
  request.kind = options.kind;
  request.n = options.n.value_or(request.n);
  request.seed = options.seed;
  if (options.no_bottoms) throw UsageError("--no-bottoms is an option of kinds in space only");
  if (request.kind != "clutter" && (options.view || options.length))
    throw UsageError("--view and --length are options of clutter only");
  if (request.kind != "lattice" && options.k) throw UsageError("--k is an option of lattice only");
  request.digits = options.digits.value_or(0);
  request.k = options.k.value_or(0);
  if (options.view) request.length = *options.view == "short" ? kShortView : kLongView;
  if (options.length) {
    const auto length = parse_rational(*options.length);
    if (!length) throw UsageError("--length must be a number such as 0.5 or 1/2, not '" + *options.length + "'");
    request.length = *length;
    if (request.length <= 4 && 3 * request.length > room_side(request.n))
      throw UsageError(
          fmt::format("--length {} does not fit: with --n {} the room is {} mean distances wide, and a "
                      "segment at most a third of it long",
                      *options.length, request.n, room_side(request.n)));
  }
  return request;
}

ExitCode generate_in_space(const GenerateOptions& options, const GeneratorKind3& kind, const Streams& streams) {
  const auto format = mesh_format_3(options.out);
  const bool is_scene =
      options.out.empty() || options.out == "-" || std::filesystem::path(options.out).extension() == ".json";
  if (!format && !is_scene)
    throw UsageError(fmt::format("generate writes a scene (.json, or - for standard output) or a mesh ({}), not '{}'",
                                 kMeshEndings3, options.out));
  for (const auto& [is_given, option] : {std::pair(options.digits.has_value(), "--digits"),
                                         {options.view || options.length, "--view and --length"},
                                         {options.k.has_value(), "--k"}})
    if (is_given) throw UsageError(fmt::format("{}: kinds in space have no such option", option));
  const Scene3 scene = generate_3({options.kind, options.n.value_or(kind.usual_n), options.seed, !options.no_bottoms});
  if (format)
    write_mesh(options.out, *format, scene, streams);
  else
    streams.write(options.out, write_scene_3(scene));
  streams.note(counted(scene.surfaces.size(), "polygon"));
  return ExitCode::kDone;
}

ExitCode generate(const GenerateOptions& options, Streams& streams) {
  require_kind_of_scene(options.kind);
  if (const GeneratorKind3* kind = kind_in_space(options.kind)) return generate_in_space(options, *kind, streams);
  require_scene_ending("generate", options.out);
  const Scene2 scene = generate_2(request_of(options));
  streams.write(options.out, write_scene_2(scene));
  streams.note(counted(scene.surfaces.size(), "edge"));
  return ExitCode::kDone;
}

}  // namespace

void add_generate(Commands& commands) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App& command = commands.add("generate", "Make a scene of a given kind and size",
                                   {"hottel generate room --n 300 --seed 1 -o /tmp/room.json",
                                    "hottel generate clutter --n 1000 --view long --digits 17 -o /tmp/clutter.json",
                                    "hottel generate lattice --n 60 --k 5 --seed 7",
                                    "hottel generate room-turned --n 20 --seed 3 -o /tmp/room_turned.json",
                                    "hottel generate street-blocks --n 40 --no-bottoms -o /tmp/street_blocks.obj"},
                                   [options](Streams& streams) { return generate(*options, streams); });
  command.description(description());
  command.add_option("KIND", options->kind, "one of the kinds above")->required();
  command
      .add_option("--n", options->n,
                  fmt::format("in the plane the number of edges, without it {}; in space as the kind says, at most {}",
                              GeneratorRequest2().n, kMaxGeneratedBodies))
      ->type_name("N")
      ->transform(whole_number(1, kMaxGeneratedEdges));
  command.add_option("--seed", options->seed, "other seeds give other scenes; below 2^64")
      ->type_name("S")
      ->transform(whole_number())
      ->capture_default_str();
  command.add_flag("--no-bottoms", options->no_bottoms,
                   "in space: boxes have no face where they stand on the floor, the ground or each other");
  command
      .add_option(
          "--digits", options->digits,
          fmt::format("in the plane: significant digits of every coordinate, at most {}; without it as few as needed",
                      kMaxGeneratedDigits))
      ->type_name("D")
      ->transform(whole_number(1, kMaxGeneratedDigits));
  CLI::Option* view = command.add_option("--view", options->view,
                                         "clutter: short (segments as long as they are apart) or long (a fifth of it)");
  view->type_name("VIEW")->check(CLI::IsMember({"short", "long"}));
  command.add_option("--length", options->length, "clutter: length of the segments in mean distances, 1/50 to 4")
      ->type_name("L")
      ->excludes(view);
  command.add_option("--k", options->k, "lattice: points from 0 to K; without it the root of N, at least 4")
      ->type_name("K")
      ->transform(whole_number(1, kLargestLattice));
  command
      .add_option("-o", options->out,
                  "the scene to write, .json (in space also a mesh: .obj, ...); without it, or with -, standard output")
      ->type_name("FILE");
}

}  // namespace hottel
