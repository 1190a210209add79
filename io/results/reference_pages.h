// What a set of reference solutions says of itself: what its files hold, how it is checked, cited and used.
#pragma once

#include <string>

namespace hottel {

// Returns README.md of a set: what it is, files and columns with their units, how to make it again, to check it, to
// compare a solver of one's own, licence, citation. command: what makes the set again, in its folder.
std::string reference_readme(const std::string& command);

// Returns LICENSE.txt of a set: CC0-1.0 for what hottel computed.
std::string reference_licence();

}  // namespace hottel
