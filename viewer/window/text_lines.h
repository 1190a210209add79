// Texts for a terminal as lines of a panel.
#pragma once

#include <string>
#include <vector>

namespace hottel {

std::vector<std::string> lines_of(const std::string& text);

// Returns a line with its columns set apart by tabs, where they were by blanks, as for letters of one width. Blanks
// before the first stay.
std::string with_tabs(const std::string& line);

}  // namespace hottel
