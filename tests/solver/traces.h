// Everything that a computation came to, bit for bit, or why it came to nothing.
#pragma once

#include <bit>
#include <cstdint>
#include <exception>
#include <string>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

class Traces {
 public:
  template <class Work>
  void add(const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      text_ += std::string("failed: ") + error.what() + "\n";
    }
  }
  void add_number(double value) { text_ += std::to_string(std::bit_cast<std::uint64_t>(value)) + " "; }
  void add_text(const std::string& text) { text_ += text + "\n"; }
  void add_matrix(const ExchangeMatrix& matrix) {
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      add_text(matrix.elements()[i].name);
      for (const FactorEntry& entry : matrix.row(i)) {
        add_number(entry.to);
        add_number(entry.factor.value);
      }
    }
  }
  void add_solution(const RadiositySolution& solution) {
    for (const ChannelSolution& channel : solution.channels)
      for (const ElementRadiosity& element : channel.elements)
        for (const double value : {element.radiosity, element.lower, element.upper, element.irradiance,
                                   element.net_value, element.net_lower, element.net_upper})
          add_number(value);
    for (const std::string& note : solution.notes) add_text(note);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace hottel
