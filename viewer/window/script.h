// Scripts for a window: what a hand would do, a line each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// A step of a script: a word, what follows it, and where it stands.
struct ScriptStep {
  std::string word;
  std::vector<std::string> arguments;
  std::string rest;  // the text after the word, as it stands
  int line = 0;
};

// Returns the steps of a script; docs/window.md lists them. Empty lines and those that begin with '#' are none.
// Throws InputError naming the line for words that are unknown, and for a wrong number of arguments.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& name);

}  // namespace hottel
