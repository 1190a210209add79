// What view modes are called, compute and say in either dimension.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/compare/method_result.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// The view mode of a word, by the words of all modes in their order; nothing for other words.
template <class Mode, std::size_t N>
std::optional<Mode> mode_of(std::string_view word, const std::array<const char*, N>& words) {
  for (std::size_t k = 0; k < N; ++k)
    if (word == words[k]) return static_cast<Mode>(k);
  return std::nullopt;
}

// What is said of an approximate method against the exact one: its name and its errors.
std::vector<std::string> error_lines(const MethodResult& found);

// A solver that is shown sweep by sweep has made so many at the end.
inline constexpr int kMostSweeps = 50;

// What is said of a solution after so many sweeps, and the number to copy: its residual.
struct SweepTexts {
  std::vector<std::string> lines;
  std::string number;
};
SweepTexts sweep_texts(Solver solver, int sweeps, const RadiositySolution& radiosities);

// Waits, so that ten sweeps a second are shown. Throws Interrupted where the thread is stopped.
void wait_between_sweeps();

}  // namespace hottel
