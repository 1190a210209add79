// What is asked of a generator of scenes in space.
#pragma once

#include <cstdint>
#include <string>

namespace hottel {

// What to generate: the kind, and what it is made from. Equal requests give equal scenes on every machine.
//
//   (1) kind is a name of generator_kinds_3(); n is from the kind's min_n to kMaxGeneratedBodies
//   (2) has_bottoms is true but for kinds that have boxes standing on something (GeneratorKind3::stands)
//
// What is out of range is refused by generate_3().
struct GeneratorRequest3 {
  std::string kind;
  std::uint64_t n = 100;  // number of bodies or polygons: each kind says of what, and how close it comes
  std::uint64_t seed = 0;
  bool has_bottoms = true;  // false: boxes have no face where they stand on something
};

}  // namespace hottel
