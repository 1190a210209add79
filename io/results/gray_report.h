// What is said of gray-body exchange factors, script-F.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "geometry/exchange_matrix.h"

namespace hottel {

struct GrayReport {
  std::string channel;  // "all", "r", "g", "b", "thermal"
  std::uint64_t pairs = 0;
  Guarantee guarantee = Guarantee::kEnclosed;
  double max_relative_width = 0;  // of enclosed ones
  double seconds = 0;
};

// Returns the report of a matrix of script-F.
GrayReport gray_report(const ExchangeMatrix& gray, std::string channel, double seconds);

// Returns `script_f` of a report: the channel and what is proven.
nlohmann::ordered_json gray_json(const GrayReport& report);

// Returns a line without a newline.
std::string gray_text(const GrayReport& report);

}  // namespace hottel
