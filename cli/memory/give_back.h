// Whether the program keeps memory that was freed.
#pragma once

#ifdef HOTTEL_JEMALLOC
#include <jemalloc/jemalloc.h>
#endif

#include <sys/types.h>

#include <string>

namespace hottel {

// From now on memory that was freed goes back to the system within a tenth of a second, not within a minute
// (large_pages.cpp): slower, and what the system sees is what is needed. For runs that were told how much they may
// take.
inline void give_memory_back_soon() {
#ifdef HOTTEL_JEMALLOC
  ssize_t soon = 100;                                                       // milliseconds
  mallctl("arenas.dirty_decay_ms", nullptr, nullptr, &soon, sizeof(soon));  // of arenas to come
  unsigned arenas = 0;
  std::size_t size = sizeof(arenas);
  if (mallctl("arenas.narenas", &arenas, &size, nullptr, 0) != 0) return;
  for (unsigned k = 0; k < arenas; ++k)  // those that are not there refuse
    mallctl(("arena." + std::to_string(k) + ".dirty_decay_ms").c_str(), nullptr, nullptr, &soon, sizeof(soon));
#endif
}

}  // namespace hottel
