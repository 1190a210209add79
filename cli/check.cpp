// hottel check: what is worth telling about a scene before light is computed.
#include "cli/command.h"
#include "io/check_report.h"
#include "io/scene_json.h"
#include "solver/check/scene_check_2.h"

namespace hottel {
namespace {

struct CheckCommandOptions {
  std::string scene;
  bool json = false;
};

ExitCode check(const CheckCommandOptions& options, Streams& streams) {
  const Scene2 scene = read_scene_2(options.scene);
  const SceneCheck2 check = check_scene(scene, {.progress = streams.progress("view factors")});
  streams.write("", options.json ? check_json(scene, check.findings) : check_text(scene, check.findings));
  return has_error(check.findings) ? ExitCode::kUnmet : ExitCode::kDone;
}

}  // namespace

void add_check(Commands& commands) {
  const auto options = std::make_shared<CheckCommandOptions>();
  CLI::App& command = commands.add(
      "check", "Find what is wrong with a scene, probably not meant, or worth knowing",
      {"hottel check scenes/showcase/apartment.json", "hottel check scenes/analytic/triangle_345.json --json"},
      [options](Streams& streams) { return check(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_flag("--json", options->json, "as one JSON object");
}

}  // namespace hottel
