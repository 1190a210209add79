#include "io/scene/plane/well_known_text.h"

#include <algorithm>
#include <cctype>

#include "geometry/name.h"

namespace hottel {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

bool is_letter_of_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

Rational coordinate_of_2(std::string_view text, const FileLine& where) {
  if (const auto value = parse_rational(text)) return *value;
  throw InputError(where, "a coordinate is not a number: " + quoted_name(text),
                   {"numbers are written like 12, -0.1, 2.5e-3 or 4/3, with an exponent of at most " +
                    std::to_string(kMaxNumberExponent)});
}

bool WellKnownText2::skip_blanks() {
  for (; at_ < text_.size() && kBlanks.find(text_[at_]) != std::string_view::npos; ++at_)
    if (text_[at_] == '\n') ++line_;
  return at_ < text_.size();
}

void WellKnownText2::refuse_here(const std::string& expected) const {
  const std::string found =
      at_ < text_.size() ? quoted_name(text_.substr(at_, text_.find_first_of(" \t\r\n", at_ + 1) - at_)) : "the end";
  throw InputError(here(), expected + " is expected, not " + found);
}

std::string WellKnownText2::word() {
  skip_blanks();
  std::string result;
  for (; at_ < text_.size() && is_letter_of_word(text_[at_]); ++at_)
    result += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_])));
  return result;
}

std::string WellKnownText2::geometry() {
  std::string result = word();
  for (const char dimension : {'M', 'Z'})
    if (result.size() > 1 && result.back() == dimension) result.pop_back();
  return result;
}

bool WellKnownText2::takes(char c) {
  if (!skip_blanks() || text_[at_] != c) return false;
  ++at_;
  return true;
}

void WellKnownText2::expect(char c) {
  if (!takes(c)) refuse_here(std::string("'") + c + "'");
}

bool WellKnownText2::begins() {
  skip_blanks();
  if (at_ < text_.size() && is_letter_of_word(text_[at_])) {
    const FileLine where = here();
    const std::string found = word();
    if (found == "EMPTY") return false;
    if (found == "Z" || found == "M" || found == "ZM") {
      if (!skip_blanks()) throw InputError(where, "'(' or EMPTY is expected, not the end");
      return begins();
    }
    throw InputError(where, "'(' or EMPTY is expected, not " + quoted_name(found));
  }
  expect('(');
  return true;
}

Point2 WellKnownText2::position() {
  Point2 point;
  point.x = number();
  point.y = number();
  const auto ends = [this] { return !skip_blanks() || text_[at_] == ')' || text_[at_] == ','; };
  if (ends()) return point;
  const FileLine where = here();
  for (std::size_t count = 2; !ends(); ++count) {
    if (count == kMostCoordinates)
      throw InputError(here(), "a position has more than " + std::to_string(kMostCoordinates) + " coordinates");
    number();
  }
  passed_over_.add(PassedKind::kThirdCoordinate, where);
  return point;
}

Point2 WellKnownText2::wrapped_position() {
  const bool is_wrapped = takes('(');
  Point2 point = position();
  if (is_wrapped) expect(')');
  return point;
}

Rational WellKnownText2::number() {
  if (!skip_blanks()) refuse_here("a coordinate");
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n,();", at_), text_.size());
  if (end == at_) refuse_here("a coordinate");
  const std::string_view token = text_.substr(at_, end - at_);
  at_ = end;
  return coordinate_of_2(token, here());
}

}  // namespace hottel
