#include "io/scene/svg_style.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "geometry/name.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

struct Property {
  std::string_view name;
  std::array<std::string_view, 2> harmless{};  // values that do nothing
  bool is_attribute = false;                   // also known as an attribute of its own
};
constexpr std::array<Property, 30> kProperties{{
    {"display", {"inline", "block"}, true},
    {"visibility", {"visible"}, true},
    {"clip-path", {"none"}, true},
    {"clip", {"auto"}, true},
    {"mask", {"none"}, true},
    {"mask-image", {"none"}, false},
    {"filter", {"none"}, true},
    {"content-visibility", {"visible"}, false},
    {"vector-effect", {"none", "non-scaling-stroke"}, true},
    {"transform", {}, false},  // the attribute is applied
    {"transform-origin", {}, true},
    {"transform-box", {}, true},
    {"translate", {"none"}, false},
    {"rotate", {"none"}, false},
    {"scale", {"none"}, false},
    {"zoom", {"1", "normal"}, false},
    {"offset", {}, false},
    {"offset-path", {"none"}, true},
    {"motion-path", {"none"}, false},
    {"width", {}, false},
    {"height", {}, false},
    {"x", {}, false},
    {"y", {}, false},
    {"cx", {}, false},
    {"cy", {}, false},
    {"r", {}, false},
    {"rx", {}, false},
    {"ry", {}, false},
    {"d", {}, false},
    {"all", {}, false},
}};

std::string plain_name(std::string_view name) {
  std::string plain(name);
  std::transform(plain.begin(), plain.end(), plain.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view vendor : {"-webkit-", "-moz-", "-ms-", "-o-"})
    if (plain.starts_with(vendor)) return plain.substr(vendor.size());
  return plain;
}

// The text with blanks in place of comments, line by line as long as before.
std::string without_comments(std::string_view text) {
  std::string result(text);
  for (std::size_t at = 0; (at = result.find("/*", at)) != std::string::npos;) {
    const std::size_t close = result.find("*/", at + 2);
    const std::size_t end = close == std::string::npos ? result.size() : close + 2;
    for (; at < end; ++at)
      if (result[at] != '\n') result[at] = ' ';
  }
  return result;
}

// Splits style sheets and style attributes at ; { } outside of strings and brackets, and looks at the declarations.
class StyleScanner {
 public:
  StyleScanner(std::string_view text, StylePlace place, bool is_sheet)
      : text_(without_comments(text)), place_(place), is_sheet_(is_sheet) {}

  std::optional<StyleProblem> scan() {
    std::size_t begin = 0, brackets = 0;
    for (std::size_t at = 0; at <= text_.size(); ++at) {
      const char c = at < text_.size() ? text_[at] : ';';
      if (at < text_.size() && (c == '"' || c == '\'')) {
        at = end_of_string(at);
        continue;
      }
      if (c == '\\') {
        ++at;
        continue;
      }
      if (c == '(' || c == '[') ++brackets;
      if ((c == ')' || c == ']') && brackets > 0) --brackets;
      const bool is_end = c == '}' || at == text_.size();
      if (brackets > 0 && !is_end) continue;
      if (c != ';' && c != '{' && c != '}') continue;
      const std::string_view part = std::string_view(text_).substr(begin, at - begin);
      if (auto problem = c == '{' ? problem_of_prelude(part) : problem_of(part)) {
        problem->offset = begin + part.find(trimmed(part));
        return problem;
      }
      if (c == '{') selectors_.emplace_back(trimmed(part));
      if (c == '}' && !selectors_.empty()) selectors_.pop_back();
      begin = at + 1;
      brackets = 0;
    }
    return std::nullopt;
  }

 private:
  std::size_t end_of_string(std::size_t at) const {
    const char quote = text_[at++];
    while (at < text_.size() && text_[at] != quote && text_[at] != '\n') at += text_[at] == '\\' ? 2 : 1;
    return std::min(at, text_.size() - 1);
  }

  static std::optional<StyleProblem> problem_of_prelude(std::string_view part) {
    part = trimmed(part);
    if (part.starts_with('@') && part.find('\\') != std::string_view::npos)
      return StyleProblem{0, "has an escaped character in " + quoted_name(part) + ", which is not read"};
    return std::nullopt;
  }

  // Of "name: value", or of a rule like @import that ends with a semicolon.
  std::optional<StyleProblem> problem_of(std::string_view part) const {
    part = trimmed(part);
    if (auto problem = problem_of_prelude(part)) return problem;
    if (plain_name(part.substr(0, 7)) == "@import") return StyleProblem{0, "imports another style sheet"};
    const auto colon = part.find(':');
    if (colon == std::string_view::npos || (is_sheet_ && selectors_.empty())) return std::nullopt;
    const std::string_view name = trimmed(part.substr(0, colon));
    if (name.find('\\') != std::string_view::npos)
      return StyleProblem{0, "has an escaped character in " + quoted_name(name) + ", which is not read"};
    const auto problem = property_problem(name, trimmed(part.substr(colon + 1)), place_);
    if (!problem) return std::nullopt;
    return StyleProblem{0, selectors_.empty() ? *problem : "for " + quoted_name(selectors_.back()) + " " + *problem};
  }

  const std::string text_;
  const StylePlace place_;
  const bool is_sheet_;
  std::vector<std::string> selectors_;  // of the blocks that are open
};

}  // namespace

std::string_view trimmed(std::string_view text) { return trimmed(text, " \t\n\r\f"); }

std::optional<std::string> property_problem(std::string_view name, std::string_view value, StylePlace place) {
  const std::string plain = plain_name(name);
  const auto property =
      std::find_if(kProperties.begin(), kProperties.end(), [&](const Property& each) { return each.name == plain; });
  if (property == kProperties.end() || (place == StylePlace::kAttribute && !property->is_attribute))
    return std::nullopt;
  if (place == StylePlace::kViewport && (plain == "width" || plain == "height")) return std::nullopt;
  if (const auto mark = value.find('!'); mark != std::string_view::npos) value = trimmed(value.substr(0, mark));
  for (const std::string_view harmless : property->harmless)
    if (!harmless.empty() && plain_name(value) == harmless) return std::nullopt;
  return "has " + std::string(name) + " " + quoted_name(value) + ", which a scene cannot express";
}

std::optional<StyleProblem> style_problem(std::string_view declarations, StylePlace place) {
  return StyleScanner(declarations, place, false).scan();
}

std::optional<StyleProblem> style_sheet_problem(std::string_view sheet) {
  return StyleScanner(sheet, StylePlace::kStyle, true).scan();
}

}  // namespace hottel
