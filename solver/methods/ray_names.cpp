#include "solver/methods/ray_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::array<const char*, 3> kSamplings{"", ":stratified", ":sobol"};

[[noreturn]] void refuse(std::string_view variant) {
  throw UsageError("rays" + std::string(variant) + ": expected rays:N, rays:N:stratified or rays:N:sobol, 1 <= N <= " +
                   std::to_string(kMostRays) + ", and perhaps :uniform and :seed=S, in this order");
}

}  // namespace

RayOptions ray_options(std::string_view variant) {
  RayOptions result;
  const auto number = [variant](std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) refuse(variant);
    return value;
  };
  if (variant.empty()) refuse(variant);
  std::string_view rest = variant.substr(1);
  const auto next_word = [&rest] {
    const std::string_view word = rest.substr(0, rest.find(':'));
    rest = word.size() == rest.size() ? std::string_view() : rest.substr(word.size() + 1);
    return word;
  };
  result.rays = number(next_word());
  if (result.rays < 1 || result.rays > kMostRays) refuse(variant);
  if (rest.starts_with("stratified") || rest.starts_with("sobol")) {
    const std::string_view word = next_word();
    if (word != "stratified" && word != "sobol") refuse(variant);
    result.sampling = word == "sobol" ? Sampling::kSobol : Sampling::kStratified;
  }
  if (rest.starts_with("uniform")) {
    if (next_word() != "uniform") refuse(variant);
    result.law = EmissionLaw::kUniform;
  }
  if (rest.starts_with("seed=")) result.seed = number(next_word().substr(5));
  if (!rest.empty() || variant.ends_with(':')) refuse(variant);
  return result;
}

MethodInfo ray_method_info(const RayOptions& options, const std::string& reference) {
  const std::string kind = std::string(kSamplings[static_cast<std::size_t>(options.sampling)]) +
                           (options.law == EmissionLaw::kUniform ? ":uniform" : "");
  MethodInfo info{.name = fmt::format("rays:{}{}", options.rays, kind),
                  .family = "rays" + kind,
                  .parameter = static_cast<double>(options.rays),
                  .guarantee = Guarantee::kEstimated,
                  .reference = reference};
  if (options.seed != RayOptions().seed) info.name += fmt::format(":seed={}", options.seed);
  return info;
}

std::vector<std::string> rays_sweep() {
  std::vector<std::string> sweep;
  for (const char* sampling : kSamplings)
    for (const int rays : {64, 256, 1024, 4096, 16384, 65536})
      sweep.push_back(fmt::format("rays:{}{}", rays, sampling));
  return sweep;
}

double largest_standard_error(const ExchangeMatrix& matrix, std::uint64_t rays) {
  double variance = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      variance = std::max(variance, entry.factor.value * (1 - entry.factor.value) / static_cast<double>(rays));
  return std::sqrt(variance);
}

}  // namespace hottel
