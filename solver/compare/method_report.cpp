#include "solver/compare/method_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/exchange_matrix.h"
#include "geometry/name.h"
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

std::string method_sentence(const MethodInfo& info, const ExchangeMatrix& matrix, const MethodReport& report) {
  std::vector<std::string> missing;
  if (report.written && !report.written->has_row.empty())
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      if (matrix.has_row(i) && report.written->has_row[i] == 0) missing.push_back(matrix.name(i));
  std::string sentence = fmt::format("view factors by {}: {}, rows sum to 1 within {:.2g}", info.name,
                                     to_string(matrix.guarantee()), report.row_defect);
  if (!missing.empty())
    sentence += fmt::format("; there {} of {}, taken to see nothing", missing.size() == 1 ? "is no row" : "are no rows",
                            listed_names(missing));
  return sentence;
}

}  // namespace hottel
