#include "solver/plane/simulation/simulation_request.h"

#include <array>

namespace hottel {
namespace {

constexpr std::array kKinds{LightKind2::kPoint, LightKind2::kAverage, LightKind2::kInverseSquare};

}  // namespace

const char* to_string(LightKind2 kind) {
  constexpr std::array words{"point", "average", "inverse-square"};
  return words[static_cast<std::size_t>(kind)];
}

std::optional<LightKind2> light_kind_2(std::string_view word) {
  for (const LightKind2 kind : kKinds)
    if (word == to_string(kind)) return kind;
  return std::nullopt;
}

}  // namespace hottel
