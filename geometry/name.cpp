#include "geometry/name.h"

#include <cstdint>

namespace hottel {
namespace {

struct Character {
  std::size_t bytes = 0;  // 0: ill-formed
  std::uint32_t code = 0;
};

// The first character of a text that is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kSmallest[bytes] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {bytes, code};
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code <= 0x9F); }

}  // namespace

std::string_view name_problem(std::string_view name) {
  if (name.empty()) return "must not be empty";
  if (name == "sky") return "is kept for the sky";
  if (name.ends_with(":back")) return "must not end in ':back'";
  for (std::string_view rest = name; !rest.empty();) {
    const Character c = first_character(rest);
    if (c.bytes == 0) return "is not well-formed UTF-8";
    if (c.code == '#') return "must not contain '#'";
    if (is_control(c.code)) return "must not contain a control character";
    rest.remove_prefix(c.bytes);
  }
  return {};
}

std::string piece_name(const std::string& name, std::size_t k) { return name + "[" + std::to_string(k) + "]"; }

bool has_control_character(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    if (c.bytes == 0 || is_control(c.code)) return true;
    text.remove_prefix(c.bytes);
  }
  return false;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    if (c.bytes == 0) return false;
    text.remove_prefix(c.bytes);
  }
  return true;
}

std::string quoted_name(std::string_view name) {
  constexpr std::size_t kHead = 40, kTail = 16;  // characters kept of a long name
  std::string result = "'";
  std::size_t count = 0, cut = 0;    // characters so far; length of the result after kHead of them
  std::size_t ends[kTail + 1] = {};  // where the latest characters begin in the result, as a ring
  for (std::string_view rest = name; !rest.empty(); ++count) {
    if (count == kHead) cut = result.size();
    ends[count % (kTail + 1)] = result.size();
    const Character c = first_character(rest);
    const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
    if (c.bytes == 0 || is_control(c.code)) {
      for (std::size_t i = 0; i < bytes; ++i) {
        const auto byte = static_cast<unsigned char>(rest[i]);
        result += "\\x";
        result += "0123456789ABCDEF"[byte >> 4];
        result += "0123456789ABCDEF"[byte & 15];
      }
    } else {
      result += rest.substr(0, bytes);
    }
    rest.remove_prefix(bytes);
  }
  if (count > kHead + kTail + 3) {
    const std::string tail = result.substr(ends[(count - kTail) % (kTail + 1)]);
    result.resize(cut);
    result += "..." + tail;
  }
  return result + "'";
}

std::string listed_names(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t k = 0; k < names.size() && k < kMost; ++k) text += (k == 0 ? "" : ", ") + quoted_name(names[k]);
  return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
}

}  // namespace hottel
