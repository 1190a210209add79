// Methods of a catalogue that compute the factor of each pair by itself, for verdicts.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "solver/compare/judged_scene.h"
#include "solver/exchange_method.h"
#include "solver/method_catalogue.h"

namespace hottel {

// Centres, corners and few points, each pair of which is a segment that something meets or nothing does.
inline constexpr std::array kPairwiseMethods = {"center", "vertices", "gauss:2", "gauss:4"};

// Those of them that the catalogue has. REQUIRES that the scene outlives what is returned.
template <class Prepared>
std::vector<PairwiseMethod> pairwise_methods_of(const MethodCatalogue<Prepared>& methods, const Prepared& prepared) {
  std::vector<PairwiseMethod> all;
  for (const char* const name : kPairwiseMethods) {
    const std::shared_ptr<const ExchangeMethod<Prepared>> method = methods.make(name);
    all.push_back({name, [method, factor = method->factors_of_pairs(prepared)](std::uint32_t from, std::uint32_t to) {
                     return factor(from, to);
                   }});
  }
  return all;
}

// What JudgedScene::uniform_factors() returns.
template <class Prepared>
ExchangeMatrix uniform_factors_of(const MethodCatalogue<Prepared>& methods, const Prepared& prepared,
                                  std::uint32_t rays) {
  MethodReport report;
  return methods.make("rays:" + std::to_string(rays) + ":sobol:uniform")
      ->compute(prepared, {.granularity = Granularity::kElement, .wants_visibility = false}, report);
}

}  // namespace hottel
