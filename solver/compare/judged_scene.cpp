#include "solver/compare/judged_scene.h"

#include "kernel/support/parallel.h"

namespace hottel {

std::vector<double> unobstructed_factors(const JudgedScene& scene, const JudgedPairs& judged) {
  constexpr std::size_t kPairsATask = 64;
  std::vector<double> result(judged.pairs().size(), 0);
  parallel_for(
      result.size(),
      [&](std::size_t k) {
        const JudgedPair& pair = judged.pairs()[k];
        if (!pair.is_off || pair.to == judged.exact().sky()) return;
        result[k] = pair.exact > 0 ? pair.exact / pair.visibility : scene.unobstructed_factor(pair.from, pair.to);
      },
      kPairsATask);
  return result;
}

}  // namespace hottel
