// What commands that compute from a scene have in common: options for its elements and its grid, its file in messages.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/streams.h"
#include "geometry/plane/scene/scene.h"
#include "geometry/space/scene/triangulator.h"
#include "io/scene/passed_over.h"
#include "io/scene/plane/map_defaults.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"

namespace hottel {

// How polygons are read. --triangulate: those in space that are not plane become triangles, instead of being refused.
// --front: those of a map are rooms, or buildings.
struct PolygonOptions {
  bool triangulates = false;
  std::string front = "inside";

  MapSide2 side() const { return front == "outside" ? MapSide2::kOutside : MapSide2::kInside; }

  // Adds both to the command line of a command. REQUIRES that this outlives the command.
  void add_to(CLI::App& command);
  // The second alone.
  void add_front_to(CLI::App& command);
  // Throws UsageError for --front outside of a file that is no map.
  void require_sense_for(const std::string& file) const;
};

// The name of a file that stands for standard input, and what messages call it.
inline constexpr const char* kStandardInput = "-";
inline constexpr const char* kStandardInputName = "standard input";

// Returns the scene of a file, or of standard input for "-", as read_scene does, and tells what of a deck of View3D is
// read otherwise than View3D does, what was passed over in a map or a mesh, and which polygons were cut into triangles.
// Throws UsageError where a scene in the plane is to have them cut, and for --front outside of what is no map. Those
// who obey what a deck asks of the output take that; else it is told that they do not.
ValidScene read_scene_noting(const std::string& file, const PolygonOptions& options, const Streams& streams,
                             DeckOutput3* output = nullptr);
// Tells what was passed over, if anything was.
void note_passed_over(const PassedOver& passed_over, const Streams& streams);
// Tells which polygons were cut, if any were.
void note_cuts(const Triangulator3& triangulator, const Streams& streams);

// --elements and --element-size: they replace what the scene says of every surface. One of them may be given.
struct ElementOptions {
  std::optional<std::uint32_t> count;
  std::optional<std::string> size;

  // Adds both options to the command line of a command. REQUIRES that this outlives the command.
  void add_to(CLI::App& command);
  bool is_given() const { return count || size; }
  // Divides every surface anew; leaves the scene as it is when neither was given. Throws UsageError also where a size
  // asks for more than kMaxElements on a surface.
  void apply_to(Scene2& scene) const;  // throws UsageError for a size that is no positive number
  // In space a number n divides a quad into n x n elements, and a size is that of the parts of the longest side.
  void apply_to(Scene3& scene) const;
  void apply_to(ValidScene2& scene) const;
  void apply_to(ValidScene3& scene) const;
};

// The folder of an option -o: `option`, or ./STEM-hottel for a scene STEM.json, wherever that scene lies
// (./stdin-hottel for standard input). Throws UsageError for "-": results of several files do not go to standard
// output.
std::filesystem::path output_folder(const std::string& option, const std::string& scene);

// Whether two names are of one file, which is there.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);
// Throws UsageError where a file that is to be written is one that is read. output, reader: what messages call them, as
// "-o x.csv" and "--points".
void require_not_read(const std::string& output, const std::filesystem::path& written, const std::string& reader,
                      const std::filesystem::path& read);

// The number of an option. Throws UsageError, naming the option, for what parse_rational does not read.
Rational number_of(const std::string& text, const std::string& option);

// The number of an option --tolerance, or what is usual. Throws UsageError unless it is a positive double.
double tolerance_of(const std::optional<std::string>& option, double usual);

// The parts of a text between commas, without blanks around them: one more than it has commas.
std::vector<std::string> parts_at_commas(const std::string& text);

// Two numbers from 1 to `most` with an x between them, "400x300". Throws UsageError, naming the option and its
// pattern, for anything else.
std::array<std::uint32_t, 2> two_numbers(const std::string& option, const std::string& pattern, const std::string& text,
                                         std::uint32_t most);

// What --texels NAME=NXxNY asks for: a face, by its name, and how many texels along its two sides.
struct TexelOption {
  std::string name;
  std::uint32_t nu = 1, nv = 1;
};
// Throws UsageError for anything else.
TexelOption texel_option(const std::string& text);

// The grids of a scene, where there is an option --grid each with "400x300" cells. Of a scene without any it is one
// over its surfaces, without the option that of default_grid. Throws UsageError for anything but two numbers from 1 to
// kMaxGridCells.
std::vector<Grid2> grids_of(const Scene2& scene, const std::string& option);
// The same in space: the scene's own grids, where there is an option the planar ones with "400x300" cells along u and
// v, or the volumes with "40x30x20". Throws UsageError where none is of the kind that the option divides, or for
// anything but two or three numbers from 1 to kMaxGridCells3.
std::vector<Grid3> grids_of(const Scene3& scene, const std::string& option);
// The cells of a grid in words, "400 x 300".
std::string cells_text(const Grid2& grid);
std::string cells_text(const Grid3& grid);
// How many cells they have together.
template <class AnyGrid>
std::uint64_t cells_of(const std::vector<AnyGrid>& grids) {
  std::uint64_t cells = 0;
  for (const AnyGrid& grid : grids) cells += grid.cells();
  return cells;
}

}  // namespace hottel
