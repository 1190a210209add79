// The three kinds of failure, and the channel of each.
//
//   contract broken     HOTTEL_REQUIRE throws ContractViolation with the expression and the place
//   input wrong         InputError: the file, the line, one sentence, hints           (exit code 3)
//   request unmet       RequestError: the input is fine, what was asked cannot be had (exit code 1)
//   usage               UsageError: unknown option, ending, method, name              (exit code 2)
//
// A number that could not be decided is none of these: it is a wider enclosure.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hottel {

struct FileLine {
  std::string file;
  int line = 0;  // 1-based; 0 where there is none
};

class InputError : public std::runtime_error {
 public:
  // what() is "FILE:LINE: text" or "FILE: text": one line. At most three hints, one line each.
  InputError(FileLine where, const std::string& text, std::vector<std::string> hints = {})
      : std::runtime_error(where.file + (where.line > 0 ? ':' + std::to_string(where.line) : "") + ": " + text),
        where_(std::move(where)),
        hints_(std::move(hints)) {}

  const FileLine& where() const { return where_; }
  const std::vector<std::string>& hints() const { return hints_; }

 private:
  FileLine where_;
  std::vector<std::string> hints_;
};

class RequestError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void throw_contract_violation(const char* expression, const char* file, int line) {
  throw ContractViolation(std::string(file) + ":" + std::to_string(line) + ": required: " + expression);
}

}  // namespace hottel

#define HOTTEL_REQUIRE(expression) \
  ((expression) ? void(0) : ::hottel::throw_contract_violation(#expression, __FILE__, __LINE__))
