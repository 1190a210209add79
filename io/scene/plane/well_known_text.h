// Well-known text: its words, brackets and numbers.
#pragma once

#include <string>
#include <string_view>

#include "geometry/plane/scene/scene.h"
#include "io/scene/passed_over.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

// Returns the exact value of a coordinate as parse_rational reads it. Throws InputError.
Rational coordinate_of_2(std::string_view text, const FileLine& where);

// The most numbers of a position: x, y, a height and a measure.
inline constexpr std::size_t kMostCoordinates = 4;

// Reads a text from its beginning to its end. What is not as expected throws InputError with the line. Positions of
// more than two coordinates are counted, and these passed over.
class WellKnownText2 {
 public:
  // REQUIRES texts that outlive this.
  WellKnownText2(std::string_view text, const std::string& name, PassedOver& passed_over)
      : text_(text), name_(name), passed_over_(passed_over) {}

  // Goes to the next character that is no blank; false at the end.
  bool skip_blanks();
  // Where the next character stands.
  FileLine here() const { return {name_, line_}; }

  // The word that stands here, in capitals; empty where there is none.
  std::string word();
  // The same without Z, M or ZM at its end: what kind of geometry begins here.
  std::string geometry();
  // Goes past this character if it is the next one.
  bool takes(char c);
  void expect(char c);
  // True past the '(' of a list, false past EMPTY; Z, M or ZM may stand before.
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
  // Two numbers or more, up to a comma or a ')'.
  Point2 position();
  // That, perhaps in brackets of its own.
  Point2 wrapped_position();

  [[noreturn]] void refuse_here(const std::string& expected) const;

 private:
  std::string_view text_;
  const std::string& name_;
  PassedOver& passed_over_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace hottel
