// Exact view factors, correctly rounded.
// GUARANTEE: exact.
// REFERENCE: docs/design/exchange_2.md.
#include "kernel/failure.h"
#include "solver/methods/method_catalogue_2.h"

namespace hottel {
namespace {

class Exact2 final : public ExchangeMethod2 {
 public:
  const MethodInfo& info() const override { return info_; }
  ExchangeMatrix compute(const PreparedScene2& prepared, MethodReport&) const override {
    return exact_exchange(prepared, {.per = Per::kElement, .wants_visibility = false});
  }
  std::optional<double> declared_error(const PreparedScene2&) const override { return 0; }

 private:
  MethodInfo info_{"exact", "exact", 0, Guarantee::kExact, "docs/design/exchange_2.md"};
};

}  // namespace

MethodFamily exact_family_2() {
  return {.name = "exact",
          .pattern = "exact",
          .what = "free gaps between vertices, every factor correctly rounded",
          .reference = "docs/design/exchange_2.md",
          .guarantee = Guarantee::kExact,
          .sweep = {"exact"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            if (!variant.empty()) throw UsageError("the method exact has no variants");
            return std::make_unique<Exact2>();
          }};
}

}  // namespace hottel
