// What is asked of a generator of scenes.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/rational.h"

namespace hottel {

// What to generate: the kind, and what it is made from. Equal requests give equal scenes on every machine
// (generate_2). The ranges allowed are those of the kind; generate_2 checks them.
struct GeneratorRequest2 {
  std::string kind;
  std::uint64_t n = 100;  // number of edges; each kind says how close it comes, never above
  std::uint64_t seed = 0;
  int digits = 0;       // significant digits of every coordinate; 0: as few as the scene needs
  Rational length = 1;  // clutter: length of the segments, in mean distances between neighbours
  std::uint64_t k = 0;  // lattice: side of the lattice; 0: the square root of n, at least 4
};

}  // namespace hottel
