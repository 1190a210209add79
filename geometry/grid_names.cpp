#include "geometry/grid_names.h"

#include <string_view>

namespace hottel {

std::string grid_name_problem(const std::string& name) {
  constexpr std::size_t kMostBytes = 100;
  if (const std::string_view problem = name_problem(name); !problem.empty()) return std::string(problem);
  if (name.size() > kMostBytes) return "must not be longer than " + std::to_string(kMostBytes) + " bytes";
  if (name.find_first_of("/\\:*?\"<>|") != std::string::npos)
    return "must not contain / \\ : * ? \" < > or |: it is part of the names of files";
  return "";
}

}  // namespace hottel
