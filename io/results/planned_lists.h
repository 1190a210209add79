// What lists of view factors will take of time and disk, told before anything is computed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace hottel {

// Lists of so many pairs, by `hottel factors`. Bytes are those of clutter with backs, within a factor of 1.5 as a rule.
struct PlannedLists {
  double pairs = 0;
  std::string unit;    // what is known of them: "visible pairs", "pairs at the most"
  double seconds = 0;  // to compute
  double csv_bytes = 0, mtx_bytes = 0, hdf5_bytes = 0;
  double sums_bytes = 0;  // beside the file, with --out-of-core or --checkpoint
};
// sums_bytes: of the sums of as many pairs.
PlannedLists planned_lists(double pairs, const std::string& unit, double seconds, double sums_bytes);

// A line each, under a heading.
std::string lists_text(const PlannedLists& lists);
nlohmann::ordered_json lists_object(const PlannedLists& lists);

}  // namespace hottel
