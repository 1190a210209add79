// hottel solve: its options, and what of them makes no sense in either dimension.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "cli/command.h"
#include "cli/methods.h"
#include "cli/scene_input.h"
#include "cli/solve_in_plane.h"
#include "cli/solve_in_space.h"
#include "cli/solve_options.h"
#include "cli/unit_notes.h"
#include "cli/views.h"
#include "io/results/exr.h"
#include "io/results/short_digits.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "viewer/picture/picture_options.h"

namespace hottel {
namespace {

// Without light there is a picture of what --show has on faces, and none of the light.
void require_picture_of_faces(const SolveOptions& options, const Shown& shown) {
  if (!options.no_illumination || !shown.is_light()) return;
  const SolveOptions usual;
  for (const auto& [is_given, option] : {std::pair(options.size != usual.size, "--size"),
                                         {options.axes, "--axes"},
                                         {!options.channel.empty(), "--channel"},
                                         {!options.bar.empty(), "--bar"},
                                         {options.shading != usual.shading, "--shading"},
                                         {!options.render.empty(), "--render"}})
    if (is_given)
      throw UsageError(std::string(option) +
                       " excludes --no-illumination: without light there is a picture with --show of something else");
}

// What is on disk is one exact matrix, whose rows are read one after the other.
void require_sense_of_sums(const SolveOptions& options) {
  if (!options.sums.is_given()) return;
  const bool is_fit = options.solver == "auto" || options.solver == "cg";
  if (options.method != "exact" || !is_fit || options.store.is_given() || options.levels.levels().is_any())
    throw UsageError(std::string(options.sums.name()) +
                     " is for the method exact with --solver auto or cg, without --store and --levels");
}

// What can be said of options before the scene is read, of either dimension.
void require_sense(const SolveOptions& options) {
  options.levels.require_sense();
  system_asked(options, options.method == "exact");
  tone_asked(options.tone, kUsualTone2);
  if (options.exr) require_exr("--exr");
  if (options.memory && options.method != "exact")
    throw UsageError("--memory is kept to by the method exact only, not by " + options.method);
  if (options.no_illumination && options.simulate == "everything")
    throw UsageError("--simulate everything and --no-illumination exclude each other");
  if (!options.views.empty()) require_sense_of_views(options.views, options.illumination);
  require_sense_of_sums(options);
  require_picture_of_faces(options, shown_of(options));
  output_folder(options.out, options.scene);
}

// Nothing ends on faces where no light is listed.
void note_levels_without_lights(const SolveOptions& options, const ValidScene& scene, Streams& streams) {
  const bool has_lights = std::visit([](const auto& its) { return !its->lights.empty(); }, scene);
  if (options.levels.at_borders > 0 && !has_lights)
    streams.note("--light-levels changes nothing: " + options.scene + " lists no lights");
}

ExitCode solve(const SolveOptions& options, Streams& streams) {
  require_sense(options);
  Stopwatch watch;
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams);
  const double seconds_to_read = watch.lap();
  require_light_in_watts(scene);
  note_unknown_unit(scene, streams);
  note_levels_without_lights(options, scene, streams);
  if (auto* space = std::get_if<ValidScene3>(&scene))
    solve_in_space(options, std::move(*space), seconds_to_read, streams);
  else
    solve_in_plane(options, std::move(std::get<ValidScene2>(scene)), seconds_to_read, streams);
  return ExitCode::kDone;
}

void add_light_options(CLI::App& command, SolveOptions& options) {
  command
      .add_option(
          "--lights", options.lights,
          "how the scene's lights fall on elements: exact; centroid: wholly where the centroid is lit; vertices: "
          "as many parts as vertices are lit. The last two are estimates, to compare with")
      ->check(CLI::IsMember({"exact", "centroid", "vertices"}))
      ->capture_default_str();
  command
      .add_option(
          "--grid", options.grid,
          "cells of the illumination: of each of the scene's grids; in the plane, where it has none, over its region")
      ->type_name("NXxNY");
  command
      .add_option(
          "--illumination", options.illumination,
          "point: mean irradiance at cell centres, exact visibility; average: its mean over each cell, in "
          "closed form with a proven bound (in space the irradiance of the cell, by view factors); inverse-square: in "
          "the plane, the source formula")
      ->check(CLI::IsMember({"point", "average", "inverse-square"}))
      ->capture_default_str();
  command
      .add_option(
          "--tone", options.tone,
          "linear, reinhard, log or max (the largest value is 1); without it log in the plane, reinhard in space")
      ->type_name("TONE");
  command.add_option("--exposure", options.exposure, "multiply the light by E before the tone curve")
      ->type_name("E")
      ->check(positive_number())
      ->capture_default_str();
  command
      .add_option(
          "--contours", options.contours,
          "lines of equal light in the picture of the plane or of a grid in space, about N of them at most, at round "
          "levels; of what --show has on a grid too")
      ->type_name("N")
      ->transform(whole_number(1, 100));
  command.add_flag(
      "--axes", options.axes,
      "coordinates along the frame of the picture, and a scale bar in the scene's unit; in space so around the "
      "grid, and below what the camera sees the axes and how far the scene reaches along each");
  CLI::Option* outlines = command.add_flag(
      "--outlines", options.outlines,
      "in space: lines where surfaces end, bend or hide others, hidden ones left out; of --show light too");
  command.add_flag("--no-outlines", options.no_outlines, "in space: no such lines, which --show has of all but light")
      ->excludes(outlines);
  CLI::Option* size =
      command.add_option("--size", options.size, "pixels of the picture across, rounded to whole pixels a cell");
  size->type_name("W")->transform(whole_number(1, kMaxPictureSide));
  CLI::Option* no_picture =
      command.add_flag("--no-picture", options.no_picture, "no illumination.png; one that is there stays as it is");
  CLI::Option* no_illumination = command.add_flag(
      "--no-illumination", options.no_illumination,
      "no light between the faces: no illumination.npy, and illumination.png with --show of faces only");
  command
      .add_option("--show", options.show,
                  "what the picture shows: light; or, on the faces in colours of a scale, " + words_to_show() +
                      ". In space a grid shows " + words_to_show_at_points() +
                      " too (of temperatures the mean radiant one), in shown.npy and its picture")
      ->type_name("WHAT")
      ->capture_default_str();
  command
      .add_option(
          "--channel", options.channel,
          "of radiosity, irradiance or net: r, g or b, without it the mean of all; solar or thermal, without it "
          "their sum")
      ->check(CLI::IsMember({"r", "g", "b", "solar", "thermal"}));
  command
      .add_option(
          "--bar", options.bar,
          "of all but light: the ends of the colour bar, each fitted to the values where it is left out, as both "
          "are without; `log`: logarithmic")
      ->type_name("LOW:HIGH[:log]");
  command
      .add_option(
          "--shading", options.shading,
          "flat: each element has its value; smooth: values are blended over flat surfaces, in the plane along "
          "faces (of --show); parents: the same, the finest elements by the mean of each four, in the plane of each "
          "two (--levels, --light-levels); gathered: in space each point has what arrives there, by exact visibility")
      ->check(CLI::IsMember({"flat", "smooth", "parents", "gathered"}))
      ->capture_default_str();
  command
      .add_option(
          "--render", options.render,
          "the picture as this file too: .png, .svg or .pdf (in space polygons, sharp at any size), .exr (linear "
          "light as floats, in the plane a pixel a cell), or in space .npy: the light of its pixels as numbers")
      ->type_name("FILE");
  command
      .add_option("--texels", options.texels,
                  "in space: texels.npy and texels.png, the gathered light of a face at the middles of NX by NY "
                  "parts, or what --show has")
      ->type_name("NAME=NXxNY");
  for (const char* of_picture : {"--size", "--tone", "--exposure", "--contours", "--axes", "--show", "--channel",
                                 "--bar", "--shading", "--render", "--outlines", "--no-outlines"})
    no_picture->excludes(command.get_option(of_picture));
  for (const char* of_light : {"--tone", "--exposure", "--contours"})
    no_illumination->excludes(command.get_option(of_light));
  command
      .add_option("--views", options.views,
                  "write what the cells see: a matrix whose product with the radiosities is the light, columns "
                  "named in FILE.mtx.faces.csv")
      ->type_name("FILE.mtx");
  command.add_flag("--exr", options.exr,
                   "light on a grid as illumination.exr too, what --show has there as shown.exr: 32-bit floats");
  for (const char* of_light : {"--grid", "--illumination", "--views", "--exr"})
    no_illumination->excludes(command.get_option(of_light));
}

}  // namespace

void add_solve(Commands& commands) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App& command = commands.add(
      "solve",
      "Radiosities of elements with proven bounds, the light in the rooms, and a picture of it\n\n"
      "In space: radiosities, net fluxes, what a camera sees (render.png), and light on the scene's grid. Bounds are "
      "of\n"
      "these elements, and of the factors as computed where some are not enclosed; what finer elements would change "
      "is\n"
      "estimated beside them.",
      {"hottel solve scenes/showcase/apartment.json -o /tmp/apartment",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --grid 64x64 --tone max --size 320",
       "hottel solve scenes/showcase/museum.json -o /tmp/museum --no-illumination",
       "hottel solve scenes/showcase/apartment.json -o /tmp/apartment --grid 32x32 --views /tmp/views.mtx",
       "hottel solve scenes/analytic/square_radiosity.json -o /tmp/square --solver jacobi --iterations 20 --json",
       "hottel solve scenes/space/cube.json -o /tmp/cube",
       "hottel solve scenes/space/cube.json -o /tmp/cube --elements 3 --show irradiance --shading smooth --render "
       "/tmp/cube.pdf"},
      [options](Streams& streams) { return solve(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("-o", options->out, "the folder to write into, created; without it ./STEM-hottel/")
      ->type_name("DIR");
  command
      .add_option("--method", options->method,
                  "how to compute the factors, each also as METHOD:normalised" + methods_text())
      ->type_name("METHOD")
      ->capture_default_str();
  command.add_option("--solver", options->solver, "auto cholesky cg lu bicgstab jacobi gauss-seidel shooting")
      ->type_name("SOLVER")
      ->capture_default_str();
  command
      .add_option("--iterations", options->iterations,
                  "stop an iterative solver (of which auto is one then) after N iterations")
      ->type_name("N")
      ->transform(whole_number(0, 1'000'000'000));
  command
      .add_option("--until", options->until, "stop it when the largest residual is below R times the largest source")
      ->type_name("R")
      ->check(number_not_below_zero());
  add_light_options(command, *options);
  command
      .add_option("--simulate", options->simulate,
                  "auto: what the scene calls for; everything: all effects, same numbers")
      ->check(CLI::IsMember({"auto", "everything"}))
      ->capture_default_str();
  options->elements.add_to(command);
  options->levels.add_to(command);
  options->polygons.add_to(command);
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what each pair may be off, relative to the smaller of both areas (1e-9)")
      ->type_name("T");
  options->guarantee.add_to(
      command, "every factor is proven, so that the bounds of radiosities are those of the true factors; ");
  options->sky.add_to(command);
  options->store.add_to(command);
  options->sums.add_to(
      command,
      "in the plane: view factors go to files in this folder while the run lasts, so that factors and radiosities keep "
      "to --memory beside the scene, however many pairs there are; the same result",
      "the same, and the files stay where the run is ended: the same command goes on from there");
  command
      .add_option("--memory", options->memory,
                  "bytes the factors may take, and light in the plane; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  command
      .add_option("--digits", options->digits,
                  "numbers of the csv files rounded to N significant digits, lower bounds down and upper bounds up")
      ->type_name("N")
      ->transform(whole_number(1, kMostDigits));
  command.add_flag("--json", options->json, "report.json on standard output too");
}

}  // namespace hottel
