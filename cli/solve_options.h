// The options of hottel solve: what both dimensions have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/scene_input.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

struct SolveOptions {
  std::string scene, out;
  std::string method = "exact", solver = "auto", simulate = "auto";
  std::optional<int> iterations;
  std::optional<double> until;
  std::string grid, illumination = "point", tone = "log", views;
  double exposure = 1;
  std::uint32_t size = 0;
  bool no_picture = false, no_illumination = false;
  std::optional<std::string> tolerance;  // in space
  std::optional<std::uint64_t> memory;
  ElementOptions elements;
  PolygonOptions polygons;
  bool json = false;
};

// The solver asked for. With --iterations or --until, auto is one that iterates: cg, or bicgstab where rows need not be
// symmetric. Throws UnknownName for a name that no solver has, UsageError where a direct one is to iterate.
Solver solver_of(const SolveOptions& options, bool has_symmetric_rows);

}  // namespace hottel
