#include "solver/space/compare/verdict.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/compare/approximate_factors.h"
#include "solver/compare/judged_scene.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel {
namespace {

constexpr std::size_t kPairsATask = 64;
constexpr double kTolerance = 1e-9;

class JudgedScene3 final : public JudgedScene {
 public:
  explicit JudgedScene3(const PreparedScene3& prepared) : prepared_(prepared) {}

  const std::string& surface_name(std::uint32_t surface) const override {
    return prepared_.scene.surfaces[surface].name;
  }

  std::vector<double> unobstructed_factors(const JudgedPairs& judged) const override {
    const ElementTable3& table = *prepared_.elements(Granularity::kElement);
    std::vector<double> result(judged.pairs().size(), 0);
    parallel_for(
        result.size(),
        [&](std::size_t k) {
          const JudgedPair& pair = judged.pairs()[k];
          if (!pair.is_off || pair.to == table.sky()) return;
          result[k] = pair.exact > 0 ? pair.exact / pair.visibility : alone(table, pair.from, pair.to);
        },
        kPairsATask);
    return result;
  }

  std::vector<ApproximateFactors> approximate_factors() const override {
    return approximate_factors_of(methods_3(), prepared_);
  }

  std::optional<ExchangeMatrix> factors_of_both_sides() const override {
    Scene3 scene = prepared_.scene;
    for (Surface& surface : scene.surfaces)
      if (!surface.back) surface.back = surface.material;
    try {
      return exact_exchange(prepare(std::move(scene)),
                            {.granularity = Granularity::kElement, .wants_visibility = false});
    } catch (const InputError&) {
      return std::nullopt;
    } catch (const RequestError&) {
      return std::nullopt;
    }
  }

 private:
  // With all other surfaces taken away.
  double alone(const ElementTable3& table, std::uint32_t from, std::uint32_t to) const {
    const Blockers3& blockers = prepared_.blockers();
    double measure = 0;
    for (const ElementTable3::Part& a : table.parts(from))
      for (const ElementTable3::Part& b : table.free_parts(to))
        if (face_each_other(blockers, a, b))
          measure += unobstructed_measure(blockers.vertices(), a.patch, b.patch, kTolerance).measure;
    return measure / table.extent(from).value;
  }

  const PreparedScene3& prepared_;
};

}  // namespace

Verdict judge(const PreparedScene3& prepared, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options) {
  return judge(JudgedScene3(prepared), exact, matrix, options);
}

}  // namespace hottel
