#include "tests/comparison/space/pierced_pairs.h"

#include <algorithm>

#include "tests/comparison/space/pair_scene.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::oracle {

std::vector<PiercedPair3> pierced_pairs_3(std::uint64_t seed) {
  const auto polygons = piercing_triangles(seed, 3, 100, 60);
  const PairScene3 scene(polygons);
  PairRequest3 fine, proving;
  fine.tolerance = 1e-12;
  proving.tolerance = 1e-9;
  proving.proves = true;
  std::vector<PiercedPair3> result;
  for (std::size_t a = 0; a < polygons.size(); ++a)
    for (std::size_t b = a + 1; b < polygons.size(); ++b)
      for (const unsigned backs : {0U, 1U, 2U, 3U}) {
        const Patch3 i = scene.patch(a, backs % 2 == 1), j = scene.patch(b, backs > 1);
        const PairResult3 sum = scene.measure(i, j, fine);
        if (sum.measure == 0 || sum.is_whole) continue;
        result.push_back({std::min(scene.area(i), scene.area(j)), sum, scene.measure(i, j, proving)});
      }
  return result;
}

}  // namespace hottel::oracle
