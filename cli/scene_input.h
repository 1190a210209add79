// What commands that compute from a scene have in common: options for its elements and its grid, its file in messages.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "kernel/support/failure.h"

namespace hottel {

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
};

// The folder of an option -o: `option`, or ./STEM-hottel for a scene STEM.json, wherever that scene lies. Throws
// UsageError for "-": results of several files do not go to standard output.
std::filesystem::path output_folder(const std::string& option, const std::string& scene);

// Two numbers from 1 to `most` with an x between them, "400x300". Throws UsageError, naming the option and its
// pattern, for anything else.
std::array<std::uint32_t, 2> two_numbers(const std::string& option, const std::string& pattern, const std::string& text,
                                         std::uint32_t most);

// The grid of an option --grid, "400x300" cells over the region of the scene's own grid or else of its surfaces;
// without the option that of default_grid. Throws UsageError for anything but two numbers from 1 to kMaxGridCells.
Grid2 grid_of(const Scene2& scene, const std::string& option);

}  // namespace hottel
