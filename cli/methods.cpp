#include "cli/methods.h"

#include <algorithm>

#include "io/foreign/foreign_method.h"
#include "io/foreign/foreign_radiosity.h"
#include "io/foreign/plane/foreign_matrix.h"
#include "io/foreign/space/foreign_matrix.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kFile = "file:";
constexpr const char* kInPlane = " (in the plane)";

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
    const bool is_method = std::ranges::find(families, family_of_method(part)) != families.end();
    if (!is_method && !names.empty() && is_foreign(names.back()))
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

std::vector<std::string> take_radiosity_files(std::vector<std::string>& methods) {
  const auto first = std::stable_partition(methods.begin(), methods.end(), [](const std::string& name) {
    return !name.starts_with(kFile) || name == kFile || !split_method_name(name).normalised.empty() ||
           !holds_radiosities(name.substr(kFile.size()));
  });
  std::vector<std::string> files;
  for (auto name = first; name != methods.end(); ++name) files.push_back(name->substr(kFile.size()));
  methods.erase(first, methods.end());
  return files;
}

}  // namespace hottel
