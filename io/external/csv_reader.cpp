#include "io/external/csv_reader.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "geometry/name.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t";

// The first two lines that hold anything, without their ends; empty where there is none.
std::array<std::string_view, 2> first_lines(std::string_view text) {
  std::array<std::string_view, 2> lines;
  for (std::size_t found = 0; found < lines.size() && !text.empty();) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!trimmed(line, kBlanks).empty() && !line.starts_with('#')) lines[found++] = line;
  }
  return lines;
}

// Places of a character outside of quotes.
std::vector<std::size_t> unquoted_places(std::string_view line, char c) {
  std::vector<std::size_t> places;
  bool is_quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    is_quoted ^= line[at] == '"';
    if (!is_quoted && line[at] == c) places.push_back(at);
  }
  return places;
}

}  // namespace

CsvDialect csv_dialect_of(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const auto [head, second] = first_lines(text);
  CsvDialect dialect{.has_comments = true};
  for (const char separator : {',', ';', '\t', ' '})
    if (!unquoted_places(head, separator).empty()) {
      dialect.separator = separator;
      break;
    }
  if (dialect.separator == ' ') return dialect;
  const std::string_view line = second.empty() ? head : second;
  const std::vector<std::size_t> places = unquoted_places(line, dialect.separator);
  dialect.trims = !places.empty() && std::all_of(places.begin(), places.end(), [line = line](std::size_t at) {
    return at + 1 < line.size() && line[at + 1] == ' ';
  });
  return dialect;
}

CsvReader::CsvReader(std::string file, std::string_view text, CsvDialect dialect)
    : file_(std::move(file)), text_(text), dialect_(dialect) {
  if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

// The field after an opening quote, without the quotes.
std::string_view CsvReader::quoted() {
  const FileLine opened{file_, line_};
  std::string joined;
  bool is_joined = false;
  for (;;) {
    const std::size_t end = text_.find('"', at_);
    if (end == std::string_view::npos) throw InputError(opened, "a quoted field is not closed");
    const std::string_view part = text_.substr(at_, end - at_);
    line_ += static_cast<int>(std::count(part.begin(), part.end(), '\n'));
    at_ = end + 1;
    const bool is_doubled = at_ < text_.size() && text_[at_] == '"';
    if (!is_doubled && !is_joined) return part;
    joined += part;
    is_joined = true;
    if (!is_doubled) break;
    joined += '"';
    ++at_;
  }
  unquoted_.push_back(std::make_unique<std::string>(std::move(joined)));
  return *unquoted_.back();
}

// The field that stands here, up to its separator or the end of the line.
std::string_view CsvReader::plain() {
  const bool is_by_blanks = dialect_.separator == ' ';
  const char ends[] = {dialect_.separator, '\n', is_by_blanks ? '\t' : '\n'};
  const std::size_t end = std::min(text_.find_first_of(std::string_view(ends, sizeof ends), at_), text_.size());
  std::string_view field = text_.substr(at_, end - at_);
  at_ = end;
  if (field.ends_with('\r') && (at_ == text_.size() || text_[at_] == '\n')) field.remove_suffix(1);
  return dialect_.trims ? trimmed(field, kBlanks) : field;
}

void CsvReader::skip_blanks() {
  const std::string_view blanks = dialect_.separator == '\t' ? " " : kBlanks;
  at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
}

bool CsvReader::is_at_line_end() const {
  return at_ >= text_.size() || text_[at_] == '\n' || text_.substr(at_).starts_with("\r\n");
}

bool CsvReader::next() {
  fields_.clear();
  unquoted_.clear();
  const bool is_by_blanks = dialect_.separator == ' ', skips = is_by_blanks || dialect_.trims;
  for (; at_ < text_.size(); ++at_) {
    if (is_by_blanks) skip_blanks();
    if (dialect_.has_comments && at_ < text_.size() && text_[at_] == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ >= text_.size() || !is_at_line_end()) break;
    if (text_[at_] == '\n') ++line_;
  }
  line_of_record_ = line_;
  if (at_ >= text_.size()) return false;
  for (;;) {
    if (skips) skip_blanks();
    if (at_ < text_.size() && text_[at_] == '"') {
      ++at_;
      fields_.push_back(quoted());
    } else {
      fields_.push_back(plain());
    }
    if (skips) skip_blanks();
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;  // after a field
    if (at_ >= text_.size()) return true;
    if (text_[at_] == '\n') {
      ++at_;
      ++line_;
      return true;
    }
    if (is_by_blanks && kBlanks.find(text_[at_ - 1]) != std::string_view::npos) continue;
    if (text_[at_++] != dialect_.separator)
      throw InputError({file_, line_}, "a comma or a line end must follow a quoted field");
  }
}

Rational exact_number(std::string_view field, const FileLine& where) {
  const std::optional<Rational> number = parse_rational(field);
  if (!number) throw InputError(where, quoted_name(field) + " is no number: an integer, a decimal or p/q");
  return *number;
}

}  // namespace hottel
