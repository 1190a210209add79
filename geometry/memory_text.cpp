#include "geometry/memory_text.h"

#include <fmt/format.h>

#include <iterator>

#include "kernel/support/failure.h"
#include "kernel/support/memory.h"

namespace hottel {

std::string short_bytes(double bytes) {
  constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  if (bytes == 1) return "1 byte";
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < std::size(kUnits); ++unit) bytes /= 1000;
  if (bytes >= 999.5) return fmt::format("{:.1e} {}", bytes, kUnits[unit]);
  return unit == 0 ? fmt::format("{:.0f} {}", bytes, kUnits[unit])
                   : fmt::format("{:.{}f} {}", bytes, bytes < 9.95 ? 1 : 0, kUnits[unit]);
}

std::string limit_text(std::uint64_t bytes) {
  const std::string text = short_bytes(static_cast<double>(bytes));
  return bytes < 1000 ? text : fmt::format("{} ({} bytes)", text, bytes);
}

void refuse_memory(const SceneTable& scene, std::uint64_t count, const std::string& what, std::uint64_t each,
                   std::uint64_t limit) {
  const bool is_chosen = limit < memory_allowed() / 2;  // not what is free, which changes from moment to moment
  throw RequestError(fmt::format("about {} {} need about {} of memory; the limit is {}. Allow more {}{}", count, what,
                                 short_bytes(static_cast<double>(count) * static_cast<double>(each)), limit_text(limit),
                                 is_chosen ? "(--memory)" : "memory",
                                 is_divided(scene) ? ", or take fewer elements" : ""));
}

}  // namespace hottel
