// What a surface may be called.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Returns why `name` may not be the name of a surface, polyline or group, as the end of a sentence ("must not contain
// '#'"); empty when it may be.
//
//   (1) a name is well-formed UTF-8, not empty, and has no control character (U+0000-U+001F, U+007F-U+009F)
//   (2) it is not "sky", has no '#' and does not end in ":back": those spell the sky, elements and backs of surfaces
std::string_view name_problem(std::string_view name);

// Returns the name of piece k of a polyline, or of face k of a mesh: "room[0]", "room[1]", ...
std::string piece_name(const std::string& name, std::size_t k);

// True iff `text` has a control character (name_problem (1)) or is not well-formed UTF-8.
bool has_control_character(std::string_view text);

// True iff `text` is well-formed UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool is_utf8(std::string_view text);

// Returns the name between single quotes, fit for a message of one line.
//
//   (1) each byte of a control character and each ill-formed byte is spelled as \x1F
//   (2) of a name of more than 59 characters the first 40 and the last 16 are kept, with "..." between them
std::string quoted_name(std::string_view name);

// Returns names for a message, each as quoted_name: all of up to three, else "'a', 'b', 'c' and 4 more".
std::string listed_names(const std::vector<std::string>& names);

}  // namespace hottel
