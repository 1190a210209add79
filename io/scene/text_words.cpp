#include "io/scene/text_words.h"

#include <algorithm>
#include <charconv>

#include "geometry/name.h"
#include "geometry/number.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

TextWords::TextWords(std::string_view text, std::string file, bool has_comments, int first_line)
    : text_(text), file_(std::move(file)), has_comments_(has_comments), line_(first_line), lines_begun_(first_line) {
  if (text.size() > kMaxTextFileBytes) throw InputError({file_, 0}, "the text is larger than 2 GiB");
  if (text.starts_with("\xEF\xBB\xBF") || text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
    refuse("the file begins with a byte order mark", {"save it as UTF-8 without a byte order mark"});
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  for (std::size_t k = 0; k < nul; ++k) line_ += text[k] == '\n' || (text[k] == '\r' && text[k + 1] != '\n');
  refuse("the line has a NUL byte: this is no text");
}

std::optional<std::string_view> TextWords::next() {
  std::size_t k = 0;
  while (k < text_.size()) {
    const char c = text_[k];
    if (is_comment(c)) {
      k = std::min(text_.find_first_of("\r\n", k), text_.size());
    } else if (is_line_end(c)) {
      k += text_.substr(k).starts_with("\r\n") ? 2 : 1;
      ++lines_begun_;
    } else if (is_blank(c)) {
      ++k;
    } else {
      break;
    }
  }
  text_.remove_prefix(k);
  line_ = lines_begun_;
  if (text_.empty()) return std::nullopt;
  std::size_t end = 0;
  while (end < text_.size() && !is_blank(text_[end]) && !is_line_end(text_[end]) && !is_comment(text_[end])) ++end;
  const std::string_view word = text_.substr(0, end);
  text_.remove_prefix(end);
  return word;
}

std::string_view TextWords::rest_of_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  std::string_view rest = text_.substr(0, end);
  text_.remove_prefix(end);
  if (has_comments_) rest = rest.substr(0, rest.find('#'));
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

Rational TextWords::number(std::string_view word, std::string_view subject) const {
  if (auto value = parse_rational(word)) return *std::move(value);
  const auto [problem, hint] = number_problem(word);
  refuse(std::string(subject) + " " + problem, hint.empty() ? std::vector<std::string>() : std::vector{hint});
}

std::int64_t TextWords::integer(std::string_view word, std::string_view subject) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    refuse(std::string(subject) + " is not an integer: " + quoted_name(word));
  return value;
}

void TextWords::refuse(const std::string& text, std::vector<std::string> hints) const {
  throw InputError({file_, line_}, text, std::move(hints));
}

}  // namespace hottel
