// What files of numbers are written with: shortest digits, and text in large pieces.
#pragma once

#include <array>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

#include "io/results/factor_table.h"

namespace hottel {

// The shortest decimal number that is read back as this double.
class Digits {
 public:
  explicit Digits(double value) : end_(std::to_chars(digits_.data(), digits_.data() + digits_.size(), value).ptr) {}
  std::string_view text() const { return {digits_.data(), end_}; }

 private:
  std::array<char, 32> digits_;
  const char* end_;
};

// Collects text and hands it on in large pieces.
class TextBuffer {
 public:
  // Hands on by itself whenever it has more than `piece` characters.
  explicit TextBuffer(const Sink& sink, std::size_t piece = 1 << 16) : sink_(&sink), piece_(piece) {}

  TextBuffer& operator<<(std::string_view text) {
    text_.append(text);
    if (text_.size() > piece_) flush();
    return *this;
  }
  TextBuffer& operator<<(char c) {
    text_ += c;
    return *this;
  }
  TextBuffer& operator<<(double value) { return *this << Digits(value).text(); }

  template <class Number>
  TextBuffer& raw(const Number& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    return *this << std::string_view(bytes, sizeof bytes);
  }

  // Hands on what is left. The memory is used again.
  void flush() {
    if (!text_.empty()) (*sink_)(text_);
    text_.clear();
  }

 private:
  const Sink* sink_;
  std::size_t piece_;
  std::string text_;
};

}  // namespace hottel
