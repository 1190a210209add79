// hottel view: a window in which a scene is edited, and light follows.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "cli/command.h"
#include "cli/room_for_elements.h"
#include "cli/scene_input.h"
#include "geometry/near_names.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"
#include "viewer/window/plane/viewer.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/script_player.h"
#include "viewer/window/sdl_window.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr std::uint32_t kWidth = 1280, kHeight = 800;
constexpr double kMostScale = 8;

struct ViewOptions {
  std::string scene, screenshot, script, record, look = "light";
  std::string size;
  double scale = 1;
  std::optional<std::uint64_t> memory;
  ElementOptions elements;
  PolygonOptions polygons;
};

FrameSize size_of(const ViewOptions& options) {
  if (options.size.empty())
    return {static_cast<std::uint32_t>(kWidth * options.scale), static_cast<std::uint32_t>(kHeight * options.scale)};
  const auto [width, height] = two_numbers("--size", "WxH", options.size, kMaxPictureSide);
  return {width, height};
}

// The frames of a recording, as numbered files.
class FrameFiles {
 public:
  explicit FrameFiles(const std::string& folder) : path_(folder), folder_(folder) {}
  void write(const Raster& frame) {
    write_output_file(path_ / fmt::format("frame-{:05}.png", ++count_), png_file(frame));
  }
  int count() const { return count_; }

 private:
  std::filesystem::path path_;
  OutputFolder folder_;
  int count_ = 0;
};

// The words of the view modes of one dimension, one of which must be asked for.
template <class Mode>
void require_view_mode(const std::string& look, int count, const char* where) {
  std::vector<std::string> known;
  for (int k = 0; k < count; ++k) known.push_back(to_string(static_cast<Mode>(k)));
  if (std::ranges::find(known, look) == known.end())
    throw UnknownName(
        fmt::format("there is nothing to look at called '{}' {}; there are {}", look, where, fmt::join(known, ", ")),
        look, known);
}

// The scene of the file: read before a window is opened, so that what is wrong with it is said first.
Scene scene_of(const ViewOptions& options, const Streams& streams) {
  return changeable(read_scene_noting(options.scene, options.polygons, streams));
}

// The viewer of a scene of either dimension. Its file may be read again.
std::unique_ptr<Viewer> viewer_of(const ViewOptions& options, Scene scene, Window& window) {
  std::unique_ptr<Viewer> viewer;
  if (Scene3* const space = std::get_if<Scene3>(&scene)) {
    require_view_mode<ViewMode3>(options.look, kViewModes3, "in space");
    // The scene that has been read is the first one.
    const auto first = std::make_shared<std::optional<Scene3>>(std::move(*space));
    const auto read = [file = options.scene, elements = options.elements, first] {
      Scene3 now = *first ? std::move(**first) : Scene3(read_scene_3(file));
      first->reset();
      elements.apply_to(now);
      return now;
    };
    {
      Scene3 divided = **first;
      options.elements.apply_to(divided);
      require_room_for_solving(divided, options.memory);
    }
    viewer = std::make_unique<Viewer3>(ViewerSource3{options.scene, read}, window,
                                       FactorsRequest3{.memory = options.memory.value_or(0)}, options.scale);
  } else {
    require_view_mode<ViewMode2>(options.look, kViewModes2, "in the plane");
    if (options.elements.is_given())
      throw UsageError("--elements and --element-size divide the polygons of scenes in space; " + options.scene +
                       " is in the plane");
    require_room_for_solving(std::get<Scene2>(scene), options.memory);
    viewer = std::make_unique<Viewer2>(options.scene, window, SimulationRequest2{.memory = options.memory.value_or(0)},
                                       options.scale, std::get<Scene2>(std::move(scene)), options.polygons.side());
  }
  viewer->command("look " + options.look);
  return viewer;
}

// Without a screen: plays the script, if there is one, and writes what is asked for.
ExitCode play(const ViewOptions& options, Streams& streams) {
  const std::string text = options.script.empty()  ? ""
                           : options.script == "-" ? read_standard_input()
                                                   : read_text_file(options.script);
  const std::string name = options.script == "-" ? "standard input" : options.script;
  const std::vector<ScriptStep> steps = parse_script(text, name);
  RecordingWindow window(size_of(options));
  const std::unique_ptr<Viewer> viewer = viewer_of(options, scene_of(options, streams), window);
  std::optional<FrameFiles> frames;
  ScriptOutputs outputs{.print = [&streams](const std::string& line) { streams.write("", line + "\n"); }};
  if (!options.record.empty()) {
    frames.emplace(options.record);
    outputs.frame = [&frames](const Raster& frame) { frames->write(frame); };
  }
  play_script(steps, name, *viewer, window, outputs);
  if (!options.screenshot.empty()) save_screenshot(window.frame(), options.screenshot);
  if (frames)
    streams.note(fmt::format("{} frames, {} a second, in {}", frames->count(), kFramesPerSecond, options.record));
  return ExitCode::kDone;
}

ExitCode view(const ViewOptions& options, Streams& streams) {
  if (options.scene == kStandardInput)
    throw UsageError("the window looks again whether its scene has changed: it takes a file, not standard input");
  if (!options.screenshot.empty() && picture_format(options.screenshot) != PictureFormat::kPng)
    throw UsageError("--screenshot writes a .png file, not '" + options.screenshot + "'");
  if (options.record == "-")
    throw UsageError("a recording is many files: --record takes a folder, not standard output");
  if (!options.script.empty() || !options.screenshot.empty() || !options.record.empty()) return play(options, streams);
  Scene scene = scene_of(options, streams);
  const std::unique_ptr<Window> window = open_window("hottel", size_of(options));
  const std::unique_ptr<Viewer> viewer = viewer_of(options, std::move(scene), *window);
  viewer->run();
  return ExitCode::kDone;
}

}  // namespace

void add_view(Commands& commands) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App& command = commands.add(
      "view",
      "A window: move walls, furniture and lamps, in the plane and in space, and exact light follows; in space walk\n"
      "through it\n\n"
      "Press h in the window for all keys. With --screenshot, --script or --record there is no window, and no display\n"
      "is needed; docs/window.md has the steps of a script.",
      {"hottel view scenes/showcase/apartment.json --screenshot /tmp/apartment.png",
       "hottel view scenes/showcase/museum.json --look factors --size 800x600 --screenshot /tmp/museum.png",
       "hottel view scenes/space/two_boxes.json --elements 3 --screenshot /tmp/boxes.png",
       "hottel view scenes/lights/stage.json --screenshot /tmp/stage.png"},
      [options](Streams& streams) { return view(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command
      .add_option(
          "--look", options->look,
          "what to show at first: light floor bands visibility factors pair errors check plan sweeps; in space: "
          "light radiosity irradiance factors errors plan sweeps")
      ->type_name("LOOK")
      ->capture_default_str();
  command.add_option("--scale", options->scale, "letters and lines S times as large")
      ->type_name("S")
      ->check(number_between(0.25, kMostScale))
      ->capture_default_str();
  command.add_option("--size", options->size, "pixels of the window; without it 1280x800 times S")->type_name("WxH");
  command.add_option("--screenshot", options->screenshot, "write what is seen at last (.png)")->type_name("FILE");
  command.add_option("--script", options->script, "do these steps, a line each")->type_name("FILE");
  command.add_option("--record", options->record, "write every frame as a PNG file into this folder")->type_name("DIR");
  options->elements.add_to(command);
  options->polygons.add_front_to(command);
  command
      .add_option("--memory", options->memory,
                  "bytes the factors may take, and light in the plane; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
}

}  // namespace hottel
