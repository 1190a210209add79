// Exact view factors, correctly rounded.
// GUARANTEE: exact.
// REFERENCE: docs/design/plane/exchange.md.
#include "geometry/plane/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {
namespace {

class Exact2 final : public ExchangeMethod2 {
 public:
  const MethodInfo& info() const override { return info_; }
  ExchangeMatrix compute(const PreparedScene2& prepared, const ExchangeRequest& request,
                         MethodReport& report) const override {
    return exact_exchange(prepared, request, &report.counts);
  }
  std::optional<double> declared_error(const PreparedScene2&) const override { return 0; }

 private:
  MethodInfo info_{"exact", "exact", 0, Guarantee::kExact, "docs/design/plane/exchange.md"};
};

}  // namespace

MethodFamily2 exact_family_2() {
  return {.name = "exact",
          .pattern = "exact",
          .what = "free gaps between vertices, every factor correctly rounded",
          .reference = "docs/design/plane/exchange.md",
          .guarantee = Guarantee::kExact,
          .sweep = {"exact"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            if (!variant.empty()) throw UsageError("the method exact has no variants");
            return std::make_unique<Exact2>();
          }};
}

}  // namespace hottel
