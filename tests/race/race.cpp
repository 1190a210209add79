// A data race on purpose: tools/sanitize thread must see it, or it sees none at all.
#include <cstdio>

#include "kernel/parallel.h"

int main() {
  const hottel::ThreadLimit limit(2);
  long sum = 0;
  hottel::parallel_for(
      1'000'000, [&sum](std::size_t k) { sum += static_cast<long>(k); }, 1000);
  std::printf("%ld\n", sum);
}
