#include "io/scene/exact_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "geometry/name.h"
#include "io/files/text_file.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// long double, so that the parser's own conversion, which we ignore, overflows beyond 1e4932 only.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

// Hands out the characters of a text and tells where the parser is.
struct Cursor {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  const char* at;
  const char** reached;

  char operator*() const { return *at; }
  Cursor& operator++() { return *reached = ++at, *this; }
  bool operator==(const Cursor& other) const { return at == other.at; }
  bool operator!=(const Cursor& other) const { return at != other.at; }
};

}  // namespace

// Receives the events of nlohmann's parser.
class JsonBuilder {
 public:
  JsonBuilder(std::string_view text, JsonDocument& document)
      : document_(document),
        begin_(text.data()),
        counted_(text.data()),
        reached_(text.data()),
        end_(text.data() + text.size()) {
    document_.nodes_.reserve(text.size() / 6 + 1);
    document_.texts_.reserve(text.size());
  }

  void parse() { Json::sax_parse(Cursor{counted_, &reached_}, Cursor{end_, &reached_}, this); }

  bool null() { return add(JsonKind::kNull, {}); }
  bool boolean(bool value) { return add(JsonKind::kBoolean, value ? "true" : "false"); }
  bool number_integer(std::int64_t value) { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_float(long double, const std::string& typed) {
    // The parser spells the decimal point as the C locale in force does.
    std::string text = typed;
    for (char& c : text)
      if ((c < '0' || c > '9') && c != '-' && c != '+' && c != 'e' && c != 'E') c = '.';
    return add(JsonKind::kNumber, text);
  }
  bool string(const std::string& text) { return add(JsonKind::kString, text); }
  bool binary(Json::binary_t&) { return false; }  // does not occur in text
  bool key(const std::string& text) {
    ++document_.nodes_[open_.back()].size;
    return push(JsonKind::kKey, text);
  }
  bool start_object(std::size_t) { return open(JsonKind::kObject); }
  bool start_array(std::size_t) { return open(JsonKind::kArray); }
  bool end_array() { return close(); }
  bool end_object() {
    const JsonValue object(&document_, open_.back());
    close();
    refuse_duplicate_keys(object);
    return true;
  }

  [[noreturn]] bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    if (error.id == 406)
      refuse("a number is beyond the range in which numbers are read",
             {"at most " + std::to_string(kMaxNumberLength) + " characters and an exponent of at most " +
              std::to_string(kMaxNumberExponent)});
    // "[...] parse error at line 1, column 5: syntax error while parsing value - invalid literal; last read: '...'"
    std::string text = error.what();
    if (const auto reason = text.find(" - "); reason != std::string::npos) text.erase(0, reason + 3);
    text.erase(std::min(text.find("; last read: "), text.size()));
    if (text.starts_with("unexpected ']'") || text.starts_with("unexpected '}'")) {
      if (is_after_comma()) text = fmt::format("a comma stands before {} with nothing after it", text.substr(11, 3));
    } else if (is_missing_comma(text)) {
      text = fmt::format("a comma is missing before {}",
                         text.starts_with("unexpected '")        ? text.substr(11, 3)
                         : text.starts_with("unexpected string") ? "a text in double quotes"
                         : text.starts_with("unexpected number") ? "a number"
                                                                 : "true, false or null");
    } else if (text.starts_with("unexpected number") && text.ends_with("; expected string literal")) {
      refuse("this is not JSON: a number stands after a comma where the name of a member is expected",
             {"decimals have a point: 0.5, not 0,5"});
    } else if (text.starts_with("invalid literal") || text.starts_with("invalid number")) {
      const std::string token = last_token();
      if (!token.empty())
        refuse("this is not JSON: " + quoted_name(token) + " is not understood", token_hints(token[0]));
    }
    refuse("this is not JSON: " + text);
  }

 private:
  // Whether another member follows where a list or an object may only go on after a comma, or end.
  static bool is_missing_comma(const std::string& text) {
    return (text.ends_with("; expected ']'") || text.ends_with("; expected '}'")) &&
           !text.starts_with("unexpected ']'") && !text.starts_with("unexpected '}'") &&
           !text.starts_with("unexpected ':'") && !text.starts_with("unexpected end");
  }

  // Whether a comma is the last before the character that was read last.
  bool is_after_comma() const {
    const char* at = reached_ - 1;
    while (at > begin_ && std::isspace(static_cast<unsigned char>(at[-1])) != 0) --at;
    return at > begin_ && at[-1] == ',';
  }

  // What stands, without blanks, at the character that was read last, or ends before it.
  std::string last_token() const {
    const auto is_inside = [](char c) {
      return static_cast<unsigned char>(c) > ' ' && std::string_view("[]{},:\"").find(c) == std::string_view::npos;
    };
    const char* first = reached_ - 1;
    if (!is_inside(*first) && first > begin_) --first;
    const char* last = first;
    while (first > begin_ && is_inside(first[-1])) --first;
    while (last < end_ && is_inside(*last)) ++last;
    return first < last ? std::string(first, last) : "";
  }

  static std::vector<std::string> token_hints(char first) {
    if (first == '/' || first == '#') return {"JSON has no comments; \"about\": \"...\" holds text for people"};
    if (first == '.' || first == '+' || first == '-' || (first >= '0' && first <= '9'))
      return {"numbers are written like 12, -0.1, 2.5e-3 or \"4/3\", with a digit before the point"};
    return {"texts stand in double quotes; without them there are numbers, true and false"};
  }

  [[noreturn]] void refuse(const std::string& text, std::vector<std::string> hints = {}) {
    throw InputError({document_.name_, static_cast<int>(line())}, text, std::move(hints));
  }

  // The line of the last character read. After a number the parser has read one character more, which may end the
  // line; that character itself is never counted.
  std::uint32_t line() {
    if (reached_ > counted_) {
      newlines_ += static_cast<std::uint32_t>(std::count(counted_, reached_ - 1, '\n'));
      counted_ = reached_ - 1;
    }
    return 1 + newlines_;
  }

  bool push(JsonKind kind, std::string_view text) {
    document_.nodes_.push_back(
        {line(), static_cast<std::uint32_t>(text.size()), static_cast<std::uint32_t>(document_.texts_.size()), kind});
    document_.texts_ += text;
    return true;
  }

  bool add(JsonKind kind, std::string_view text) {
    count_item();
    return push(kind, text);
  }

  void count_item() {
    if (open_.empty()) return;
    auto& parent = document_.nodes_[open_.back()];
    if (parent.kind == JsonKind::kArray) ++parent.size;
  }

  bool open(JsonKind kind) {
    if (open_.size() == kMaxJsonDepth)
      refuse("lists and objects are nested more than " + std::to_string(kMaxJsonDepth) + " deep");
    count_item();
    open_.push_back(static_cast<std::uint32_t>(document_.nodes_.size()));
    return push(kind, {});
  }

  bool close() {
    document_.nodes_[open_.back()].at = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  void refuse_duplicate_keys(const JsonValue& object) const {
    const auto refuse_key = [&](const JsonValue& key) {
      throw InputError({document_.name_, key.line()}, "the key " + quoted_name(key.text()) + " is given twice");
    };
    if (object.size() <= 12) {
      JsonValue keys[12];
      std::size_t count = 0;
      for (const auto [key, value] : object.members()) {
        for (std::size_t i = 0; i < count; ++i)
          if (keys[i].text() == key.text()) refuse_key(key);
        keys[count++] = key;
      }
      return;
    }
    std::unordered_set<std::string_view> seen;
    for (const auto [key, value] : object.members())
      if (!seen.insert(key.text()).second) refuse_key(key);
  }

  JsonDocument& document_;
  std::vector<std::uint32_t> open_;  // the lists and objects that are not closed yet
  const char* begin_;
  const char* counted_;  // newlines before this are counted
  const char* reached_;
  const char* end_;
  std::uint32_t newlines_ = 0;
};

JsonDocument::JsonDocument(std::string_view text, std::string name) : name_(std::move(name)) {
  const auto refuse_at = [&](std::size_t at, const std::string& message, std::vector<std::string> hints = {}) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw InputError({name_, static_cast<int>(line)}, message, std::move(hints));
  };
  if (text.size() > kMaxTextFileBytes) refuse_at(0, "the text is larger than 2 GiB");
  if (text.starts_with("\xEF\xBB\xBF"))
    refuse_at(0, "the file begins with a byte order mark", {"save it as UTF-8 without a byte order mark"});
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
    refuse_at(0, "the file is UTF-16", {"save it as UTF-8 without a byte order mark"});
  // The parser would take a NUL byte for the end of the text.
  if (const auto at = text.find('\0'); at != std::string_view::npos) refuse_at(at, "this is not JSON: a NUL byte");
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) throw InputError({name_, 0}, "the file is empty");
  JsonBuilder(text, *this).parse();
}

}  // namespace hottel
