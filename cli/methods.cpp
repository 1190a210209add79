#include "cli/methods.h"

#include <algorithm>

#include "io/foreign/foreign_radiosity.h"
#include "io/foreign/plane/foreign_matrix.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kFile = "file:";

}  // namespace

std::string methods_text(const MethodCatalogue2& methods) {
  std::string text;
  for (const MethodFamily2& family : methods.families()) text += "\n  " + family.pattern + ": " + family.what;
  return text;
}

std::vector<std::string> method_names(const std::vector<std::string>& lists, const MethodCatalogue2& methods) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& part) {
    const bool is_method =
        std::any_of(methods.families().begin(), methods.families().end(),
                    [&](const MethodFamily2& family) { return family.name == family_of_method(part); });
    if (!is_method && !names.empty() && is_foreign_2(names.back()))
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
