// Text without blanks around it.
#pragma once

#include <cstddef>
#include <string_view>

namespace hottel {

// Returns the text without any of `blanks` at both ends; formats differ in what a blank is.
inline std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace hottel
