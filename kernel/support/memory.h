// How much memory work may take.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hottel {

// Returns how many bytes may be taken: `asked` itself where it is not 0, however much memory there is; else 80 % of
// what is free (free_memory).
std::uint64_t memory_allowed(std::uint64_t asked = 0);

// Returns how many bytes the process may still take, the least of
//
//   (1) what the system says is available (/proc/meminfo), or where it does not say so the memory that is installed
//   (2) what is left in each of its control groups, of either version, files that may be dropped from memory not
//       counted; a container has its limit there
//   (3) what is left of its address space (ulimit -v)
//
// root: where /proc and /sys are.
std::uint64_t free_memory(const std::filesystem::path& root = "/");

}  // namespace hottel
