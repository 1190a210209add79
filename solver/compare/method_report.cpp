#include "solver/compare/method_report.h"

#include <fmt/format.h>

namespace hottel {

std::string method_sentence(const MethodInfo& info, Guarantee of, const MethodReport& report) {
  return fmt::format("view factors by {}: {}, rows sum to 1 within {:.2g}", info.name, to_string(of),
                     report.row_defect);
}

}  // namespace hottel
