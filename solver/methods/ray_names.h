// The names of methods that shoot rays.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/methods/ray_samples.h"

namespace hottel {

inline constexpr const char* kRaysPattern = "rays:N[:stratified|:sobol][:seed=S]";

// "", ":stratified" or ":sobol".
std::string sampling_suffix(Sampling sampling);

// What follows "rays".
struct RayVariant {
  Sampling sampling = Sampling::kIndependent;
  std::uint64_t rays = 1;
  std::optional<std::uint64_t> seed;
};
// Throws UsageError for what is no such variant.
RayVariant ray_variant(std::string_view variant);

// rays:64 to rays:65536, in all samplings.
std::vector<std::string> rays_sweep();

// sqrt(F (1 - F) / n) of the worst factor.
double largest_standard_error(const ExchangeMatrix& matrix, std::uint64_t rays);

}  // namespace hottel
