#include "io/scene/obj_statements.h"

#include <algorithm>

#include "geometry/number.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

// The line without its comment.
std::string_view without_comment(std::string_view line) {
  for (auto at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at == 0 || kBlanks.find(line[at - 1]) != std::string_view::npos) return line.substr(0, at);
  return line;
}

}  // namespace

ObjStatements::ObjStatements(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  if (text.size() > kMaxTextFileBytes) throw InputError({file_, 0}, "the text is larger than 2 GiB");
  if (text.starts_with("\xEF\xBB\xBF") || text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
    throw InputError({file_, 1}, "the file begins with a byte order mark",
                     {"save it as UTF-8 without a byte order mark"});
}

ObjStatements::Line ObjStatements::next_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  const std::string_view line = text_.substr(0, end);
  text_.remove_prefix(end);
  text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
  ++lines_read_;
  if (line.find('\0') != std::string_view::npos) {
    line_ = lines_read_;
    refuse("the line has a NUL byte: this is no text");
  }
  return {line, without_comment(line)};
}

bool ObjStatements::next() {
  while (!text_.empty()) {
    line_ = lines_read_ + 1;
    auto [raw, statement] = next_line();
    if (statement.ends_with('\\')) {
      joined_ = statement;
      raw_joined_ = raw;
      while (joined_.ends_with('\\')) {
        joined_.back() = raw_joined_.back() = ' ';
        if (text_.empty()) break;
        const Line next = next_line();
        joined_ += next.statement;
        raw_joined_ += next.raw;
      }
      statement = joined_;
      raw = raw_joined_;
    }
    statement = trimmed(statement, kBlanks);
    if (statement.empty()) continue;
    const std::size_t end = std::min(statement.find_first_of(kBlanks), statement.size());
    keyword_ = statement.substr(0, end);
    rest_ = trimmed(statement.substr(end), kBlanks);
    raw_rest_ = trimmed(trimmed(raw, kBlanks).substr(end), kBlanks);
    return true;
  }
  return false;
}

std::vector<std::string_view> ObjStatements::words() const {
  std::vector<std::string_view> words;
  for (std::string_view rest = rest_; !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
    words.push_back(rest.substr(0, end));
    rest = trimmed(rest.substr(end), kBlanks);
  }
  return words;
}

Rational ObjStatements::number(std::string_view word, std::string_view subject) const {
  if (auto value = parse_rational(word)) return *std::move(value);
  const auto [problem, hint] = number_problem(word);
  refuse(std::string(subject) + " " + problem, hint.empty() ? std::vector<std::string>() : std::vector{hint});
}

void ObjStatements::refuse(const std::string& text, std::vector<std::string> hints) const {
  throw InputError({file_, line_}, text, std::move(hints));
}

}  // namespace hottel
