#include "solver/radiosity/radiosity_options.h"

#include <array>

namespace hottel {
namespace {

constexpr std::array<const char*, 8> kNames{"auto",     "cholesky", "cg",           "lu",
                                            "bicgstab", "jacobi",   "gauss-seidel", "shooting"};

}  // namespace

const char* to_string(Solver solver) { return kNames[static_cast<std::size_t>(solver)]; }

std::optional<Solver> solver_named(std::string_view name) {
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (name == kNames[k]) return static_cast<Solver>(k);
  return std::nullopt;
}

}  // namespace hottel
