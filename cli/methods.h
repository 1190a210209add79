// The methods that the program knows, for the commands that compute by any of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "solver/method_catalogue.h"

namespace hottel {

// All families of both dimensions for --help, a line each: pattern, what it is, and the dimension where the other one
// does not have it. Each line begins with a newline.
std::string methods_text();

// The names in lists "A,B,...", in their order, repeated ones too. What follows `run:` or `file:` after a comma and
// begins no method (of `families`) belongs to the command or the path. Throws UsageError for an empty name.
std::vector<std::string> method_names(const std::vector<std::string>& lists, const std::vector<std::string>& families);

// The names of the families of a catalogue.
template <class Prepared>
std::vector<std::string> family_names(const MethodCatalogue<Prepared>& methods) {
  std::vector<std::string> names;
  for (const MethodFamily<Prepared>& family : methods.families()) names.push_back(family.name);
  return names;
}

// Takes the names out that are files of radiosities (file:PATH), not of view factors, and returns their paths. Both
// keep their order. A name with :normalised is never one. Throws InputError for a file that cannot be read.
std::vector<std::string> take_radiosity_files(std::vector<std::string>& methods);

}  // namespace hottel
