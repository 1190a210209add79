#include "io/external/external_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct DigitCount {
  int decimals = 0, significant = 0;
};

// "0.01230e-2": 7 decimals, 4 significant digits. REQUIRES a number as from_chars takes it.
DigitCount count_digits(std::string_view token) {
  const std::size_t exponent_at = std::min(token.find_first_of("eE"), token.size());
  DigitCount count;
  bool is_leading = true, is_after_point = false;
  for (const char c : token.substr(0, exponent_at)) {
    if (c == '.') is_after_point = true;
    if (!is_digit(c)) continue;
    is_leading = is_leading && c == '0';
    if (!is_leading) ++count.significant;
    if (is_after_point) ++count.decimals;
  }
  if (exponent_at == token.size() || count.significant == 0) return count;
  std::string_view exponent = token.substr(exponent_at + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  int shift = 0;
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), shift);  // in range: the number was
  count.decimals = std::max(0, count.decimals - std::clamp(shift, -1000, 1000));
  return count;
}

}  // namespace

double ExternalNumbers::read(std::string_view token, int line) {
  const std::string_view as_written = token;
  token = trimmed(token, " \t");
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument || token.empty())
    throw InputError({file_, line}, quoted_name(as_written) + " is not a number");
  if (error == std::errc::result_out_of_range) {
    // Too large or too small for a double: the exponent tells which.
    if (token.find("e-") == std::string_view::npos && token.find("E-") == std::string_view::npos)
      throw InputError({file_, line}, quoted_name(as_written) + " is too large");
    value = 0;
  }
  if (!std::isfinite(value)) throw InputError({file_, line}, quoted_name(as_written) + " is not a finite number");
  const DigitCount count = count_digits(token);
  decimals_ = std::max(decimals_, count.decimals);
  significant_ = std::max(significant_, count.significant);
  return value;
}

std::uint32_t ExternalNumbers::read_count(std::string_view token, std::uint64_t least, std::uint64_t most,
                                          const std::string& what, int line) const {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error != std::errc() || value < least || value > most)
    throw InputError({file_, line}, what + " must be a whole number from " + std::to_string(least) + " to " +
                                        std::to_string(most) + ", not " + quoted_name(token));
  return static_cast<std::uint32_t>(value);
}

bool ExternalWords::next() {
  std::size_t at = 0;
  for (; at < text_.size() && (text_[at] == ' ' || text_[at] == '\t' || text_[at] == '\r' || text_[at] == '\n'); ++at)
    if (text_[at] == '\n') ++line_;
  text_.remove_prefix(at);
  word_ = text_.substr(0, text_.find_first_of(" \t\r\n"));
  text_.remove_prefix(word_.size());
  return !word_.empty();
}

std::string_view ExternalWords::rest_of_line() {
  const std::string_view rest = text_.substr(0, text_.find('\n'));
  text_.remove_prefix(std::min(rest.size() + 1, text_.size()));
  ++line_;
  return rest;
}

}  // namespace hottel
