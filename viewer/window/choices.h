// What the keys of a window go through.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "solver/method_catalogue.h"
#include "solver/radiosity/radiosity_options.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

inline constexpr std::array kTones{Tone::kLog, Tone::kReinhard, Tone::kLinear, Tone::kMax};
inline constexpr std::array kSolvers{Solver::kGaussSeidel, Solver::kJacobi, Solver::kShooting, Solver::kCg,
                                     Solver::kBicgstab};
inline constexpr double kExposureStep = 1.2;

// Returns the choice so many places after the one there is, around; the first where that is none of them.
template <class Choices, class T>
T next_of(const Choices& choices, const T& now, int step) {
  const auto n = static_cast<int>(std::size(choices));
  const auto found = static_cast<int>(std::find(std::begin(choices), std::end(choices), now) - std::begin(choices));
  return choices[static_cast<std::size_t>(((found == n ? 0 : found + step) + n) % n)];
}

// The approximate methods: of each family the middle one of its sweep.
template <class Prepared>
std::vector<std::string> approximate_methods(const MethodCatalogue<Prepared>& catalogue) {
  std::vector<std::string> names;
  for (const auto& family : catalogue.families())
    if (family.name != "exact" && !family.sweep.empty()) names.push_back(family.sweep[family.sweep.size() / 2]);
  return names;
}

// Takes the solver or the method so many places after that of a request, whichever its view mode is of. Returns what is
// to be said. Request: a ViewRequest of either dimension.
template <class Request, class Prepared>
std::string take_next(Request& request, const MethodCatalogue<Prepared>& catalogue, int step) {
  if (request.mode == decltype(request.mode)::kSweeps) {
    request.solver = next_of(kSolvers, request.solver, step);
    return std::string("solver ") + to_string(request.solver);
  }
  request.method = next_of(approximate_methods(catalogue), request.method, step);
  return "method " + request.method;
}

}  // namespace hottel
