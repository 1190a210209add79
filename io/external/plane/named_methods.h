// Ways to compute view factors in the plane, by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// Returns the method of a name: "exact", "gauss:4", "hemicube:512:normalised", "file:PATH", "run:COMMAND", ... Throws
// UnknownName that lists the patterns where there is none, UsageError where what follows a colon makes no sense.
std::unique_ptr<ExchangeMethod2> method_2(const std::string& name);

// Returns what may be asked for, with letters for numbers: "gauss:n".
std::vector<std::string> method_patterns_2();

}  // namespace hottel
