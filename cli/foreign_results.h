// What compare says of results that were computed elsewhere.
#pragma once

#include <string>
#include <vector>

#include "solver/plane/compare/method_comparison.h"

namespace hottel {

// Takes the names out that are files of radiosities (file:PATH), not of view factors, and returns them.
std::vector<std::string> take_radiosity_files(std::vector<std::string>& methods);

// The result for such a file: max_radiosity_error and the verdict in words as notes; there are no factors and no time,
// so that all else is NaN. Throws RequestError when the scene has no exact radiosities.
MethodResult judge_radiosity_file(const std::string& name, const MethodComparison2& comparison, double beyond);

// Adds the verdict in words to the notes of a result whose factors were read from a file or came from a command.
void add_verdict(const MethodComparison2& comparison, double beyond, MethodResult& result);

}  // namespace hottel
