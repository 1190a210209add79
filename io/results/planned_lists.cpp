#include "io/results/planned_lists.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geometry/memory_text.h"

namespace hottel {

PlannedLists planned_lists(double pairs, const std::string& unit, double seconds, double sums_bytes) {
  // Both directions of a pair.
  constexpr double kCsv = 2 * 75, kMtx = 2 * 34, kHdf5 = 2 * 13;
  return {.pairs = pairs,
          .unit = unit,
          .seconds = seconds,
          .csv_bytes = pairs * kCsv,
          .mtx_bytes = pairs * kMtx,
          .hdf5_bytes = pairs * kHdf5,
          .sums_bytes = sums_bytes};
}

std::string lists_text(const PlannedLists& lists) {
  const std::string count = lists.pairs < 1e6 ? fmt::format("{:.0f}", lists.pairs) : fmt::format("{:.2g}", lists.pairs);
  std::string text = "lists of view factors\n";
  text += fmt::format("  {:<24}{:<12}{} {}\n", "computed", fmt::format("{:.2g} s", lists.seconds), count, lists.unit);
  const auto add = [&text](const char* name, double bytes, const char* what) {
    text += fmt::format("  {:<24}{:<12}{}\n", name, short_bytes(bytes), what);
  };
  add(".csv", lists.csv_bytes, "on disk");
  add(".mtx", lists.mtx_bytes, "on disk");
  add(".h5", lists.hdf5_bytes, "on disk");
  add("--out-of-core", lists.sums_bytes, "on disk beside them, while it runs");
  return text;
}

nlohmann::ordered_json lists_object(const PlannedLists& lists) {
  return {{"pairs", lists.pairs},
          {"unit", lists.unit},
          {"seconds_estimate", lists.seconds},
          {"bytes",
           {{"csv", lists.csv_bytes},
            {"mtx", lists.mtx_bytes},
            {"h5", lists.hdf5_bytes},
            {"out_of_core", lists.sums_bytes}}}};
}

}  // namespace hottel
