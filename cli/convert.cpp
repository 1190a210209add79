// hottel convert: rewrite a scene, or read one from a drawing.
#include <filesystem>

#include "cli/command.h"
#include "io/scene_json.h"
#include "kernel/failure.h"

namespace hottel {
namespace {

struct ConvertOptions {
  std::string in, out;
};

Scene2 read_any(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".json") return read_scene_2(file);
  throw UsageError("convert reads .json, not '" + file.string() + "'");
}

ExitCode convert(const ConvertOptions& options, Streams& streams) {
  if (options.out != "-" && std::filesystem::path(options.out).extension() != ".json")
    throw UsageError("convert writes .json (or '-', standard output), not '" + options.out + "'");
  const Scene2 scene = read_any(options.in);
  streams.write(options.out, write_scene_2(scene));
  return ExitCode::kDone;
}

}  // namespace

void add_convert(Commands& commands) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = commands.add("convert", "Rewrite a scene", {"hottel convert scenes/analytic/triangle_345.json -"},
                                   [options](Streams& streams) { return convert(*options, streams); });
  command.add_option("IN", options->in, "the scene")->required();
  command.add_option("OUT", options->out, "the file to write; - is standard output")->required();
}

}  // namespace hottel
