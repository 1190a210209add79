// Counts, times and checks of a computation of view factors in space.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "geometry/exchange_report.h"
#include "kernel/tier.h"

namespace hottel {

// How the numbers came about.
//
//   (1) pairs: unordered pairs of elements that exchange light, those with the sky among them; enclosed of them have
//       bounds within the tolerance, the others are estimated
//   (2) hidden, clear, mixed: unordered pairs of patches by how they were settled (PairVisibility3). At least one patch
//       of a pair has a row, and the two are not of one surface; the sky has six patches
//   (3) maps, pieces, nodes: the work along edges; signs: what settled the signs. proof, where enclosures were asked
//       for:
//         parts      parts of pieces that were enclosed
//         halvings   how often one was halved
//         redone     parts that were done again with more digits
//         failures   parts that are bounded only by what can be seen at most
//         narrowed   pairs whose bounds became narrower by the bounds of other pairs in their rows
//   (4) max_error: the largest estimated error of a pair over its smaller area; max_defect: the largest |row sum - 1|
//   (5) seconds: "prepare", "label", "pairs", "visibility", "matrix"
struct ExchangeReport3 {
  std::uint64_t surfaces = 0, vertices = 0, elements = 0;
  std::uint64_t pairs = 0, enclosed = 0;
  std::uint64_t hidden = 0, clear = 0, mixed = 0;
  std::uint64_t maps = 0, pieces = 0, nodes = 0;
  SignCounts signs;
  struct Proof {
    std::uint64_t parts = 0, halvings = 0, redone = 0, failures = 0, narrowed = 0;
  } proof;
  double max_error = 0, max_defect = 0;
  std::optional<SkyByClosure> sky;        // where it is told by closure
  std::map<std::string, double> seconds;  // of stages that ran
};

}  // namespace hottel
