// The kinds of failure, and the channel of each.
//
//   contract broken     HOTTEL_REQUIRE throws ContractViolation with the expression and the place
//   input wrong         InputError: the file, the line, one sentence, hints           (exit code 3)
//   request unmet       RequestError: the input is fine, what was asked cannot be had (exit code 1)
//   usage               UsageError: unknown option, ending, method, name              (exit code 2)
//
// A number that could not be decided is none of these: it is a wider enclosure.
//
//   try {
//     const Simulation2 simulation(read_scene_2(file));
//     std::printf("F = %.17g\n", view_factor(simulation, "bottom", "top").value);
//   } catch (const InputError& error) {
//     std::fprintf(stderr, "%s\n", error.what());
//     for (const std::string& hint : error.hints()) std::fprintf(stderr, "  %s\n", hint.c_str());
//   }
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hottel {

// A place in a file that was read.
struct FileLine {
  std::string file;
  int line = 0;  // 1-based; 0 where there is none

  // "FILE:LINE", or "FILE".
  std::string text() const { return file + (line > 0 ? ':' + std::to_string(line) : ""); }
};

// What was read is wrong: a file, its syntax, or the scene it describes.
//
//   (1) what() begins with the place, and with the file alone where there is no line
//   (2) where() and hints() are as they were given
class InputError : public std::runtime_error {
 public:
  // what() is "FILE:LINE: text" or "FILE: text": one line. Hints say more about what is wrong, or what to do.
  // REQUIRES: at most three hints, one line each (not checked).
  InputError(FileLine where, const std::string& text, std::vector<std::string> hints = {})
      : std::runtime_error(where.text() + ": " + text), where_(std::move(where)), hints_(std::move(hints)) {}

  const FileLine& where() const { return where_; }
  const std::vector<std::string>& hints() const { return hints_; }

 private:
  FileLine where_;
  std::vector<std::string> hints_;
};

// There is no such file.
class MissingFile : public InputError {
 public:
  using InputError::InputError;
};

// The input is fine, but what was asked of it cannot be had: too little memory, or a solution that does not exist.
// what() is one line for the user.
class RequestError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The program or a function behind one of its options was asked for something that it does not have, or that is out of
// range: an option, an ending, a method, a name. what() is one line for the user. An UnknownName is one: of a name that
// does not exist.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A mistake in the calling code: a REQUIRES did not hold. From HOTTEL_REQUIRE, what() is "FILE:LINE: required:
// EXPRESSION", with the place of the check in the source.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void throw_contract_violation(const char* expression, const char* file, int line) {
  throw ContractViolation(std::string(file) + ":" + std::to_string(line) + ": required: " + expression);
}

}  // namespace hottel

// Throws ContractViolation unless the expression is true.
//
//   (1) it is evaluated once, in every build: NDEBUG does not take it away
//   (2) it is itself an expression, of type void
//
// A comma outside parentheses divides the arguments of a macro: put parentheses around such an expression.
#define HOTTEL_REQUIRE(expression) \
  ((expression) ? void(0) : ::hottel::throw_contract_violation(#expression, __FILE__, __LINE__))
