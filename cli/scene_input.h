// What commands that compute from a scene have in common: its file, its elements, names of faces.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/face.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/support/failure.h"

namespace hottel {

// --elements and --element-size: they replace what the scene says of every surface.
struct ElementOptions {
  std::optional<std::uint32_t> count;
  std::optional<std::string> size;

  void add_to(CLI::App& command);
  bool is_given() const { return count || size; }
  void apply_to(Scene2& scene) const;  // throws UsageError for a size that is no positive number
};

// The folder of an option -o: `option`, or ./STEM-hottel for a scene STEM.json. Throws UsageError for "-": results of
// several files do not go to standard output.
std::filesystem::path output_folder(const std::string& option, const std::string& scene);

// Returns what `work` returns. A RequestError of it, which knows no files, is told with the scene's file before it.
template <class Work>
auto naming_file(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const RequestError& error) {
    throw RequestError(file + ": " + error.what());
  }
}

// Throws RequestError, naming the first front, where a scene promises to be closed and a front with a material sees the
// sky. REQUIRES the exact matrix of the scene.
void require_closed(const Scene2& scene, const ExchangeMatrix& matrix);

// The largest coordinate, and one over the smallest extent, that drawings with points in doubles take.
inline constexpr double kLargestDrawn = 1e300;

// Throws RequestError, naming a surface, where a drawing that places points by doubles could not: a coordinate beyond
// their range, or a scene so far from the origin that they do not tell its points apart.
void require_drawable(const Scene2& scene);

// The grid of an option --grid, "400x300" cells over the region of the scene's own grid or else of its surfaces;
// without the option that of default_grid. Throws UsageError.
Grid2 grid_of(const Scene2& scene, const std::string& option);

// Returns the surfaces whose name, or whose polyline's name, matches: equal, or equal up to a final '*'.
// Throws UnknownName when there is none.
std::vector<std::uint32_t> surfaces_matching(const Scene2& scene, const std::string& pattern);

// The place of an element (or of the sky, matrix.sky()) by name. Throws UnknownName when there is none.
std::uint32_t require_element(const ExchangeMatrix& matrix, const std::string& name);

// One face of the scene by name, "wall" or "wall:back". Throws UnknownName when there is none.
Face face_of(const Scene2& scene, const std::string& name);

}  // namespace hottel
