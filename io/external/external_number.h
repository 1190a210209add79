// Numbers of another program's text, and how finely it wrote them.
#pragma once

#include <string>
#include <string_view>

#include "solver/compare/method_report.h"

namespace hottel {

// Reads decimal numbers of one file and keeps count of their digits, so that in the end it is known how far a number
// may be from what was meant (WrittenDigits).
class ExternalNumbers {
 public:
  explicit ExternalNumbers(std::string file) : file_(std::move(file)) {}

  // Returns the double nearest to the number, 0 where it is too small for one; a "+" before it and blanks
  // around it are allowed.
  // Throws InputError for what is no finite decimal number, or is too large for a double. The text is read
  // alike in every locale.
  double read(std::string_view token, int line);

  // Returns a whole number from `least` to `most`. Throws InputError for anything else; `what` begins the message.
  std::uint32_t read_count(std::string_view token, std::uint64_t least, std::uint64_t most, const std::string& what,
                           int line) const;

  // The most decimals and significant digits of all numbers that were read, one significant digit at least. An exponent
  // moves the point first: "0.01230e-2" has 7 decimals and 4 significant digits.
  WrittenDigits digits() const { return {decimals_, significant_, 0}; }

 private:
  std::string file_;
  int decimals_ = 0, significant_ = 1;
};

// Words of a text, separated by blanks, tabs and line ends (LF or CR LF), with the line each is on.
// REQUIRES that the text outlives it, and the words it gave.
class ExternalWords {
 public:
  explicit ExternalWords(std::string_view text, int line = 1) : text_(text), line_(line) {}

  // Moves to the next word; false at the end, where word() is empty.
  bool next();
  // Returns the rest of the line, without its LF, and moves to the beginning of the next one.
  std::string_view rest_of_line();

  std::string_view word() const { return word_; }
  int line() const { return line_; }

 private:
  std::string_view text_, word_;
  int line_;
};

}  // namespace hottel
