// What the styles of a drawing do to its lines beyond painting them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hottel {

// Why a drawing cannot be read as it is styled, and where this stands.
struct StyleProblem {
  std::size_t offset = 0;  // in the text that was looked at
  std::string text;        // the end of a sentence whose subject is the element
};

// Where a property stands. kViewport: in the style attribute of the outermost <svg>, whose size scales nothing.
enum class StylePlace { kAttribute, kStyle, kViewport };

// Returns why one property with this value cannot be read; nothing for those that only paint.
//
//   (1) refused are properties that hide or cut (display, visibility, clip-path, mask, filter, ...), move (transform,
//       translate, rotate, scale, zoom, offset, ...) or resize (width, height, x, y, cx, cy, r, rx, ry, d), with any
//       value but the one that does nothing
//   (2) in an attribute of their own, only those that SVG knows there: width and the like are geometry that is read
//   (3) names are compared without regard to case and -webkit-, -moz-, -ms- and -o-
std::optional<std::string> property_problem(std::string_view name, std::string_view value, StylePlace place);

// Returns the first problem of a style attribute, "stroke: red; width: 3".
std::optional<StyleProblem> style_problem(std::string_view declarations, StylePlace place);

// Returns the first problem of a style sheet, at any depth of nesting; @import is one, too. Whom a rule selects is not
// looked at: it may be anything.
std::optional<StyleProblem> style_sheet_problem(std::string_view sheet);

// Returns the text without blanks (those of CSS and XML) at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace hottel
