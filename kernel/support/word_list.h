// Lists in messages.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hottel {

// "red, green or blue": before_last is " or ".
inline std::string word_list(const std::vector<std::string>& words, const std::string& before_last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? before_last : ", ") + words[k];
  return text;
}

}  // namespace hottel
