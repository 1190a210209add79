// Work on many points, part by part, so that it can be told of and ended.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "kernel/support/stage.h"

namespace hottel::python {

// Calls work(first, end) for parts of [0, n), one after the other, and tells of them. A part is as large as takes about
// a twentieth of a second, so that threads seldom wait for each other and who waits may end it soon.
template <class Work>
void in_parts(std::size_t n, const char* stage, const StageProgress& progress, const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kMost = 65536;
  std::size_t part = 16;
  for (std::size_t first = 0; first < n;) {
    const std::size_t end = std::min(n, first + part);
    const auto begin = Clock::now();
    work(first, end);
    progress(stage, static_cast<double>(end) / static_cast<double>(n));
    if (Clock::now() - begin < std::chrono::milliseconds(25)) part = std::min(2 * part, kMost);
    first = end;
  }
}

}  // namespace hottel::python
