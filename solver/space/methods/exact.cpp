// View factors with occlusion as integrals along edges.
// GUARANTEE: each entry says: enclosed where nothing stands between, else estimated within the tolerance.
// REFERENCE: docs/design/space/pair_integrator.md.
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel {
namespace {

constexpr const char* kExactReference = "docs/design/space/pair_integrator.md";

class Exact3 final : public ExchangeMethod3 {
 public:
  const MethodInfo& info() const override { return info_; }
  ExchangeMatrix compute(const PreparedScene3& prepared, const ExchangeRequest& request,
                         MethodReport& report) const override {
    ExchangeReport3 counts;
    ExchangeMatrix matrix = exact_exchange(prepared, request, &counts);
    report.row_defect = counts.max_defect;
    report.counts.surfaces = counts.surfaces;
    report.counts.vertices = counts.vertices;
    report.counts.pieces = prepared.occluders().size();
    report.counts.elements = counts.elements;
    report.counts.pairs = counts.pairs;
    report.counts.seconds = counts.seconds;
    return matrix;
  }
  std::optional<double> declared_error(const PreparedScene3&) const override {
    return ExchangeRequest().tolerance;  // S is off by no more than this of the smaller area
  }

 private:
  MethodInfo info_{"exact", "exact", 0, Guarantee::kEstimated, kExactReference};
};

}  // namespace

MethodFamily3 exact_family_3() {
  return {.name = "exact",
          .pattern = "exact",
          .what = "integrals along edges between exact events, to the tolerance",
          .reference = kExactReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"exact"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod3> {
            if (!variant.empty()) throw UsageError("the method exact has no variants");
            return std::make_unique<Exact3>();
          }};
}

}  // namespace hottel
