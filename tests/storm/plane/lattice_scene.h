// Scenes on a lattice so small that nearly everything coincides.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/oracle/plane/split.h"

namespace hottel::storm {

// An edge between points of the lattice {0, ..., k}^2, as integers.
struct LatticeEdge {
  long ax, ay, bx, by;
};

// A scene by its number: any number gives the same scene on every platform.
struct LatticeScene {
  std::uint64_t number = 0;
  int k = 0;
  std::vector<LatticeEdge> lattice;
  std::vector<oracle::InputSegment> edges;  // the same with materials, polylines last
  oracle::Split split;                      // of the edges
};

// Returns three to 3 + min(2 k, 12) edges whose ends are drawn from the lattice, every point being as likely, one in
// eight on the line of another; every third scene has the walls of [0, k]^2 around it, fronts inside. Materials 0, 1,
// 2, backs also none. Every second scene has fewer such edges and one to three polylines (lattice_polylines.h), and
// edges that say what is behind them. The scene is not refused. REQUIRES 1 <= k <= 100.
LatticeScene lattice_scene(std::uint64_t number, int k);

}  // namespace hottel::storm
