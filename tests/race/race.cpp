// A data race on purpose: tools/sanitize thread must see it, or it sees none at all.
#include <cstdio>

#include "kernel/parallel.h"

int main() {
  const hottel::ThreadLimit limit(2);
  long sum = 0;
  // Often enough that both threads work at once in some round, however busy the machine is.
  for (int round = 0; round < 1000; ++round)
    hottel::parallel_for(
        100'000, [&sum](std::size_t k) { sum += static_cast<long>(k); }, 100);
  std::printf("%ld\n", sum);
}
