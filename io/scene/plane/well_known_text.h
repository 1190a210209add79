// Well-known text: its words, brackets and numbers.
#pragma once

#include <string>
#include <string_view>

#include "geometry/plane/scene/scene.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

// Returns the exact value of a coordinate as parse_rational reads it. Throws InputError.
Rational coordinate_of_2(std::string_view text, const FileLine& where);

// Reads a text from its beginning to its end. What is not as expected throws InputError with the line.
class WellKnownText2 {
 public:
  // REQUIRES texts that outlive this.
  WellKnownText2(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  // Goes to the next character that is no blank; false at the end.
  bool skip_blanks();
  // Where the next character stands.
  FileLine here() const { return {name_, line_}; }

  // The word that stands here, in capitals; empty where there is none.
  std::string word();
  // Goes past this character if it is the next one.
  bool takes(char c);
  void expect(char c);
  // True past the '(' of a list, false past EMPTY; Z, M and ZM are refused.
  bool begins();
  // A list up to its ')': one item or more, by commas. REQUIRES begins().
  template <class Read>
  void read_list(const Read& read_item) {
    do read_item();
    while (takes(','));
    expect(')');
  }
  // A number, up to a blank, a comma, a bracket or a ';'.
  Rational number();
  // Two numbers, up to a comma or a ')'.
  Point2 position();

  [[noreturn]] void refuse_here(const std::string& expected) const;

 private:
  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace hottel
