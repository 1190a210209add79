#include "io/scene/xml_references.h"

#include <algorithm>
#include <array>

namespace hottel {
namespace {

constexpr std::size_t kMostShown = 40;

bool is_name_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (byte >= '0' && byte <= '9') || ((byte | 0x20) >= 'a' && (byte | 0x20) <= 'z') ||
         std::string_view("_:.-").find(c) != std::string_view::npos;
}

// What stands after an &, up to the semicolon; empty when there is no reference.
std::string_view reference_at(std::string_view after) {
  std::size_t end = !after.empty() && after.front() == '#' ? 1 : 0;
  while (end < after.size() && is_name_character(after[end])) ++end;
  return end < after.size() && after[end] == ';' ? after.substr(0, end) : std::string_view();
}

bool is_resolved(std::string_view reference) {
  constexpr std::array<std::string_view, 5> kPredefined{"amp", "lt", "gt", "quot", "apos"};
  if (std::find(kPredefined.begin(), kPredefined.end(), reference) != kPredefined.end()) return true;
  if (reference.size() < 2 || reference.front() != '#') return false;
  const bool is_hexadecimal = reference[1] == 'x';
  const std::string_view digits = reference.substr(is_hexadecimal ? 2 : 1);
  return !digits.empty() &&
         digits.find_first_not_of(is_hexadecimal ? "0123456789abcdefABCDEF" : "0123456789") == std::string_view::npos;
}

// The place behind `end`, searched from `begin` on; the end of the text when it does not come.
std::size_t behind(std::string_view xml, std::size_t begin, std::string_view end) {
  const std::size_t at = xml.find(end, begin);
  return at == std::string_view::npos ? xml.size() : at + end.size();
}

// Goes through a document type declaration; `at` comes to stand behind it.
std::optional<XmlProblem> problem_of_doctype(std::string_view xml, std::size_t& at) {
  bool is_in_subset = false;
  while (at < xml.size()) {
    const std::string_view rest = xml.substr(at);
    const char c = rest.front();
    if (rest.starts_with("<!--")) {
      at = behind(xml, at, "-->");
    } else if (rest.starts_with("<?")) {
      at = behind(xml, at, "?>");
    } else if (rest.starts_with("<!ATTLIST")) {
      return XmlProblem{at, "declares a list of attributes (<!ATTLIST>), whose values would not be read"};
    } else if (c == '"' || c == '\'') {
      at = behind(xml, at + 1, rest.substr(0, 1));
    } else if (c == '%') {
      return XmlProblem{at, "declares a parameter entity, which is not resolved"};
    } else {
      ++at;
      if (c == '[') is_in_subset = true;
      if (c == ']') is_in_subset = false;
      if (c == '>' && !is_in_subset) return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<XmlProblem> unresolved_reference(std::string_view xml) {
  std::size_t at = 0;
  while ((at = xml.find_first_of("<&", at)) != std::string_view::npos) {
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(xml, at, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(xml, at, "]]>");
    } else if (rest.starts_with("<?")) {
      at = behind(xml, at, "?>");
    } else if (rest.starts_with("<!DOCTYPE")) {
      if (auto problem = problem_of_doctype(xml, at)) return problem;
    } else if (rest.front() == '&') {
      const std::string_view reference = reference_at(rest.substr(1));
      if (reference.empty()) return XmlProblem{at, "has an & that begins no reference; it is written &amp;"};
      if (!is_resolved(reference))
        return XmlProblem{at, "uses the entity &" + std::string(reference.substr(0, kMostShown)) +
                                  ";, which is not resolved: write out what it stands for"};
      ++at;
    } else {
      ++at;
    }
  }
  return std::nullopt;
}

}  // namespace hottel
