// Numbers that a user types into one line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/material.h"
#include "kernel/rational.h"

namespace hottel {

// What was typed, or why it cannot be taken: one of the two. The problem is a sentence without a full stop.
template <class T>
struct Typed {
  std::optional<T> value;
  std::string problem;
};

// Reads exact numbers (Number) apart from each other by blanks, commas or semicolons: "1, 2/3", "0.1 0.2".
//
//   (1) a comma or semicolon stands between two numbers, not before the first, after the last or twice
//   (2) nothing typed is no number: the list is empty
Typed<std::vector<Rational>> typed_numbers(std::string_view text);

// Reads a spectrum: "0.5" for all channels, or "1 0.9 0.8". Refuses what spectrum_problem refuses.
Typed<Spectrum> typed_spectrum(std::string_view text, SpectrumKind kind);

}  // namespace hottel
