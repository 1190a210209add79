#include "io/results/gray_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "kernel/support/counted.h"
#include "solver/radiosity/gray_exchange.h"

namespace hottel {

GrayReport gray_report(const ExchangeMatrix& gray, std::string channel, double seconds) {
  GrayReport report{std::move(channel), gray.entry_count(), gray.guarantee(), 0, seconds};
  if (report.guarantee != Guarantee::kEstimated) report.max_relative_width = max_relative_width(gray);
  return report;
}

nlohmann::ordered_json gray_json(const GrayReport& report) {
  nlohmann::ordered_json json{{"channel", report.channel}};
  if (report.guarantee == Guarantee::kEstimated)
    json["guarantee"] = to_string(report.guarantee);
  else
    json["max_relative_width"] = report.max_relative_width;
  return json;
}

std::string gray_text(const GrayReport& report) {
  if (report.pairs == 0) return "script-F of no pair: no two faces that absorb heat exchange any";
  const std::string proven =
      report.guarantee == Guarantee::kEstimated
          ? "as good as the view factors, some of which are estimated"
          : fmt::format("bounds for these elements within {:.1e} of the value", report.max_relative_width);
  return fmt::format("script-F of {}, {}; {:.3f} s", counted(report.pairs, "pair"), proven, report.seconds);
}

}  // namespace hottel
