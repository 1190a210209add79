// hottel generate: scenes made to order.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "geometry/near_names.h"
#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct GenerateOptions {
  GeneratorRequest2 request;
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
  std::string text = "Make a scene: seeded, the same on every machine.\n\nKinds, and how many edges come out:";
  for (const GeneratorKind2& kind : generator_kinds_2())
    text += fmt::format("\n  {:<9}{}\n           ({})", kind.name, kind.description, kind.count);
  return text;
}

GeneratorRequest2 request_of(const GenerateOptions& options) {
  GeneratorRequest2 request = options.request;
  std::vector<std::string> kinds;
  for (const GeneratorKind2& kind : generator_kinds_2()) kinds.push_back(kind.name);
  if (std::find(kinds.begin(), kinds.end(), request.kind) == kinds.end())
    throw UnknownName(fmt::format("there is no kind of scene called '{}': {}", request.kind, fmt::join(kinds, ", ")),
                      request.kind, kinds);
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

ExitCode generate(const GenerateOptions& options, Streams& streams) {
  require_scene_ending("generate", options.out);
  const Scene2 scene = generate_2(request_of(options));
  streams.write(options.out, write_scene_2(scene));
  streams.note(fmt::format("{} edges", scene.surfaces.size()));
  return ExitCode::kDone;
}

}  // namespace

void add_generate(Commands& commands) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App& command = commands.add("generate", "Make a scene of a given kind and size",
                                   {"hottel generate room --n 300 --seed 1 -o /tmp/room.json",
                                    "hottel generate clutter --n 1000 --view long --digits 17 -o /tmp/clutter.json",
                                    "hottel generate lattice --n 60 --k 5 --seed 7"},
                                   [options](Streams& streams) { return generate(*options, streams); });
  command.description(description());
  GeneratorRequest2& request = options->request;
  command.add_option("KIND", request.kind, "one of the kinds above")->required();
  command.add_option("--n", request.n, "number of edges; see the kinds")
      ->type_name("N")
      ->transform(whole_number(1, kMaxGeneratedEdges))
      ->capture_default_str();
  command.add_option("--seed", request.seed, "other seeds give other scenes; below 2^64")
      ->type_name("S")
      ->transform(whole_number())
      ->capture_default_str();
  command
      .add_option("--digits", options->digits,
                  fmt::format("significant digits of every coordinate, at most {}; without it as few as needed",
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
  command.add_option("-o", options->out, "the scene file to write; without it, or with -, standard output")
      ->type_name("FILE");
}

}  // namespace hottel
