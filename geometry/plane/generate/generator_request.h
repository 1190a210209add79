// What is asked of a generator of scenes.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/rational.h"

namespace hottel {

// What to generate: the kind, and what it is made from. Equal requests give equal scenes on every machine.
//
//   (1) kind is a name of generator_kinds_2(); n is from the kind's min_edges to kMaxGeneratedEdges
//   (2) digits is from 0 to kMaxGeneratedDigits; a large scene may need more digits than are asked for
//   (3) length (of clutter) is from 1/50 to 4; k (of lattice) is at most 100000
//
// What is out of range is refused by generate_2().
struct GeneratorRequest2 {
  std::string kind;
  std::uint64_t n = 100;  // number of edges; each kind says how close it comes, never above
  std::uint64_t seed = 0;
  int digits = 0;       // significant digits of every coordinate; 0: as few as the scene needs
  Rational length = 1;  // clutter: length of the segments, in mean distances between neighbours
  std::uint64_t k = 0;  // lattice: side of the lattice; 0: the square root of n, at least 4
};

}  // namespace hottel
