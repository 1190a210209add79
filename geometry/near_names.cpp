#include "geometry/near_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "geometry/name.h"

namespace hottel {
namespace {

constexpr std::size_t kLongestCompared = 200;

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// The least number of insertions, omissions, replacements and swaps of neighbours (each letter in one of them at most).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::vector<std::string> near_names(std::string_view name, std::span<const std::string> known) {
  if (name.empty() || name.size() > kLongestCompared) return {};
  const std::string wanted = lowered(name);
  const std::size_t most = std::min(std::max<std::size_t>(1, wanted.size() / 3), wanted.size() - 1);
  // Of a beginning: as if it were farther than anything near, by its length.
  std::vector<std::pair<std::size_t, std::string_view>> found;
  for (const std::string& each : known) {
    const std::size_t longer = std::max(each.size(), wanted.size()), shorter = std::min(each.size(), wanted.size());
    const std::string candidate = each.size() > kLongestCompared ? "" : lowered(each);
    if (candidate.empty() || each == name) continue;
    if (longer - shorter <= most)
      if (const std::size_t distance = edit_distance(wanted, candidate); distance <= most) {
        found.emplace_back(distance, each);
        continue;
      }
    if (wanted.size() > 1 && candidate.starts_with(wanted)) found.emplace_back(kLongestCompared + each.size(), each);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> result;
  for (const auto& [distance, each] : found)
    if (result.size() < kMostNearNames && std::find(result.begin(), result.end(), each) == result.end())
      result.emplace_back(each);
  return result;
}

std::vector<std::string> near_name_hints(std::string_view name, std::span<const std::string> known) {
  std::string hint;
  for (const std::string& each : near_names(name, known))
    hint += (hint.empty() ? "did you mean " : ", ") + quoted_name(each);
  return hint.empty() ? std::vector<std::string>() : std::vector<std::string>{hint + "?"};
}

}  // namespace hottel
