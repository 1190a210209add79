#include "io/scene/space/vs3_statements.h"

#include <algorithm>
#include <charconv>

#include "geometry/name.h"
#include "geometry/number.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kBetweenWords = " \t\v\f,";

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

void skip_to_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBetweenWords), text.size()));
}

std::string_view take_word(std::string_view& text) {
  skip_to_word(text);
  if (text.starts_with('!')) text = {};
  const std::string_view word = text.substr(0, text.find_first_of(kBetweenWords));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

Vs3Statements3::Vs3Statements3(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  if (text.size() > kMaxTextFileBytes) throw InputError({file_, 0}, "the text is larger than 2 GiB");
  if (text.starts_with("\xEF\xBB\xBF") || text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
    throw InputError({file_, 1}, "the file begins with a byte order mark",
                     {"save it as UTF-8 without a byte order mark"});
}

bool Vs3Statements3::go_to_line() {
  while (!has_ended_ && !text_.empty()) {
    rest_ = text_.substr(0, text_.find_first_of("\r\n"));
    text_.remove_prefix(rest_.size());
    text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
    line_ = ++lines_read_;
    if (rest_.find('\0') != std::string_view::npos) refuse("the line has a NUL byte: this is no text");
    skip_to_word(rest_);
    if (rest_.empty() || rest_.front() == '!' || rest_.front() == '/') continue;
    if (rest_.front() == '*') break;
    return true;
  }
  has_ended_ = true;
  rest_ = {};
  return false;
}

bool Vs3Statements3::next() {
  if (!go_to_line()) return false;
  letter_ = upper(take_word(rest_).front());
  has_ended_ = letter_ == 'E';
  return !has_ended_;
}

void Vs3Statements3::next_line(std::string_view subject) {
  if (!go_to_line()) refuse(std::string(subject) + " is missing: the deck ends");
}

std::string_view Vs3Statements3::word() { return take_word(rest_); }

std::string_view Vs3Statements3::word(std::string_view subject) {
  const std::string_view result = word();
  if (result.empty()) refuse(std::string(subject) + " is missing: the line ends");
  return result;
}

std::string_view Vs3Statements3::word_of_lines(std::string_view subject) {
  std::string_view result = word();
  while (result.empty()) {
    next_line(subject);
    result = word();
  }
  return result;
}

Rational Vs3Statements3::number(std::string_view word, std::string_view subject) const {
  if (auto value = parse_rational(word)) return *std::move(value);
  const auto [problem, hint] = number_problem(word);
  refuse(std::string(subject) + " " + problem, hint.empty() ? std::vector<std::string>() : std::vector{hint});
}

std::uint32_t Vs3Statements3::count(std::string_view word, std::string_view subject) const {
  std::uint32_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size())
    refuse(std::string(subject) + " is no whole number: " + quoted_name(word));
  if (word.size() > 1 && word.front() == '0')
    refuse(std::string(subject) + " begins with 0: " + quoted_name(word),
           {"View3D takes such numbers as octal or hexadecimal; write them without it"});
  return value;
}

void Vs3Statements3::refuse(const std::string& text, std::vector<std::string> hints) const {
  throw InputError({file_, line_}, text, std::move(hints));
}

}  // namespace hottel
