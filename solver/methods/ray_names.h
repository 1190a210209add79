// The names of methods that shoot rays.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"
#include "solver/methods/ray_samples.h"

namespace hottel {

inline constexpr const char* kRaysPattern = "rays:N[:stratified|:sobol][:uniform][:seed=S]";

// How rays are spread over the directions before an element.
//
//   kCosine   by the cosine to the normal: what a diffuse face emits, and what view factors count
//   kUniform  evenly over all directions: a mistake that is made, here to be recognised (docs/design/verdict.md)
enum class EmissionLaw : unsigned char { kCosine, kUniform };

// The rays of a method.
struct RayOptions {
  Sampling sampling = Sampling::kIndependent;
  EmissionLaw law = EmissionLaw::kCosine;
  std::uint64_t rays = 1;  // REQUIRES 1 <= rays <= kMostRays
  std::uint64_t seed = 1;
};

// Returns what follows "rays". Throws UsageError for what is no such variant.
RayOptions ray_options(std::string_view variant);

// What a method with these rays says of itself: its name holds what differs from the defaults.
MethodInfo ray_method_info(const RayOptions& options, const std::string& reference);

// rays:64 to rays:65536, in all samplings.
std::vector<std::string> rays_sweep();

// sqrt(F (1 - F) / n) of the worst factor.
double largest_standard_error(const ExchangeMatrix& matrix, std::uint64_t rays);

}  // namespace hottel
