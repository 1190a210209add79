// A set of reference solutions as files: scenes with their exact factors and radiosities, a manifest and checksums.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "io/results/factor_files.h"
#include "io/results/solve_report.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// A file of the set, whole in memory: its path from the folder, and what it holds.
struct SetFile {
  std::string path, text;
};

// Mean irradiance on a grid of a scene: numbers in C order by that shape, the channels last, and what is said of them,
// in illumination.npy or, where the grid has a name, illumination-NAME.npy.
struct ReferenceLight {
  std::string file;  // without .npy
  std::vector<std::size_t> shape;
  std::span<const double> values;
  std::string sidecar;
};

// What is known of a scene: its exact method's matrix by elements, and its solution.
struct SolvedScene {
  const SceneTable& scene;
  const ExchangeMatrix& matrix;
  const RadiositySolution& solution;
  FactorCounts counts;
  double max_defect = 0;                              // of sums of rows
  std::optional<double> tolerance = {};               // of factors in space
  std::function<void(const Sink&)> write_faces = {};  // factors.mtx.faces.csv
  std::vector<ReferenceLight> lights = {};            // on each grid of the scene
};

// What numbers of a scene are in, by its dimension and unit of length (docs/outputs.md).
struct ReferenceUnits {
  std::string coordinates, areas, radiosities;
};

// One scene of the set. Its radiosities are of a discrete problem: constant on each element.
struct SceneReference {
  std::string name;
  ReferenceUnits units;
  std::uint64_t unknowns = 0;  // elements with a material
  std::vector<std::string> channels;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> lights;  // files of light, and their shapes
  FactorCounts counts;
  std::uint64_t factors = 0, enclosed = 0;  // entries, and how many of them are not estimated
  Guarantee of_factors = Guarantee::kExact, of_radiosities = Guarantee::kEnclosed;
  double max_defect = 0;
  std::optional<double> tolerance;
  double max_relative_width = 0;  // of the bounds of its radiosities
  std::vector<SetFile> files;     // in a folder of its name
};

// Returns the files of one scene: scene.json (`text`), factors.csv, factors.mtx, factors.mtx.faces.csv, radiosity.csv,
// and of each light an .npy and .npy.json. units: reference_units() of it.
SceneReference scene_reference(const std::string& name, ReferenceUnits units, std::string text,
                               const SolvedScene& solved);

// Returns what numbers are in: areas and radiosities in SI where the unit of the scene is known, else by its name.
ReferenceUnits reference_units_2(const SceneTable& scene);
ReferenceUnits reference_units_3(const SceneTable& scene);

// Returns all files of a set: those of its scenes, then reference.json, README.md and LICENSE.txt (reference_pages.h),
// and SHA256SUMS of all before it.
//
//   (1) the same scenes in the same order give the same bytes: nothing depends on time, machine or threads
//   (2) paths are from the folder of the set, as `sha256sum -c` wants them
//   (3) options: what makes it again after `hottel reference DIR */scene.json`, begun by a blank where there is
//   something
// COST: all texts in memory.
std::vector<SetFile> set_files(std::vector<SceneReference> scenes, const std::string& options);

}  // namespace hottel
