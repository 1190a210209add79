#include "python/bindings/words.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace hottel::python {
namespace {

// What is called otherwise here.
constexpr std::pair<std::string_view, std::string_view> kPhrases[] = {
    {"'hottel check' says where, and its --fix joins them", "check() of the scene says where, and fixed() joins them"},
    {"--fix OUT --within D", "fixed(within=D)"},
    {"--fix OUT", "fixed()"},
    {"--no-bottoms", "bottoms=False"},
};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

bool is_in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_'; }

// Whether an option begins there: two dashes that no word stands before, and a letter.
bool is_option(std::string_view text, std::size_t at) {
  return text.substr(at, 2) == "--" && at + 2 < text.size() &&
         std::islower(static_cast<unsigned char>(text[at + 2])) != 0 && (at == 0 || !is_in_word(text[at - 1]));
}

}  // namespace

std::string in_python(std::string sentence) {
  for (const auto& [what, by] : kPhrases) replace_all(sentence, what, by);
  std::string result;
  for (std::size_t at = 0; at < sentence.size();) {
    if (sentence.compare(at, 7, "hottel ") == 0) {  // a command
      const std::size_t end = std::min(sentence.find_first_of("`'", at), sentence.size());
      result.append(sentence, at, end - at);
      at = end;
    } else if (is_option(sentence, at)) {
      for (at += 2; at < sentence.size() && is_in_word(sentence[at]); ++at)
        result += sentence[at] == '-' ? '_' : sentence[at];
    } else {
      result += sentence[at++];
    }
  }
  return result;
}

}  // namespace hottel::python
