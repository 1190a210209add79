#include "io/results/csv_field.h"

#include <cmath>

#include "kernel/rational.h"

namespace hottel {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_number(std::optional<double> value) { return value && !std::isnan(*value) ? shortest(*value) : ""; }

}  // namespace hottel
