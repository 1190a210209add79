#include "solver/radiosity/radiosity_options.h"

#include <array>

namespace hottel {
namespace {

constexpr std::array<const char*, 8> kSolvers{"auto",     "cholesky", "cg",           "lu",
                                              "bicgstab", "jacobi",   "gauss-seidel", "shooting"};
constexpr std::array<const char*, 3> kLightTests{"exact", "centroid", "vertices"};

// What a word stands for, by its place in a list.
template <class Value, std::size_t kCount>
std::optional<Value> value_named(const std::array<const char*, kCount>& names, std::string_view name) {
  for (std::size_t k = 0; k < kCount; ++k)
    if (name == names[k]) return static_cast<Value>(k);
  return std::nullopt;
}

}  // namespace

const char* to_string(Solver solver) { return kSolvers[static_cast<std::size_t>(solver)]; }

std::optional<Solver> solver_named(std::string_view name) { return value_named<Solver>(kSolvers, name); }

const char* to_string(LightTest test) { return kLightTests[static_cast<std::size_t>(test)]; }

std::optional<LightTest> light_test(std::string_view word) { return value_named<LightTest>(kLightTests, word); }

}  // namespace hottel
