// The words of a text, one after another: OFF, PLY and STL files as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// Goes through a text, one word after another.
//
//   (1) lines end in LF, CR LF or CR; blanks and the ends of lines divide words
//   (2) where there are comments, they go from a '#' to the end of the line and are no words
//
// Every function throws InputError with the file and the line of the last word.
class TextWords {
 public:
  // Refuses a text that is larger than 2 GiB, has a NUL byte, or begins with a byte order mark. The text begins in line
  // `first_line` of the file. REQUIRES that the text outlives this.
  TextWords(std::string_view text, std::string file, bool has_comments, int first_line = 1);

  // The next word; nothing at the end.
  std::optional<std::string_view> next();
  // What is left of the line of the last word (at first: of the first line), without blanks around it and without its
  // comment. The next word stands in a later line.
  std::string_view rest_of_line();

  const std::string& file() const { return file_; }
  // The line of the last word.
  int line() const { return line_; }
  // The bytes after it.
  std::size_t bytes_left() const { return text_.size(); }

  // The exact value of a word, as parse_rational reads it. The subject is for messages: "coordinate".
  Rational number(std::string_view word, std::string_view subject) const;
  // The value of a word that is an integer of 64 bits.
  std::int64_t integer(std::string_view word, std::string_view subject) const;

  [[noreturn]] void refuse(const std::string& text, std::vector<std::string> hints = {}) const;

 private:
  bool is_comment(char c) const { return has_comments_ && c == '#'; }

  std::string_view text_;
  std::string file_;
  bool has_comments_;
  int line_, lines_begun_;
};

}  // namespace hottel
