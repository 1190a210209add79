// Scenes made to order: seeded, of any size, the same on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/generate/generator_request.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/rational.h"

namespace hottel {

// A kind of scene, as help tells of it.
struct GeneratorKind2 {
  std::string name;
  std::string description;  // one line
  std::string count;        // how many edges come out for --n N, one line
  std::uint64_t min_edges;
};

// The kinds, in the order in which help lists them.
const std::vector<GeneratorKind2>& generator_kinds_2();

// clutter --view short|long as a length: segments as long as they are apart see their neighbours, segments a fifth of
// that see some hundred others.
inline const Rational kShortView = 1;
inline const Rational kLongView{1, 5};

inline constexpr std::uint64_t kMaxGeneratedEdges = 10'000'000;
inline constexpr int kMaxGeneratedDigits = 18;

// Returns the scene of that kind.
//
//   (1) the same request gives the same scene, on every platform: integers and std::mt19937_64 decide, no floating
//       point and no library distribution
//   (2) edges of every kind but "lattice" touch in shared end points only; decided exactly
//   (3) every kind but "plates" is closed: no front with a material sees the sky
//   (4) "lattice" is full of crossings, T-junctions, collinear neighbours and overlaps; one material, so that no two
//       claims on an overlapped piece differ
//   (5) with digits = D every coordinate has D significant digits (lattice: at most D), and (2) to (4) still hold: the
//       added digits stay below the gaps of the scene; those of a lattice are an exact similarity, which keeps every
//       coincidence
//   (6) n and the seed decide the number of edges, as GeneratorKind2::count says; something always emits
//
// Throws UsageError for an unknown kind or a request out of range. COST: O(n) and a few hundred bytes an edge.
Scene2 generate_2(const GeneratorRequest2& request);

}  // namespace hottel
