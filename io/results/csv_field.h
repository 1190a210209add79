// Text in csv files.
#pragma once

#include <string>

namespace hottel {

// A field of a csv file, quoted when it holds a comma, a quote or a line break.
std::string csv_field(const std::string& text);

}  // namespace hottel
