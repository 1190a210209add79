#include "viewer/edit/typed_numbers.h"

#include <utility>

#include "geometry/number.h"

namespace hottel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_separator(char c) { return c == ',' || c == ';'; }

// Takes blanks, and at most one separator among them, from the front of a text; whether there was a separator.
bool take_gap(std::string_view& text) {
  bool separated = false;
  while (!text.empty() && (is_blank(text[0]) || (!separated && is_separator(text[0])))) {
    separated |= is_separator(text[0]);
    text.remove_prefix(1);
  }
  return separated;
}

std::string_view take_word(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && !is_blank(text[end]) && !is_separator(text[end])) ++end;
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

}  // namespace

Typed<std::vector<Rational>> typed_numbers(std::string_view text) {
  std::vector<Rational> numbers;
  for (;;) {
    const bool separated = take_gap(text);
    if (text.empty() && !separated) return {std::move(numbers), ""};
    const std::string_view word = take_word(text);
    if (word.empty() || (separated && numbers.empty())) return {{}, "a number is missing beside a comma or semicolon"};
    const Number number(word);
    if (!number.problem().text.empty()) return {{}, "this " + number.problem().text};
    numbers.push_back(number.value());
  }
}

Typed<Spectrum> typed_spectrum(std::string_view text, SpectrumKind kind) {
  auto [numbers, problem] = typed_numbers(text);
  if (!numbers) return {{}, std::move(problem)};
  if (numbers->size() != 1 && numbers->size() != 3)
    return {{}, "one number is needed, or three: red, green, blue; there are " + std::to_string(numbers->size())};
  Spectrum spectrum = Spectrum::scalar(numbers->front());
  if (numbers->size() == 3) spectrum = {{(*numbers)[0], (*numbers)[1], (*numbers)[2]}, false};
  if (const std::string_view wrong = spectrum_problem(spectrum, kind); !wrong.empty())
    return {{}, "it " + std::string(wrong)};
  return {std::move(spectrum), ""};
}

}  // namespace hottel
