#include "kernel/support/memory.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace hottel {

std::uint64_t memory_allowed(std::uint64_t asked) {
  if (asked > 0) return asked;
  std::ifstream info("/proc/meminfo");
  std::string name, unit;
  std::uint64_t kilobytes = 0;
  while (info >> name >> kilobytes && std::getline(info, unit))
    if (name == "MemAvailable:") return kilobytes * 1024 / 5 * 4;
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 5 * 4;
}

}  // namespace hottel
