#include "solver/radiosity/light_test.h"

#include <array>

namespace hottel {
namespace {

constexpr std::array<const char*, 3> kWords = {"exact", "centroid", "vertices"};

}  // namespace

const char* to_string(LightTest test) { return kWords[static_cast<std::size_t>(test)]; }

std::optional<LightTest> light_test(std::string_view word) {
  for (std::size_t k = 0; k < kWords.size(); ++k)
    if (word == kWords[k]) return static_cast<LightTest>(k);
  return std::nullopt;
}

}  // namespace hottel
