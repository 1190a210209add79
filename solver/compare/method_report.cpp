#include "solver/compare/method_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/plain_functions.h"

namespace hottel {

double WrittenDigits::rounding(double value) const {
  if (significant == 0) return relative * std::abs(value);
  constexpr int kFewest = 3;  // nobody prints fewer; "0.5" alone does not mean 0.45 to 0.55
  double unit = same_bits::pow(10.0, -std::max(decimals, kFewest));
  if (value != 0) {
    const double first = std::floor(same_bits::log10(std::abs(value))) + 1;
    unit = std::max(unit, same_bits::pow(10.0, first - std::max(significant, kFewest)));
  }
  return 0.5 * unit;
}

std::string method_sentence(const MethodInfo& info, Guarantee of, const MethodReport& report) {
  return fmt::format("view factors by {}: {}, rows sum to 1 within {:.2g}", info.name, to_string(of),
                     report.row_defect);
}

}  // namespace hottel
