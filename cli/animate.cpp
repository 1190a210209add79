// hottel animate: lights that move, frame by frame, as pictures and one file of all of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "cli/command.h"
#include "cli/guarantee_option.h"
#include "cli/level_options.h"
#include "cli/methods.h"
#include "cli/room_for_elements.h"
#include "cli/scene_input.h"
#include "cli/solve_options.h"
#include "cli/store_option.h"
#include "cli/unit_notes.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/scene/moving_lights.h"
#include "io/external/external_command.h"
#include "io/external/external_method.h"
#include "io/external/plane/external_matrix.h"
#include "io/external/space/external_matrix.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "io/results/frames_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/counted.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/version.h"
#include "solver/animation.h"
#include "solver/memory_store.h"
#include "solver/plane/light/refinement.h"
#include "solver/space/light/refinement.h"
#include "viewer/picture/animated_png.h"
#include "viewer/picture/plane/film_frame.h"
#include "viewer/picture/space/film_frame.h"

namespace hottel {
namespace {

// The most frames: their numbers have five digits.
constexpr std::uint64_t kMostFrames = 100'000;

struct AnimateOptions {
  std::string scene, out;
  std::uint64_t frames = 0;
  std::string per_second = "25";
  LevelOptions levels;
  ElementOptions elements;
  PolygonOptions polygons;
  StoreOption store;
  std::string method = "exact", grid, shading = "flat";
  std::optional<std::string> tone;  // nothing: that of the dimension
  double exposure = 1;
  std::uint32_t size = 0;
  std::optional<std::string> tolerance;
  GuaranteeOption guarantee;
  std::optional<std::uint64_t> memory;
  bool no_film = false, json = false;
};

Rational rate_of(const AnimateOptions& options) {
  const Rational rate = number_of(options.per_second, "--fps");
  if (rate <= 0) throw UsageError("--fps must be greater than 0, not " + options.per_second);
  return rate;
}

// What a dimension has of its own.
struct Plane {
  using Simulation = Simulation2;
  using Painter = FilmPainter2;
  static constexpr Tone kTone = kUsualTone2;

  static std::string text_of(const Scene2& scene) { return write_scene_2(scene); }
  static Painter painter(const AnimateOptions& options) {
    return Painter(
        {.tone = tone_asked(options.tone, kTone), .exposure = options.exposure, .wanted_width = options.size});
  }
  static Simulation simulation(const AnimateOptions& options, ValidScene2 scene, std::shared_ptr<FactorStore> store) {
    if (options.tolerance)
      throw UsageError("--tolerance is for scenes in space: in the plane every factor is correctly rounded");
    options.guarantee.refuse_in_plane();
    if (options.shading != "flat") throw UsageError("--shading is for scenes in space");
    SimulationRequest2 request{.grid = grids_of(*scene, options.grid).front(),
                               .keeps_rows = !options.levels.levels().is_any()};
    request.method = all_methods_2().make(options.method);
    request.memory = options.memory.value_or(0);
    request.store = std::move(store);
    return Simulation(std::move(scene), std::move(request));
  }
  // In the plane one sweep finds all factors together: to keep them by pairs is no gain.
  static std::shared_ptr<FactorStore> usual_store(std::uint64_t) { return nullptr; }
};

struct Space {
  using Simulation = Simulation3;
  using Painter = FilmPainter3;
  static constexpr Tone kTone = kUsualTone3;

  static std::string text_of(const Scene3& scene) { return write_scene_3(scene); }
  static Painter painter(const AnimateOptions& options) {
    return Painter({.tone = tone_asked(options.tone, kTone),
                    .exposure = options.exposure,
                    .wanted_width = options.size,
                    .shading = *shading_of(options.shading)});
  }
  static Simulation simulation(const AnimateOptions& options, ValidScene3 scene, std::shared_ptr<FactorStore> store) {
    if (!options.grid.empty())
      throw UsageError("--grid is only for scenes in the plane: in space frames show what a camera sees");
    if (options.method != "exact") options.guarantee.refuse_of_method(options.method);
    SimulationRequest3 request;
    request.factors.granularity = Granularity::kElement;
    request.factors.method = options.method == "exact" ? nullptr : all_methods_3().make(options.method);
    request.factors.tolerance = tolerance_of(options.tolerance, FactorsRequest3().tolerance);
    request.factors.must_be_enclosed = options.guarantee.must_be_enclosed();
    request.factors.memory = options.memory.value_or(0);
    request.factors.store = std::move(store);
    request.system.serves_many = true;
    return Simulation(std::move(scene), request);
  }
  static std::shared_ptr<FactorStore> usual_store(std::uint64_t bytes) { return make_memory_store(bytes); }
};

// What frames are of: where it is the same, those that are there are not made again.
std::string key_of(const AnimateOptions& options, Tone tone, const std::string& scene, double tolerance) {
  return sha256(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", kVersion, rate_of(options).get_str(),
                            options.levels.everywhere, options.levels.at_borders, options.grid, to_string(tone),
                            shortest(options.exposure), options.size, options.shading, shortest(tolerance),
                            options.method, scene) +
                (options.guarantee.must_be_enclosed() ? "\nenclosed" : ""));
}

// The pictures of a folder put together.
void write_animated_png(const std::filesystem::path& folder, std::uint32_t frames, const Rational& per_second) {
  const double seconds = 1 / to_double(per_second);
  // As milliseconds, or, of very fast frames, as ticks of a 65535th.
  const bool is_slow = seconds >= 0.01;
  const double ticks = std::clamp(seconds * (is_slow ? 1000 : 65535), 1.0, 65535.0);
  OutputFile file(folder / "animation.png");
  AnimatedPng film(frames, static_cast<std::uint16_t>(std::lround(ticks)), is_slow ? 1000 : 65535,
                   [&file](std::string_view bytes) { file.write(bytes); });
  for (std::uint32_t k = 0; k < frames; ++k) {
    const std::filesystem::path name = folder / frame_file_name(k);
    if (const std::string problem = film.add(read_text_file(name)); !problem.empty())
      throw InputError({name.string(), 0}, problem, {"remove it: it is made again"});
  }
  film.finish();
  file.commit();
}

bool has_program(const char* name) {
  const char* path = std::getenv("PATH");
  const std::string all = path == nullptr ? "" : path;
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find(':', begin), all.size());
    std::error_code none;
    const auto status = std::filesystem::status(std::filesystem::path(all.substr(begin, end - begin)) / name, none);
    if (std::filesystem::is_regular_file(status)) return true;
    begin = end + 1;
  }
  return false;
}

// The same as a film, where there is a program that makes it. Sides are made even: the usual pixels of films are.
void write_mp4(const std::filesystem::path& folder, std::uint32_t frames, const Rational& per_second) {
  const ScratchFolder scratch;
  const CommandRun run = run_external_command(
      fmt::format("cd {{scene}} && ffmpeg -v error -y -framerate {} -i frame_%05d.png -frames:v {} -vf "
                  "'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p {{out.mp4}}",
                  per_second.get_str(), frames),
      std::filesystem::absolute(folder).string(), scratch);
  write_output_file(folder / "animation.mp4", read_text_file(run.output));
}

// Pictures that an earlier, longer run left in the folder: the first and the last one, and how many there are.
std::optional<std::string> note_of_frames_beyond(const std::filesystem::path& folder, std::uint32_t frames) {
  std::set<std::string> beyond;
  const std::size_t length = frame_file_name(0).size();
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const std::string name = entry.path().filename().string();
    if (name.size() != length || !name.starts_with("frame_") || !name.ends_with(".png")) continue;
    const std::string digits = name.substr(6, length - 10);
    if (digits.find_first_not_of("0123456789") == std::string::npos && std::stoul(digits) >= frames)
      beyond.insert(name);
  }
  if (beyond.empty()) return std::nullopt;
  return fmt::format("{} holds {} of an earlier run beyond these, {}{}: {} not of this animation", folder.string(),
                     counted(beyond.size(), "frame"), *beyond.begin(),
                     beyond.size() > 1 ? " to " + *beyond.rbegin() : "", beyond.size() > 1 ? "they are" : "it is");
}

std::string summary(const FramesMade& made, std::uint32_t frames, std::uint32_t were_there,
                    const std::filesystem::path& folder, const std::vector<std::string>& files) {
  FrameCounts all;
  std::uint64_t least = 0, most = 0;
  double longest = 0;
  std::uint32_t without_work = 0;
  double defect = 0;
  for (std::uint32_t k = 0; k < frames; ++k) {
    const FrameCounts& counts = made.frames.at(k).counts;
    least = k == 0 ? counts.elements : std::min(least, counts.elements);
    most = std::max(most, counts.elements);
    all.computed += counts.computed;
    all.read += counts.read;
    all.seconds += counts.seconds;
    longest = std::max(longest, counts.seconds);
    if (counts.computed == 0) ++without_work;
    defect = std::max(defect, counts.row_defect);
  }
  std::string text = fmt::format("{} {}", frames, frames == 1 ? "frame" : "frames");
  if (were_there > 0) text += fmt::format(", {} of them there before", were_there);
  text += least == most ? fmt::format("; {} active elements\n", most)
                        : fmt::format("; {} to {} active elements\n", least, most);
  if (were_there == frames) text += "nothing was computed by this run; when these frames were made:\n";
  text += fmt::format("factors: {} pairs computed, {} taken from what was kept", all.computed, all.read);
  text += without_work == 0 ? "\n" : fmt::format("; none were computed for {}\n", counted(without_work, "frame"));
  if (defect > 0) text += fmt::format("rows sum to 1 within {:.2g} as they were computed\n", defect);
  text += fmt::format("radiosities: {:.3g} s in all, {:.3g} s at most for a frame\n", all.seconds, longest);
  text += "\nin " + folder.string() + ":";
  for (const std::string& file : files) text += " " + file;
  return text;
}

template <class Dimension, class AnyValidScene>
void animate_scene(const AnimateOptions& options, AnyValidScene scene, Streams& streams) {
  const auto frames = static_cast<std::uint32_t>(options.frames);
  const Rational per_second = rate_of(options);
  auto painter = Dimension::painter(options);
  options.elements.apply_to(scene);
  require_room_for_solving(*scene, options.memory, options.levels);
  if (!has_moving_lights(*scene))
    streams.note("no light of " + scene->file + " turns or follows a path: all frames are alike");
  require_lights_beside_surfaces(*scene, frames, per_second);
  FramesMade made;
  made.key = key_of(options, tone_asked(options.tone, Dimension::kTone), Dimension::text_of(*scene),
                    tolerance_of(options.tolerance, 1e-9));
  const std::filesystem::path directory = output_folder(options.out, options.scene);
  const OutputFolder folder(directory);
  if (FramesMade before = read_frames(directory); before.key == made.key) made = std::move(before);
  std::uint32_t were_there = 0;
  for (std::uint32_t k = 0; k < frames; ++k) were_there += made.frames.contains(k) ? 1 : 0;

  const std::uint64_t cached_bytes = memory_allowed(options.memory.value_or(0)) / 4;
  const std::shared_ptr<FactorStore> store = options.store.is_given() ? options.store.open(options.method)
                                             : is_external(options.method)
                                                 ? nullptr  // what others compute is asked for anew
                                                 : Dimension::usual_store(cached_bytes);
  using Painter = typename Dimension::Painter;
  Animation<typename Dimension::Simulation, typename Painter::Kept> animation(
      Dimension::simulation(options, std::move(scene), store), options.levels.levels(), cached_bytes, store);
  std::vector<std::string> files{"frame_00000.png", "...", "frames.csv", "animation.json"};
  const auto progress = streams.progress("frames");
  std::optional<std::uint32_t> last;  // the frame made last, by this run
  for (std::uint32_t k = 0; k < frames; ++k) {
    if (made.frames.contains(k)) continue;
    progress(static_cast<double>(k) / frames);
    const auto time_of = [&per_second](std::uint32_t frame) { return Rational(Rational(frame) / per_second); };
    const Rational time = time_of(k);
    if (!painter.is_fitted() && k > 0) painter.fit_to(animation.at(Rational(0)).simulation, {});
    if (k > 0 && last != k - 1) animation.follow(time_of(k - 1));
    const auto frame = animation.at(time);
    last = k;
    if (!painter.is_fitted()) painter.fit_to(frame.simulation, {});
    Stopwatch watch;
    OutputFile picture(directory / frame_file_name(k));
    const std::string bytes = painter.file(frame.simulation, *frame.kept, {});
    picture.write(bytes);
    const bool is_first = made.frames.empty();
    FrameLine line{to_double(time), frame.counts, watch.lap(), {}};
    line.sum = frame_sum(made.key, k, line, bytes);
    made.frames[k] = std::move(line);
    picture.finish();
    // What is there of other frames is given up with the first of these.
    if (is_first)
      write_output_file(directory / "animation.json",
                        animation_json(options.scene, made.key, to_double(per_second), frames, files));
    picture.commit();
    write_output_file(directory / "frames.csv", frames_csv(made));
  }
  if (!options.no_film) {
    write_animated_png(directory, frames, per_second);
    files.push_back("animation.png");
    if (has_program("ffmpeg")) {
      try {
        write_mp4(directory, frames, per_second);
        files.push_back("animation.mp4");
      } catch (const RequestError& error) {  // the frames and animation.png are there
        streams.note("animation.mp4 is not made: " + std::string(error.what()));
      }
    }
  }
  const std::string json = animation_json(options.scene, made.key, to_double(per_second), frames, files);
  write_output_file(directory / "animation.json", json);
  if (options.json) streams.write("", json);
  streams.note(summary(made, frames, were_there, directory, files));
  if (const auto note = note_of_frames_beyond(directory, frames)) streams.note(*note);
}

ExitCode animate(const AnimateOptions& options, Streams& streams) {
  options.levels.require_sense();
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  require_light_in_watts(scene);
  if (auto* space = std::get_if<ValidScene3>(&scene))
    animate_scene<Space>(options, std::move(*space), streams);
  else
    animate_scene<Plane>(options, std::move(std::get<ValidScene2>(scene)), streams);
  return ExitCode::kDone;
}

}  // namespace

void add_animate(Commands& commands) {
  const auto options = std::make_shared<AnimateOptions>();
  CLI::App& command = commands.add(
      "animate",
      "Lights that turn and follow paths, frame by frame\n\n"
      "Frame k is the light of the scene k / F seconds on: frame_00000.png and so on, animation.png with all of them\n"
      "(an animated PNG; animation.mp4 too where ffmpeg is installed), and frames.csv: what each took. Frames that "
      "are\n"
      "there already, of the same scene and options, are not made again.",
      {"hottel animate scenes/lights/lighthouse.json --frames 12 --fps 4 -o /tmp/lighthouse",
       "hottel animate scenes/lights/lighthouse.json --frames 4 --fps 1 --light-levels 3 -o /tmp/refined --store "
       "/tmp/lighthouse.store"},
      [options](Streams& streams) { return animate(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("--frames", options->frames, "how many frames")
      ->type_name("N")
      ->transform(whole_number(1, kMostFrames))
      ->required();
  command.add_option("--fps", options->per_second, "frames per second: a number above 0")
      ->type_name("F")
      ->capture_default_str();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option("--method", options->method,
                  "how to compute the factors between active elements, each also as METHOD:normalised" + methods_text())
      ->type_name("METHOD")
      ->capture_default_str();
  options->levels.add_to(command);
  options->elements.add_to(command);
  options->polygons.add_to(command);
  options->store.add_to(command);
  command
      .add_option("--grid", options->grid,
                  "in the plane: cells of the illumination, over the scene's first grid or its region")
      ->type_name("NXxNY");
  command
      .add_option("--tone", options->tone,
                  "linear, reinhard, log or max, fitted to the light at the time 0; without it log in the plane, "
                  "reinhard in space")
      ->type_name("TONE");
  command.add_option("--exposure", options->exposure, "multiply the light by E before the tone curve")
      ->type_name("E")
      ->check(positive_number())
      ->capture_default_str();
  command.add_option("--size", options->size, "pixels of the frames across")
      ->type_name("W")
      ->transform(whole_number(1, kMaxPictureSide));
  command
      .add_option("--shading", options->shading,
                  "in space: flat: each element has its value; smooth: values are blended over flat surfaces; "
                  "parents: the same, the finest elements by the mean of each four (--levels, --light-levels); "
                  "gathered: each point has what arrives there, by exact visibility")
      ->check(CLI::IsMember({"flat", "smooth", "parents", "gathered"}))
      ->capture_default_str();
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what each pair may be off, relative to the smaller of both areas (1e-9)")
      ->type_name("T");
  options->guarantee.add_to(command);
  command
      .add_option("--memory", options->memory,
                  "bytes that factors may take, and light in the plane; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  command.add_flag("--no-film", options->no_film, "frames only: neither animation.png nor animation.mp4");
  command.add_flag("--json", options->json, "animation.json on standard output too");
}

}  // namespace hottel
