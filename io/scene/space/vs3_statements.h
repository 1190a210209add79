// The statements of View3D's decks: a letter and what follows it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// Goes through a deck, one statement after another, and through the words of each.
//
//   (1) words stand between blanks, tabs and commas; what follows a '!' at the beginning of a word is a comment, as is
//       a line that begins with '/'. Lines end in LF, CR LF or CR
//   (2) a statement is a line with a word, and its letter the first of that word, whatever its case and whatever
//       follows: "End", "e" and "E" are one. Words that nobody asks for are comments
//   (3) the deck ends at a line that begins with '*', after a line whose letter is E, and at the end of the text
//
// Every function throws InputError with the file and the line it is at.
class Vs3Statements3 {
 public:
  // Refuses a text that is larger than 2 GiB, has a NUL byte, or begins with a byte order mark. REQUIRES that the text
  // outlives this.
  Vs3Statements3(std::string_view text, std::string file);

  // Goes to the next statement; false at the end.
  bool next();
  // Goes to the next line with a word, whose first word is the next one. Refuses where the deck ends: what is missing
  // is named by the subject.
  void next_line(std::string_view subject);

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  // The letter of the statement, upper case.
  char letter() const { return letter_; }
  // All that follows its first word, a comment too.
  std::string_view rest() const { return rest_; }

  // The next word; empty where the line ends.
  std::string_view word();
  // The same, refused where the line ends. The subject is for messages: "surface 3: base".
  std::string_view word(std::string_view subject);
  // The same, from the lines that follow where this one has no more.
  std::string_view word_of_lines(std::string_view subject);

  // The exact value of a word, as parse_rational reads it.
  Rational number(std::string_view word, std::string_view subject) const;
  // The value of a word of decimal digits.
  std::uint32_t count(std::string_view word, std::string_view subject) const;

  [[noreturn]] void refuse(const std::string& text, std::vector<std::string> hints = {}) const;

 private:
  bool go_to_line();

  std::string_view text_;
  std::string file_;
  std::string_view rest_;
  char letter_ = '\0';
  int line_ = 0, lines_read_ = 0;
  bool has_ended_ = false;
};

}  // namespace hottel
