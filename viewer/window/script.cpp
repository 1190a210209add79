#include "viewer/window/script.h"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// How many arguments a word takes: at least, at most.
const std::map<std::string, std::pair<std::size_t, std::size_t>>& words() {
  constexpr std::size_t kMany = 1000;
  static const std::map<std::string, std::pair<std::size_t, std::size_t>> kWords{
      {"move", {1, 1}},        {"press", {1, 3}}, {"release", {1, 2}},  {"click", {1, 3}},      {"drag", {2, kMany}},
      {"wheel", {2, 2}},       {"key", {1, 1}},   {"type", {1, kMany}}, {"do", {1, kMany}},     {"size", {1, 1}},
      {"wait", {0, 0}},        {"pause", {1, 1}}, {"save", {1, 1}},     {"screenshot", {1, 1}}, {"picture", {1, 1}},
      {"hash", {0, 0}},        {"leave", {0, 0}}, {"close", {0, 0}},    {"orbit", {1, 2}},      {"turn", {1, 2}},
      {"pan", {1, 2}},         {"zoom", {1, 1}},  {"walk", {1, 3}},     {"eye", {2, 2}},        {"pick", {1, kMany}},
      {"material", {2, kMany}}};
  return kWords;
}

}  // namespace

std::vector<ScriptStep> parse_script(std::string_view text, const std::string& name) {
  std::vector<ScriptStep> steps;
  std::istringstream stream{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    ScriptStep step;
    step.line = number;
    std::istringstream parts(line);
    if (!(parts >> step.word) || step.word.starts_with('#')) continue;
    std::getline(parts >> std::ws, step.rest);
    std::istringstream rest(step.rest);
    for (std::string argument; rest >> argument;) step.arguments.push_back(argument);
    const auto found = words().find(step.word);
    if (found == words().end()) {
      std::string known;
      for (const auto& [word, arguments] : words()) known += (known.empty() ? "" : ", ") + word;
      throw InputError({name, number}, "a step begins with one of " + known + ", not with '" + step.word + "'");
    }
    const auto [least, most] = found->second;
    if (step.arguments.size() < least || step.arguments.size() > most)
      throw InputError({name, number}, fmt::format("'{}' takes {} argument{}{}", step.word, least,
                                                   least == 1 ? "" : "s", most == least ? "" : " or more"));
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace hottel
