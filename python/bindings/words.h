// Sentences of the library as Python says them.
#pragma once

#include <string>

namespace hottel::python {

// Returns a sentence with keyword arguments and methods where it names options of the program: "choose --channel r" is
// "choose channel r", "--light-levels" is "light_levels". Commands of the program, "hottel factors --per element", stay
// as they are, up to the quote that ends them.
std::string in_python(std::string sentence);

}  // namespace hottel::python
