// The constants by which results of other programs are off.
#pragma once

#include <array>
#include <numbers>

namespace hottel {

// A ratio that a mistake is known to leave between what was written and what is right.
struct NamedFactor {
  double value;
  const char* words;  // "2 pi"
};

// The ratios written / exact that have a name: other conventions (half or whole angles, areas doubled), percent, a
// sign, and pi taken as 3.14. Of two that explain equally many numbers the earlier one is named.
inline constexpr std::array kNamedFactors = {
    NamedFactor{2, "2"},
    NamedFactor{0.5, "1/2"},
    NamedFactor{std::numbers::pi, "pi"},
    NamedFactor{1 / std::numbers::pi, "1/pi"},
    NamedFactor{std::numbers::pi / 2, "pi/2"},
    NamedFactor{2 / std::numbers::pi, "2/pi"},
    NamedFactor{2 * std::numbers::pi, "2 pi"},
    NamedFactor{1 / (2 * std::numbers::pi), "1/(2 pi)"},
    NamedFactor{4 * std::numbers::pi, "4 pi"},
    NamedFactor{1 / (4 * std::numbers::pi), "1/(4 pi)"},
    NamedFactor{std::numbers::pi / 4, "pi/4"},
    NamedFactor{4 / std::numbers::pi, "4/pi"},
    NamedFactor{4, "4"},
    NamedFactor{0.25, "1/4"},
    NamedFactor{3.14 / std::numbers::pi, "3.14/pi (pi taken as 3.14)"},
    NamedFactor{std::numbers::pi / 3.14, "pi/3.14 (pi taken as 3.14)"},
    NamedFactor{100, "100 (percent)"},
    NamedFactor{-1, "-1 (the sign)"},
};

}  // namespace hottel
