// The methods that the program knows, for the commands that compute by any of them.
#pragma once

#include <string>
#include <vector>

#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// The families for --help, a line each: pattern and what it is. Each line begins with a newline.
std::string methods_text(const MethodCatalogue2& methods);

// The names in lists "A,B,...", in their order, repeated ones too. What follows `run:` or `file:` after a comma and
// begins no method belongs to the command or the path. Throws UsageError for an empty name.
std::vector<std::string> method_names(const std::vector<std::string>& lists, const MethodCatalogue2& methods);

// Takes the names out that are files of radiosities (file:PATH), not of view factors, and returns their paths. Both
// keep their order. A name with :normalised is never one. Throws InputError for a file that cannot be read.
std::vector<std::string> take_radiosity_files(std::vector<std::string>& methods);

}  // namespace hottel
