#include "kernel/support/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace hottel {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

// The number after a name in a file of lines "NAME NUMBER ...".
std::optional<std::uint64_t> number_of(const std::filesystem::path& file, const std::string& wanted) {
  std::ifstream lines(file);
  std::string name, rest;
  std::uint64_t number = 0;
  while (lines >> name >> number && std::getline(lines, rest))
    if (name == wanted) return number;
  return std::nullopt;
}

// The number that a file holds; nothing for other words ("max"), and where there is no such file.
std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
  std::ifstream text(file);
  std::uint64_t number = 0;
  return text >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t installed() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// What the files of a control group are called.
struct GroupFiles {
  const char *limit, *used, *droppable;
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

// What is left in a group.
std::uint64_t left_in(const std::filesystem::path& group, const GroupFiles& files) {
  const auto limit = number_in(group / files.limit), used = number_in(group / files.used);
  if (!limit || !used) return kNoLimit;
  const std::uint64_t needed = *used - std::min(*used, number_of(group / "memory.stat", files.droppable).value_or(0));
  return *limit - std::min(*limit, needed);
}

// In a group and in all that it is in. In a container the root alone may be there.
std::uint64_t left_from(const std::filesystem::path& mount, std::filesystem::path group, const GroupFiles& files) {
  std::uint64_t least = left_in(mount, files);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path())
    least = std::min(least, left_in(mount / group, files));
  return least;
}

bool lists(const std::string& controllers, const std::string& wanted) {
  return ("," + controllers + ",").find("," + wanted + ",") != std::string::npos;
}

// Lines of /proc/self/cgroup are NUMBER:CONTROLLERS:GROUP, of version 2 without controllers.
std::uint64_t left_in_groups(const std::filesystem::path& root) {
  std::uint64_t least = kNoLimit;
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    const std::filesystem::path mount = root / "sys/fs/cgroup";
    if (controllers.empty())
      least = std::min(least, left_from(mount, group, kVersion2));
    else if (lists(controllers, "memory"))
      least = std::min(least, left_from(mount / "memory", group, kVersion1));
  }
  return least;
}

std::uint64_t left_of_addresses(const std::filesystem::path& root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  const std::uint64_t pages = number_in(root / "proc/self/statm").value_or(0);
  const std::uint64_t taken = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, taken);
}

}  // namespace

std::uint64_t memory_allowed(std::uint64_t asked) { return asked > 0 ? asked : free_memory() / 5 * 4; }

std::uint64_t free_memory(const std::filesystem::path& root) {
  const auto available = number_of(root / "proc/meminfo", "MemAvailable:");
  return std::min({available ? *available * 1024 : installed(), left_in_groups(root), left_of_addresses(root)});
}

}  // namespace hottel
