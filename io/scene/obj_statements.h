// The statements of OBJ and MTL files: a keyword and what follows it, a line each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// Goes through a text, one statement after another.
//
//   (1) lines end in LF, CR LF or CR; a backslash at the end of a line joins the next one to it
//   (2) empty lines are no statements, nor are comments: from a '#' that begins a line or follows a blank to the end of
//       the line
//   (3) blanks before, between and after words do not count
//
// Every function throws InputError with the file and the line of the statement.
class ObjStatements {
 public:
  // Refuses a text that is larger than 2 GiB, has a NUL byte, or begins with a byte order mark. REQUIRES that the text
  // outlives this.
  ObjStatements(std::string_view text, std::string file);

  // Goes to the next statement; false at the end. What was told of the one before is gone.
  bool next();

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  std::string_view keyword() const { return keyword_; }
  // All that follows the keyword.
  std::string_view rest() const { return rest_; }
  // The same with its comment, as it is typed but for blanks around it.
  std::string_view raw_rest() const { return raw_rest_; }
  // The words that follow the keyword.
  std::vector<std::string_view> words() const;

  // The exact value of a word, as parse_rational reads it. The subject is for messages: "Kd".
  Rational number(std::string_view word, std::string_view subject) const;

  [[noreturn]] void refuse(const std::string& text, std::vector<std::string> hints = {}) const;

 private:
  // A line of the text with its comment, and its part without.
  struct Line {
    std::string_view raw, statement;
  };
  Line next_line();

  std::string_view text_;
  std::string file_;
  std::string joined_, raw_joined_;  // a statement of several lines
  std::string_view keyword_, rest_, raw_rest_;
  int line_ = 0, lines_read_ = 0;
};

}  // namespace hottel
