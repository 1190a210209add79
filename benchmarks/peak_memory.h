// How much memory a piece of work took at its peak.
#pragma once

#include <malloc.h>
#ifdef HOTTEL_JEMALLOC
#include <jemalloc/jemalloc.h>
#endif

#include <fstream>
#include <string>

namespace hottel::benchmarks {

// Measures the growth of the resident set from its construction to its peak, in bytes.
// REQUIRES Linux with /proc; elsewhere growth() is 0.
class PeakMemory {
 public:
  PeakMemory() {
    give_back();  // what was freed before must not be found again unnoticed
    std::ofstream("/proc/self/clear_refs") << 5;
    start_ = kilobytes("VmRSS:");
  }

  double growth() const { return 1024 * (kilobytes("VmHWM:") - start_); }

 private:
  static void give_back() {
#ifdef HOTTEL_JEMALLOC
    mallctl(("arena." + std::to_string(MALLCTL_ARENAS_ALL) + ".purge").c_str(), nullptr, nullptr, nullptr, 0);
#else
    malloc_trim(0);
#endif
  }

  static double kilobytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (double value = 0; word == key && status >> value) return value;
    return 0;
  }

  double start_ = 0;
};

}  // namespace hottel::benchmarks
