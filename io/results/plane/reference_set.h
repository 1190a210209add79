// A set of reference solutions as files: scenes with their exact factors and radiosities, a manifest and checksums.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_report.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// A file of the set, whole in memory: its path from the folder, and what it holds.
struct SetFile {
  std::string path, text;
};

// One scene of the set.
struct SceneReference2 {
  std::string name;
  ExchangeReport exchange;
  std::uint64_t factors = 0;
  double max_relative_width = 0;  // of the bounds of its radiosities
  std::vector<SetFile> files;     // in a folder of its name
};

// Returns the files of one scene: scene.json (`text`, as it was given), factors.csv, factors.mtx,
// factors.mtx.faces.csv and radiosity.csv. REQUIRES the exact matrix by elements, and its solution.
SceneReference2 scene_reference(const std::string& name, std::string text, const Scene2& scene,
                                const ExchangeMatrix& matrix, const ExchangeReport& exchange,
                                const RadiositySolution& solution);

// Returns all files of a set: those of its scenes, then reference.json, README.txt, and SHA256SUMS of all before it.
//
//   (1) the same scenes in the same order give the same bytes: nothing depends on time, machine or threads
//   (2) paths are from the folder of the set, as `sha256sum -c` wants them
// COST: all texts in memory.
std::vector<SetFile> set_files(std::vector<SceneReference2> scenes);

}  // namespace hottel
