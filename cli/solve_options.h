// The options of hottel solve: what both dimensions have in common.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "cli/guarantee_option.h"
#include "cli/level_options.h"
#include "cli/scene_input.h"
#include "cli/sky_option.h"
#include "cli/store_option.h"
#include "cli/sums_option.h"
#include "io/files/output_file.h"
#include "io/results/solve_report.h"
#include "solver/radiosity/radiosity_options.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

struct SolveOptions {
  std::string scene, out;
  std::string method = "exact", solver = "auto", simulate = "auto";
  std::optional<int> iterations;
  std::optional<double> until;
  std::string lights = "exact";
  std::string grid, illumination = "point", views;
  std::optional<std::string> tone;  // nothing: that of the dimension
  double exposure = 1;
  std::uint32_t size = 0;
  std::string show = "light", channel, bar, shading = "flat", render, texels;
  int contours = 0;
  bool axes = false;
  bool outlines = false, no_outlines = false;
  bool no_picture = false, no_illumination = false, exr = false;
  std::optional<std::string> tolerance;  // in space
  GuaranteeOption guarantee;
  std::optional<std::uint64_t> memory;
  ElementOptions elements;
  LevelOptions levels;
  PolygonOptions polygons;
  StoreOption store;
  SumsOption sums;
  SkyOption sky;
  std::optional<int> digits;  // of csv
  bool json = false;
};

// How radiosities are to be solved for. With --iterations or --until, auto is a solver that iterates: cg, or bicgstab
// where rows need not be symmetric. Throws UnknownName for a name that no solver has, UsageError where a direct one is
// to iterate.
RadiosityOptions system_asked(const SolveOptions& options, bool has_symmetric_rows);

// How the scene's lights fall on elements. Throws UsageError where it is asked of a scene that has none.
LightTest light_test_of(const SolveOptions& options, const SceneTable& scene);

// The tone curve of an option --tone, or the usual one. Throws UnknownName for a name that none has.
Tone tone_asked(const std::optional<std::string>& name, Tone usual);

// Throws RequestError where light on so many cells needs more memory or disk than there is. advice: what to do about
// it, besides --no-illumination.
// its_cells: the cells in words, "4 x 3".
void require_room_for_light(const SolveOptions& options, const std::string& its_cells, std::uint64_t cells,
                            int channels, const std::string& advice, const std::filesystem::path& directory);

// What the picture shows, as --show, --channel and --bar ask for it. Throws UsageError for what is not there, and for
// options of light (--tone, --exposure) where something else is shown; and, for --render, unless its file
// is a picture.
Shown shown_of(const SolveOptions& options);

// Whether there is a picture: without light one of what --show has on faces.
bool wants_picture(const SolveOptions& options, const Shown& shown);

// Whether --render asks for an array of the light of pixels; and for their light as an array or an OpenEXR file, before
// any tone curve.
bool renders_array(const SolveOptions& options);
bool renders_numbers(const SolveOptions& options);

// The range of what a picture shows, for a report. grid: the name of the grid whose picture it is, where that has one.
PictureRange range_of(const ShownValues& shown, const std::string& grid = "");

}  // namespace hottel
