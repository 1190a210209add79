// Text without blanks around it.
#pragma once

#include <algorithm>
#include <string_view>

namespace hottel {

// Returns the text without any of `blanks` at both ends; formats differ in what a blank is. Of blanks alone the empty
// end remains.
inline std::string_view trimmed(std::string_view text, std::string_view blanks) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace hottel
