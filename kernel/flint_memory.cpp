#include "kernel/flint_memory.h"

#include <flint.h>

namespace hottel {
namespace {

// FLINT keeps pools of memory for each thread and wants to be told when a thread ends.
struct ThreadPools {
  void use() {}
  ~ThreadPools() { flint_cleanup(); }
};
thread_local ThreadPools pools;

}  // namespace

void return_flint_memory_at_thread_end() { pools.use(); }

}  // namespace hottel
