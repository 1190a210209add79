// Factors of a scene by the methods of a catalogue that are cheap and not exact, for verdicts.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "solver/compare/judged_scene.h"
#include "solver/exchange_method.h"
#include "solver/method_catalogue.h"

namespace hottel {

// Those that other programs use as well: from centres and vertices, and with few points.
inline constexpr std::array kApproximateMethods = {"center",   "center-vis", "center-vis:inverse-square=1",
                                                   "vertices", "gauss:2",    "gauss:4"};

// What JudgedScene::approximate_factors() returns. A method that the catalogue does not have, or that cannot be run, is
// left out. COST: one run of each.
template <class Prepared>
std::vector<ApproximateFactors> approximate_factors_of(const MethodCatalogue<Prepared>& methods,
                                                       const Prepared& prepared) {
  std::vector<ApproximateFactors> all;
  for (const char* name : kApproximateMethods) {
    try {
      MethodReport report;
      all.push_back({name, methods.make(name)->compute(
                               prepared, {.granularity = Granularity::kElement, .wants_visibility = false}, report)});
    } catch (const UsageError&) {
    } catch (const RequestError&) {
    }
  }
  return all;
}

// What JudgedScene::uniform_factors() returns: Sobol rays, some four million in all.
template <class Prepared>
ExchangeMatrix uniform_factors_of(const MethodCatalogue<Prepared>& methods, const Prepared& prepared,
                                  std::uint32_t elements) {
  std::uint32_t rays = 1U << 16;
  while (rays > 1U << 10 && std::uint64_t{rays} * elements > 1U << 22) rays /= 2;
  MethodReport report;
  return methods.make("rays:" + std::to_string(rays) + ":sobol:uniform")
      ->compute(prepared, {.granularity = Granularity::kElement, .wants_visibility = false}, report);
}

}  // namespace hottel
