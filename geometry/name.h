// What a surface may be called.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Returns why `name` may not be the name of a surface, polyline or group, as the end of a sentence ("must not contain
// '#'"); empty when it may. A name is well-formed UTF-8, not empty, not "sky", has no '#', no control character
// (U+0000-U+001F, U+007F-U+009F) and does not end in ":back": those spell elements, the sky and backs of surfaces.
std::string_view name_problem(std::string_view name);

// Returns true when `text` has a control character (see above) or is not well-formed UTF-8.
bool has_control_character(std::string_view text);

// Returns true when `text` is well-formed UTF-8 (no overlong forms, no surrogates, nothing beyond U+10FFFF).
bool is_utf8(std::string_view text);

// Returns the name between single quotes, fit for a message of one line: control characters and ill-formed bytes are
// spelled as \x1F, and the middle of a long name is left out.
std::string quoted_name(std::string_view name);

// Returns names for a message: "'a', 'b', 'c' and 4 more".
std::string listed_names(const std::vector<std::string>& names);

}  // namespace hottel
