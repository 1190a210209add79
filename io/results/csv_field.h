// Text in csv files.
#pragma once

#include <optional>
#include <string>

namespace hottel {

// A field of a csv file, quoted when it holds a comma, a quote or a line break.
std::string csv_field(const std::string& text);

// The shortest decimals of a number; an empty field for NaN, and for what is not known.
std::string csv_number(std::optional<double> value);

}  // namespace hottel
