// What computing view factors came to, as JSON and as text for people.
#pragma once

#include <optional>
#include <string>

#include "geometry/element.h"
#include "io/results/gray_report.h"
#include "io/results/store_report.h"
#include "solver/compare/method_report.h"

namespace hottel {

// Everything that is said about one run of `factors`.
struct FactorsReport {
  std::string scene, method;
  Granularity granularity = Granularity::kFace;
  MethodReport of_method{};
  std::optional<GrayReport> gray{};    // where script-F was asked for
  std::optional<StoreReport> store{};  // where factors were kept

  bool is_exact() const { return method == "exact"; }
};

// Returns the report as one JSON object and a final newline. `notes` and `script_f` are there only where there
// is something to say.
std::string factors_json(const FactorsReport& report);

// Returns a line or more, without a final newline: pairs and seconds; of the exact method also which arithmetic settled
// how many factors, of others their notes.
std::string factors_text(const FactorsReport& report);

}  // namespace hottel
