// What computing view factors in space came to, as JSON and as text for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/exchange/exchange_report.h"
#include "io/results/gray_report.h"
#include "io/results/solve_report.h"
#include "io/results/store_report.h"
#include "kernel/enclosure.h"

namespace hottel {

// Everything that is said about one run of `factors` in space.
struct FactorsReport3 {
  std::string scene, method = "exact";
  Granularity granularity = Granularity::kFace;
  double tolerance = 1e-9;
  Guarantee guarantee = Guarantee::kEstimated;  // of the matrix: the weakest there is
  ExchangeReport3 counts;
  std::vector<std::string> notes;      // of a method that is not exact
  std::optional<GrayReport> gray{};    // where script-F was asked for
  std::optional<StoreReport> store{};  // where factors were kept
};

// What a solution says of the factors it rests on; tiers: filter, combinatorial, exact.
FactorCounts factor_counts(const ExchangeReport3& report);

// Returns the report as one JSON object and a final newline: `counts`, `tiers` (filter, combinatorial, exact),
// `seconds`, `closure`, `sky` (by closure), `bounds`, `script_f`; of a method that is not exact what it has of them,
// and `notes`.
std::string factors_json(const FactorsReport3& report);

// Returns two lines or more, without a final newline: pairs and how close rows come to 1; what settled them, and the
// seconds; the sky by closure; script-F.
std::string factors_text(const FactorsReport3& report);

}  // namespace hottel
