#include "solver/radiosity/radiosity_options.h"

#include <array>

namespace hottel {
namespace {

constexpr std::array<const char*, 8> kSolvers{"auto",     "cholesky", "cg",           "lu",
                                              "bicgstab", "jacobi",   "gauss-seidel", "shooting"};
constexpr std::array<const char*, 3> kLightTests = {"exact", "centroid", "vertices"};

}  // namespace

const char* to_string(Solver solver) { return kSolvers[static_cast<std::size_t>(solver)]; }

std::optional<Solver> solver_named(std::string_view name) {
  for (std::size_t k = 0; k < kSolvers.size(); ++k)
    if (name == kSolvers[k]) return static_cast<Solver>(k);
  return std::nullopt;
}

const char* to_string(LightTest test) { return kLightTests[static_cast<std::size_t>(test)]; }

std::optional<LightTest> light_test(std::string_view word) {
  for (std::size_t k = 0; k < kLightTests.size(); ++k)
    if (word == kLightTests[k]) return static_cast<LightTest>(k);
  return std::nullopt;
}

}  // namespace hottel
