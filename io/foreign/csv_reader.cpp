#include "io/foreign/csv_reader.h"

#include <algorithm>
#include <memory>

namespace hottel {

CsvReader::CsvReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
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

bool CsvReader::next() {
  fields_.clear();
  unquoted_.clear();
  for (; at_ < text_.size() && (text_[at_] == '\n' || text_.substr(at_).starts_with("\r\n")); ++at_)
    if (text_[at_] == '\n') ++line_;
  line_of_record_ = line_;
  if (at_ >= text_.size()) return false;
  for (;;) {
    if (at_ < text_.size() && text_[at_] == '"') {
      ++at_;
      fields_.push_back(quoted());
    } else {
      const std::size_t end = std::min(text_.find_first_of(",\n", at_), text_.size());
      std::string_view field = text_.substr(at_, end - at_);
      at_ = end;
      if (field.ends_with('\r') && (at_ == text_.size() || text_[at_] == '\n')) field.remove_suffix(1);
      fields_.push_back(field);
    }
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;  // after a quoted field
    if (at_ >= text_.size()) return true;
    const char separator = text_[at_++];
    if (separator == '\n') {
      ++line_;
      return true;
    }
    if (separator != ',') throw InputError({file_, line_}, "a comma or a line end must follow a quoted field");
  }
}

}  // namespace hottel
