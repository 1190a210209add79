#include "geometry/plane/generate/generators.h"

#include <string>

#include "geometry/plane/generate/generate_kinds.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Generate = Scene2 (*)(const GeneratorRequest2&);

struct Entry {
  GeneratorKind2 kind;
  Generate generate;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries = {
      {{"room", "rooms with doorways between them, each furnished with turned rectangles",
        "the largest multiple of 4 that is at most N", 8},
       generate_room_2},
      {{"clutter", "random disjoint segments inside a closed square room; half of them with a material on the back",
        "exactly N, 4 of them the walls", 5},
       generate_clutter_2},
      {{"lattice", "random edges between points of an integer lattice: crossings, T-junctions, overlaps, neighbours",
        "exactly N, 4 of them the walls", 5},
       generate_lattice_2},
      {{"maze", "a perfect maze of unit walls, closed", "at most N, by less than the square root of N fewer", 9},
       generate_maze_2},
      {{"comb", "one closed polygon: a corridor with deep slots along one side",
        "the largest multiple of 4 that is at most N", 4},
       generate_comb_2},
      {{"star", "one closed polygon with a spike at every other vertex, star-shaped about its centre", "exactly N", 4},
       generate_star_2},
      {{"pillars", "a closed square hall with round pillars (12-gons with vertices exactly on a circle)",
        "4 + 12 p, the largest such number that is at most N", 16},
       generate_pillars_2},
      {{"plates", "parallel plates above each other under an open sky, both sides with a material", "exactly N", 2},
       generate_plates_2},
  };
  return kEntries;
}

}  // namespace

const std::vector<GeneratorKind2>& generator_kinds_2() {
  static const std::vector<GeneratorKind2> kKinds = [] {
    std::vector<GeneratorKind2> kinds;
    for (const Entry& entry : entries()) kinds.push_back(entry.kind);
    return kinds;
  }();
  return kKinds;
}

Scene2 generate_2(const GeneratorRequest2& request) {
  if (request.digits < 0 || request.digits > kMaxGeneratedDigits)
    throw UsageError("--digits must be at most " + std::to_string(kMaxGeneratedDigits));
  std::string names;
  for (const Entry& entry : entries()) {
    if (entry.kind.name != request.kind) {
      names += (names.empty() ? "" : ", ") + entry.kind.name;
      continue;
    }
    if (request.n < entry.kind.min_edges || request.n > kMaxGeneratedEdges) {
      throw UsageError("--n must be between " + std::to_string(entry.kind.min_edges) + " and " +
                       std::to_string(kMaxGeneratedEdges) + " for " + request.kind);
    }
    return entry.generate(request);
  }
  throw UsageError("unknown kind of scene: " + request.kind + " (there are " + names + ")");
}

}  // namespace hottel
