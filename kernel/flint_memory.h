#pragma once

namespace hottel {

// Sees to it that the memory FLINT pools for the calling thread is given back when that thread ends: to be called on a
// thread before its first use of FLINT or Arb there. Calling it again does nothing. Cost: one look at a variable of the
// thread.
void return_flint_memory_at_thread_end();

}  // namespace hottel
