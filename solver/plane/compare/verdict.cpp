#include "solver/plane/compare/verdict.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/compare/approximate_factors.h"
#include "solver/compare/judged_scene.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {
namespace {

constexpr std::size_t kPairsATask = 256;

class JudgedScene2 final : public JudgedScene {
 public:
  explicit JudgedScene2(const PreparedScene2& prepared) : prepared_(prepared) {}

  const std::string& surface_name(std::uint32_t surface) const override {
    return prepared_.scene.surfaces[surface].name;
  }

  std::vector<double> unobstructed_factors(const JudgedPairs& judged) const override {
    const ElementTable2& table = *prepared_.elements(Granularity::kElement);
    const PairsAlone2 alone(prepared_, table, Granularity::kElement);
    std::vector<double> result(judged.pairs().size(), 0);
    parallel_for(
        result.size(),
        [&](std::size_t k) {
          const JudgedPair& pair = judged.pairs()[k];
          if (!pair.is_off || pair.to == table.sky()) return;
          result[k] = pair.exact > 0 ? pair.exact / pair.visibility : alone.factor(pair.from, pair.to);
        },
        kPairsATask);
    return result;
  }

  std::vector<ApproximateFactors> approximate_factors() const override {
    return approximate_factors_of(methods_2(), prepared_);
  }

  std::optional<ExchangeMatrix> factors_of_both_sides() const override {
    Scene2 scene = prepared_.scene;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      Surface& surface = scene.surfaces[s];
      if (!surface.back) surface.back = surface.material;
      if (prepared_.division[s].is_cut()) continue;
      surface.elements = 1;
      surface.trees = {};
    }
    try {
      const PreparedScene2 both = prepare(std::move(scene), Divided2::kYes);
      return exact_exchange(both, {.granularity = Granularity::kElement, .wants_visibility = false});
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

 private:
  const PreparedScene2& prepared_;
};

}  // namespace

Verdict judge(const PreparedScene2& prepared, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options) {
  return judge(JudgedScene2(prepared), exact, matrix, options);
}

}  // namespace hottel
