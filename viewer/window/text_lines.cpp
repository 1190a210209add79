#include "viewer/window/text_lines.h"

#include <algorithm>
#include <sstream>

namespace hottel {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string with_tabs(const std::string& line) {
  std::string text;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const std::size_t end = std::min(line.find_first_not_of(' ', k), line.size());
    if (end > k + 1 && !text.empty()) {
      if (end < line.size()) text += '\t';
      k = end - 1;
    } else if (end <= k || !text.empty()) {
      text += line[k];
    }
  }
  return text;
}

}  // namespace hottel
