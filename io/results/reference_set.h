// A set of reference solutions as files: scenes with their exact factors and radiosities, a manifest and checksums.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
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

// What is known of a scene: its exact method's matrix by elements, and its solution.
struct SolvedScene {
  const SceneTable& scene;
  const ExchangeMatrix& matrix;
  const RadiositySolution& solution;
  FactorCounts counts;
  double max_defect = 0;                              // of sums of rows
  std::optional<double> tolerance = {};               // of factors in space
  std::function<void(const Sink&)> write_faces = {};  // factors.mtx.faces.csv
};

// One scene of the set.
struct SceneReference {
  std::string name;
  FactorCounts counts;
  std::uint64_t factors = 0, enclosed = 0;  // entries, and how many of them are not estimated
  Guarantee of_factors = Guarantee::kExact, of_radiosities = Guarantee::kEnclosed;
  double max_defect = 0;
  std::optional<double> tolerance;
  double max_relative_width = 0;  // of the bounds of its radiosities
  std::vector<SetFile> files;     // in a folder of its name
};

// Returns the files of one scene: scene.json (`text`), factors.csv, factors.mtx, factors.mtx.faces.csv and
// radiosity.csv.
SceneReference scene_reference(const std::string& name, std::string text, const SolvedScene& solved);

// Returns all files of a set: those of its scenes, then reference.json, README.txt, and SHA256SUMS of all before it.
//
//   (1) the same scenes in the same order give the same bytes: nothing depends on time, machine or threads
//   (2) paths are from the folder of the set, as `sha256sum -c` wants them
// COST: all texts in memory.
std::vector<SetFile> set_files(std::vector<SceneReference> scenes);

}  // namespace hottel
