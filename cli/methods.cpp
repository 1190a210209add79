#include "cli/methods.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/external/external_method.h"
#include "io/external/external_radiosity.h"
#include "io/external/plane/external_matrix.h"
#include "io/external/space/external_matrix.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kFile = "file:";
constexpr const char* kInPlane = " (in the plane)";

// "mine=file:own.csv"
bool is_named(const std::string& part) {
  const std::size_t equals = part.find('=');
  return equals != std::string::npos && part.find(':') > equals && is_external(part.substr(equals + 1));
}

}  // namespace

std::string methods_text() {
  std::vector<std::pair<std::string, std::string>> lines;  // pattern: what, and where
  const auto add = [&lines](const auto& methods, const std::string& where) {
    for (const auto& family : methods.families()) {
      const auto known = std::ranges::find(lines, family.pattern, &std::pair<std::string, std::string>::first);
      if (known == lines.end())
        lines.emplace_back(family.pattern, family.what + where);
      else if (const std::size_t other = known->second.find(kInPlane); other != std::string::npos)
        known->second.erase(other);
    }
  };
  add(all_methods_2(), kInPlane);
  add(all_methods_3(), " (in space)");
  std::string text;
  for (const auto& [pattern, what] : lines) text += "\n  " + pattern + ": " + what;
  return text;
}

std::vector<std::string> method_names(const std::vector<std::string>& lists, const std::vector<std::string>& families) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& part) {
    const bool is_method = std::ranges::find(families, family_of_method(part)) != families.end() || is_named(part);
    if (!is_method && !names.empty() && is_external(named_method(names.back()).method))
      names.back() += "," + part;
    else if (part.empty())
      throw UsageError("--methods has an empty name; names are separated by single commas");
    else
      names.push_back(part);
  };
  for (const std::string& list : lists) {
    std::size_t begin = 0;
    for (std::size_t comma = 0; (comma = list.find(',', begin)) != std::string::npos; begin = comma + 1)
      add(list.substr(begin, comma - begin));
    add(list.substr(begin));
  }
  return names;
}

NamedMethod named_method(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || text.find(':') < equals) return {text, ""};
  const NamedMethod split{text.substr(equals + 1), text.substr(0, equals)};
  if (!is_external(split.method))
    throw UsageError("--methods gives names to file: and run:, as in mine=file:own.csv; '" + split.method +
                     "' has its own");
  if (split.given.empty()) throw UsageError("--methods has an empty name before '='");
  return split;
}

std::string external_curve(const NamedMethod& method, const std::vector<std::string>& taken) {
  if (!method.given.empty()) return method.given;
  const auto [raw, normalised] = split_method_name(method.method);
  if (!raw.starts_with(kFile)) return method.method;
  const std::string stem = std::filesystem::path(raw.substr(kFile.size())).stem().string() + normalised;
  const bool is_free = !stem.empty() && std::ranges::find(taken, stem) == taken.end();
  return is_free ? stem : method.method;
}

std::vector<NamedMethod> take_radiosity_files(std::vector<NamedMethod>& methods) {
  const auto first = std::stable_partition(methods.begin(), methods.end(), [](const NamedMethod& each) {
    const std::string& name = each.method;
    return !name.starts_with(kFile) || name == kFile || !split_method_name(name).normalised.empty() ||
           !holds_radiosities(name.substr(kFile.size()));
  });
  std::vector<NamedMethod> files(first, methods.end());
  methods.erase(first, methods.end());
  return files;
}

void require_names_apart(const std::vector<NamedMethod>& methods, const std::vector<std::string>& families) {
  std::set<std::string> names;
  for (const NamedMethod& each : methods) {
    if (!each.given.empty() && std::ranges::find(families, each.given) != families.end())
      throw UsageError("'" + each.given + "' is a method of hottel: give " + each.method + " another name");
    if (!names.insert(each.name()).second && !each.given.empty())
      throw UsageError("two methods are called '" + each.given + "'");
  }
}

}  // namespace hottel
