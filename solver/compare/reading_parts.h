// What readings that compose have in common: orders of the indices, constants, and the words for several at once.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/compare/hypotheses.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/named_factors.h"

namespace hottel {

// What stands at (i, j) is the factor of (i, j) or of (j, i), times A_i^p A_j^q.
struct Orientation {
  bool is_transposed;
  int from_power, to_power;
  const char* words;

  bool is_as_it_should_be() const { return !is_transposed && from_power == 0 && to_power == 0; }
  int price() const { return is_as_it_should_be() ? 0 : is_transposed ? 1 : 2; }
  // A_i^p A_j^q.
  double multiple(double from_area, double to_area) const {
    const auto power = [](double a, int exponent) { return exponent == 0 ? 1 : exponent > 0 ? a : 1 / a; };
    return power(from_area, from_power) * power(to_area, to_power);
  }
};
inline constexpr std::array kOrientations = {
    Orientation{false, 0, 0, ""},
    Orientation{true, 0, 0, "the matrix is transposed: F(j, i) stands for F(i, j)"},
    Orientation{false, 1, 0, "these are direct exchange areas A F, not divided by the area of the face"},
    Orientation{false, -1, 0, "factors are divided by the area of the face once too often"},
    Orientation{false, 0, -1, "the area of the other face is left out"},
    Orientation{false, 0, 1, "factors are multiplied by the area of the other face once too often"},
    Orientation{false, -1, 1, "factors are multiplied by A_j/A_i"},
};

// A constant by which all factors are multiplied, and its name if it has one.
struct Ratio {
  double value = 1;
  std::string name;

  int price() const { return value == 1 ? 0 : name.empty() ? 2 : 1; }
};

// Returns the constant with a name that is next to a ratio, within a part `near` of it; nothing where there is none.
inline std::optional<Ratio> named_ratio(double ratio, double near) {
  std::optional<Ratio> best;
  for (const NamedFactor& named : kNamedFactors)
    if (std::abs(ratio / named.value - 1) < near &&
        (!best || std::abs(ratio - named.value) < std::abs(ratio - best->value)))
      best = Ratio{named.value, named.words};
  return best;
}

// Which pairs of a frame, the numbers of a file as they would be but for some faults, are still wrong: off, and not
// explained there.
class LeftWrong {
 public:
  // explains: by place in frame.pairs().
  LeftWrong(const JudgedPairs& frame, const std::vector<char>& explains)
      : columns_(frame.exact().size() + std::size_t{1}), is_wrong_(frame.exact().size() * columns_, 0) {
    for (const JudgedPair& pair : frame.pairs())
      is_wrong_[place(pair.from, pair.to)] = static_cast<char>(pair.is_off && explains[frame.index_of(pair)] == 0);
  }
  bool at(std::uint32_t from, std::uint32_t to) const { return is_wrong_[place(from, to)] != 0; }

 private:
  std::size_t place(std::uint32_t from, std::uint32_t to) const { return from * columns_ + to; }

  std::size_t columns_;  // the sky last
  std::vector<char> is_wrong_;
};

// The faults that a reading is made of, in words.
class ToldParts {
 public:
  void add(Fault fault, std::string words) {
    faults_.push_back(fault);
    words_.push_back(std::move(words));
  }
  // Nothing where it is as it should be.
  void add(const Orientation& orientation) {
    if (!orientation.is_as_it_should_be())
      add(orientation.is_transposed ? Fault::kTransposed : Fault::kAreas, orientation.words);
  }
  void add(const Ratio& ratio) {
    if (ratio.value != 1)
      add(Fault::kConstantFactor,
          "all are times " + (ratio.name.empty() ? fmt::format("{:.6g}", ratio.value) : ratio.name));
  }
  // Fills fault, parts and words. REQUIRES one part or more.
  void tell(Hypothesis& result) const {
    result.fault = faults_.front();
    result.parts = faults_;
    result.words = words_.size() > 1 ? fmt::format("{} faults at once: ", words_.size()) : "";
    for (std::size_t k = 0; k < words_.size(); ++k) result.words += (k == 0 ? "" : "; ") + words_[k];
  }

 private:
  std::vector<Fault> faults_;
  std::vector<std::string> words_;
};

}  // namespace hottel
